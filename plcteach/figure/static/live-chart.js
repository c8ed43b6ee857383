// Knows how to draw the timing chart that grows while a program runs: rows, a grid, and a cursor that can be moved.

import { button, h, say, svgEl } from "./ui.js";
import { bitPath, gridStep, stretches, timeWords, valueAt } from "./live-shape.js";

const CHART_WORDS = {
  chart: { zh: "时序图", en: "Timing chart" },
  closer: { zh: "时间放大", en: "Shorter stretch of time" },
  wider: { zh: "时间缩小", en: "Longer stretch of time" },
};
const SPANS = [500, 1000, 2000, 5000, 10000, 30000, 60000, 300000];
const [NAMES, ROW, HIGH, HEAD] = [74, 26, 15, 18];
const USUAL_WIDTH = 640;

/** An empty chart. `onMoment(ms)` is called when the reader points at a moment and presses. */
export function makeLiveChart(onMoment) {
  const svg = svgEl("svg", { className: "plc-live-chart", role: "img" });
  const tools = h("div", { className: "plc-live-zoom" });
  const node = h("div", { className: "plc-live-charted" }, tools, svg);
  const view = { node, svg, tools, rows: [], span: 3, lang: "zh", shown: null, onMoment };
  const momentOf = (event) => {
    const box = svg.getBoundingClientRect();
    const { start, stop, width } = view.shown ?? { start: 0, stop: 0, width: 1 };
    const x = event.clientX - box.left;
    return x < NAMES ? null : start + ((x - NAMES) / width) * (stop - start);
  };
  svg.addEventListener("pointerdown", (event) => {
    const ms = momentOf(event);
    if (ms !== null) view.onMoment(ms);
  });
  return view;
}

/** Names the rows: [address, whether it is a word]. */
export function buildLiveChart(view, rows, lang) {
  const zoom = (by) => () => {
    view.span = Math.max(0, Math.min(SPANS.length - 1, view.span + by));
    if (view.last) drawLiveChart(view, view.last);
  };
  Object.assign(view, { rows, lang });
  view.svg.setAttribute("height", HEAD + rows.length * ROW + 4);
  view.tools.replaceChildren(
    button({ icon: "minus", label: say(CHART_WORDS.wider, lang), onclick: zoom(1) }),
    button({ icon: "plus", label: say(CHART_WORDS.closer, lang), onclick: zoom(-1) }),
  );
}

/** Draws what is known around a moment: up to it while the program runs, to both sides when it is looked back at. */
export function drawLiveChart(view, { tracks, now, end }) {
  view.last = { tracks, now, end };
  const span = SPANS[view.span];
  const stop = Math.max(span, now === end ? end : Math.min(end, now + span / 2));
  const width = (view.svg.clientWidth || USUAL_WIDTH) - NAMES - 2;
  const shown = { start: stop - span, stop, until: end, x: NAMES, width };
  view.shown = shown;
  const place = (ms) => NAMES + ((ms - shown.start) / span) * shown.width;
  const parts = [...gridLines(shown, view.rows.length, place)];
  view.rows.forEach(([address, word], at) => parts.push(...chartRow(tracks[address], address, word, HEAD + at * ROW, { ...shown, now })));
  parts.push(svgEl("line", { className: "plc-live-cursor", x1: place(now), x2: place(now), y1: HEAD - 4, y2: HEAD + view.rows.length * ROW }));
  view.svg.replaceChildren(...parts);
  const values = view.rows.map(([address]) => `${address} ${valueAt(tracks[address], now)}`).join(", ");
  view.svg.setAttribute("aria-label", `${say(CHART_WORDS.chart, view.lang)}, ${timeWords(now)}: ${values}`);
}

/** The lines of the time grid and the times above them. */
function* gridLines({ start, stop }, rows, place) {
  const step = gridStep(stop - start);
  for (let ms = Math.ceil(start / step) * step; ms <= stop; ms += step) {
    yield svgEl("line", { className: "plc-live-grid", x1: place(ms), x2: place(ms), y1: HEAD - 3, y2: HEAD + rows * ROW });
    yield svgEl("text", { className: "plc-live-time", x: place(ms), y: 11, "text-anchor": ms + step > stop ? "end" : "middle" }, `${ms / 1000}`);
  }
}

/** One row: its name, its value at the cursor, and its line or numbers. */
function* chartRow(changes, address, word, top, shown) {
  const base = top + ROW - 7;
  yield svgEl("text", { className: "plc-live-name", x: NAMES - 6, y: base, "text-anchor": "end" }, address);
  if (!word) {
    yield svgEl("path", { className: "plc-live-line", d: bitPath(changes, { ...shown, top: base - HIGH + 3, height: HIGH - 3 }) });
    return;
  }
  const place = (ms) => shown.x + ((ms - shown.start) / (shown.stop - shown.start)) * shown.width;
  for (const [from, to, value] of stretches(changes, shown.start, Math.min(shown.stop, shown.until))) {
    const [left, right] = [place(from), place(to)];
    yield svgEl("path", { className: "plc-live-word", d: `M${left},${base - HIGH}H${right}V${base + 2}H${left}Z` });
    if (right - left > 9 * value.length) yield svgEl("text", { className: "plc-live-number", x: (left + right) / 2, y: base - 2, "text-anchor": "middle" }, value);
  }
}
