// Knows how to draw the instruction list, to mark its current line and to keep it in sight; lines are only text here.

import { h, say } from "./ui.js";
import { headWidth, splitLine } from "./film.js";

/** From this many lines on, the browser lays out only the lines in sight. */
const LONG_LIST = 200;
const LIST_WORDS = {
  list: { zh: "程序", en: "Program" },
  breakpoint: { zh: "断点：播放到第 {} 行停下", en: "Breakpoint: play stops at line {}" },
};

/**
 * An empty list. `onLine(line)` is called when a line is chosen, `onBreak(line, on)` when a breakpoint comes or goes,
 * `onPoint(line)` when a line is pointed at (null: none any more).
 */
export function makeListView(onLine, onBreak, onPoint) {
  const scroller = h("div", { className: "plc-list-scroller" });
  const node = h("div", { className: "plc-list" }, scroller);
  const view = { node, scroller, rows: [], current: null, asked: null, linked: [], onLine, onBreak };
  const lineOf = (target) => Number(target.closest?.(".plc-line")?.dataset.line ?? NaN);
  const point = (line) => onPoint?.(Number.isNaN(line) ? null : line);
  scroller.addEventListener("pointerover", (event) => point(lineOf(event.target)));
  scroller.addEventListener("pointerleave", () => point(NaN));
  scroller.addEventListener("focusin", (event) => point(lineOf(event.target)));
  scroller.addEventListener("focusout", () => point(NaN));
  scroller.addEventListener("click", (event) => chooseLine(view, event.target));
  scroller.addEventListener("keydown", (event) => walkLines(view, event));
  return view;
}

/** Draws all lines of a film, once. */
export function buildList(view, film, lang, breakpoints) {
  Object.assign(view, { rows: [], current: null, asked: null, linked: [] });
  view.scroller.style.setProperty("--plc-head", `${headWidth(film)}ch`);
  view.scroller.classList.toggle("plc-long", film.lines.length > LONG_LIST);
  const networks = film.networks?.length ? film.networks : [{ title: "", first: 0 }];
  view.scroller.replaceChildren(...networks.map((network, at) => {
    const end = networks[at + 1]?.first ?? film.lines.length;
    return networkSection(view, film, network, end, { lang, breakpoints });
  }));
  if (view.rows.length) rove(view, 0);
}

/** One network: its title and its lines. */
function networkSection(view, film, network, end, words) {
  const list = h("ol", { className: "plc-lines", "aria-label": network.title || say(LIST_WORDS.list, words.lang) });
  for (let line = network.first; line < end; line += 1) {
    const row = lineRow(film.lines[line], line, words);
    view.rows[line] = row;
    list.append(row);
  }
  const title = network.title && h("div", { className: "plc-network" }, network.title);
  return h("div", { className: "plc-section" }, title, list);
}

/** One line: the gutter for a breakpoint, the number, the instruction and its comment. */
function lineRow(line, at, { lang, breakpoints }) {
  const number = line.number || line.row || at + 1;
  const { head, rest } = splitLine(line.text);
  const label = say(LIST_WORDS.breakpoint, lang).replace("{}", number);
  const code = h("span", { className: "plc-code" }, h("span", { className: "plc-head" }, head), rest ? ` ${rest}` : "");
  const comment = line.comment && [" ", h("span", { className: "plc-comment" }, line.comment)];
  return h(
    "li", { className: "plc-line", dataset: { line: at } },
    h("button", {
      type: "button", className: "plc-break", tabindex: -1, title: label, "aria-label": label,
      "aria-pressed": breakpoints.has(at),
    }),
    h(
      "button", { type: "button", className: "plc-go", tabindex: -1 },
      h("span", { className: "plc-number" }, String(number)), " ",
      h("span", { className: "plc-words" }, code, comment),
    ),
  );
}

/** A click in the gutter sets a breakpoint, a click on the line goes there. */
function chooseLine(view, target) {
  const row = target.closest?.(".plc-line");
  if (!row) return;
  const line = Number(row.dataset.line);
  const gutter = target.closest(".plc-break");
  if (!gutter) return view.onLine(line);
  const on = gutter.getAttribute("aria-pressed") !== "true";
  gutter.setAttribute("aria-pressed", String(on));
  view.onBreak(line, on);
}

/** Up and down walk through the lines without going there; Enter or Space then does. */
function walkLines(view, event) {
  const way = { ArrowUp: -1, ArrowDown: 1 }[event.key];
  const row = event.target.closest?.(".plc-line");
  if (!way || !row) return;
  event.preventDefault();
  const line = Math.max(0, Math.min(view.rows.length - 1, Number(row.dataset.line) + way));
  const part = event.target.closest(".plc-break") ? ".plc-break" : ".plc-go";
  rove(view, line);
  view.rows[line].querySelector(part).focus();
}

/** Makes one line the only one that Tab stops at. */
function rove(view, line) {
  for (const [row, index] of [[view.tabRow, -1], [view.rows[line], 0]]) {
    for (const part of row?.children ?? []) part.tabIndex = index;
  }
  view.tabRow = view.rows[line];
}

/** Marks the lines that belong to what is pointed at elsewhere. */
export function linkLines(view, lines) {
  for (const row of view.linked) row.classList.remove("plc-line-linked");
  view.linked = lines.map((line) => view.rows[line]).filter(Boolean);
  for (const row of view.linked) row.classList.add("plc-line-linked");
}

/** Marks the line that has just been executed (-1: none) and the one that is asked about (-1: none). */
export function markLines(view, line, asked = -1) {
  const [row, askedRow] = [view.rows[line] ?? null, view.rows[asked] ?? null];
  const scroll = scrollFor(view, askedRow ?? row ?? view.rows[0]);
  if (view.asked !== askedRow) {
    view.asked?.classList.remove("plc-line-asked");
    askedRow?.classList.add("plc-line-asked");
    view.asked = askedRow;
  }
  if (view.current !== row) {
    view.current?.removeAttribute("aria-current");
    row?.setAttribute("aria-current", "step");
    view.current = row;
    if (row && !view.scroller.contains(document.activeElement)) rove(view, line);
  }
  if (scroll !== null) view.scroller.scrollTop = scroll;
}

/** Where to scroll the list (never the page) so that a line can be seen with its neighbours; null: nowhere. */
function scrollFor({ scroller }, row) {
  if (!row || scroller.scrollHeight <= scroller.clientHeight) return null;
  const [top, height] = [row.offsetTop, row.offsetHeight];
  const above = top - 1.5 * height < scroller.scrollTop;
  const below = top + 2.5 * height > scroller.scrollTop + scroller.clientHeight;
  return above || below ? Math.max(0, top - scroller.clientHeight / 2 + height) : null;
}
