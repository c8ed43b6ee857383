// Knows what a live bench keeps of what the kernel told it, and how a chart is laid out in time; numbers and words, no DOM.

/** How long a pull may cover at most, in ms of virtual time: after a pause of the page nothing is rushed through. */
export const MOST_MS = 500;

/** How fast virtual time runs, by choice. */
export const PACES = [0.02, 0.1, 0.5, 1, 5, 20];

/** What the page knows before the kernel has said anything. */
export function freshNews() {
  return { lines: [], lit: [], bits: {}, words: {}, faces: {}, forced: [], found: [], held: [], tape: null, plant: null, scan: -1, now: 0, end: 0, scans: 0, first: 0, tracks: {} };
}

/** Puts what has changed into what is known; faces one by one, changes of the chart behind those that were there. */
export function takeBatch(known, batch) {
  const faces = batch.faces ? { ...known.faces, ...batch.faces } : known.faces;
  const tracks = batch.anew ? {} : known.tracks;
  for (const [row, changes] of Object.entries(batch.chart ?? {})) (tracks[row] ??= []).push(...changes);
  return { ...known, ...batch, faces, tracks };
}

/** Leaves out what happened before a moment, but for the last value before it. */
export function trimTracks(tracks, since) {
  for (const changes of Object.values(tracks)) {
    const from = changes.findLastIndex(([ms]) => ms <= since);
    if (from > 0) changes.splice(0, from);
  }
}

/** The value of a row at a moment; an empty text where nothing is known. */
export function valueAt(changes, ms) {
  const at = (changes ?? []).findLastIndex(([when]) => when <= ms);
  return at < 0 ? "" : String(changes[at][1]);
}

/** The stretches of a row within a window: [from, to, value]. */
export function stretches(changes, start, stop) {
  const found = [];
  const first = Math.max(0, (changes ?? []).findLastIndex(([ms]) => ms <= start));
  for (let at = first; at < (changes?.length ?? 0); at += 1) {
    const [ms, value] = changes[at];
    if (ms >= stop) break;
    const end = Math.min(stop, changes[at + 1]?.[0] ?? stop);
    if (end > start) found.push([Math.max(ms, start), end, String(value)]);
  }
  return found;
}

/**
 * The line of a bit in a window as an SVG path: high for 1, low for 0, in the middle for what nobody knows. What has not run yet
 * (from `until` on) is left empty.
 */
export function bitPath(changes, { start, stop, until = stop, x, width, top, height }) {
  const place = (ms) => round2(x + ((ms - start) / (stop - start)) * width);
  const level = { 1: top, 0: top + height };
  let path = "";
  for (const [from, to, value] of stretches(changes, start, Math.min(stop, until))) {
    const y = round2(level[value] ?? top + height / 2);
    path += `${path ? "L" : "M"}${place(from)},${y}L${place(to)},${y}`;
  }
  return path;
}

/** Two decimals are enough for a place on the paper. */
function round2(number) {
  return Math.round(number * 100) / 100;
}

/** A step of the time grid: about so many lines in a window, at round numbers of ms. */
export function gridStep(span, lines = 6) {
  const rough = span / lines;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((times) => times * power).find((step) => step >= rough);
}

/** A moment in words: seconds with as many decimals as a scan of 10 ms needs. */
export function timeWords(ms) {
  return `${(ms / 1000).toFixed(2)} s`;
}
