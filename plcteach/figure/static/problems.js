// Knows where each diagnostic stands in a text: which rows, which columns, in which order; draws nothing.

/**
 * @typedef {{zh?: string, en?: string}} Text
 * @typedef {{text: Text, row?: number, start?: number, stop?: number}} Remark
 * @typedef {{code: string, severity: "error"|"warning"|"info", row: number, start: number, stop: number,
 *   text: Text, notes?: Remark[], fix?: Text}} Diagnostic
 * @typedef {Diagnostic & {near: Remark[]}} Placed  a diagnostic with the notes that stand beside it
 * @typedef {{problems: Placed[], remarks: (Remark & {code: string})[]}} RowOfProblems
 */

const SEVERITY_ORDER = ["error", "warning", "info"];

/** Gives the known severity; a word from a later version counts as information. */
export function severityOf(diagnostic) {
  return SEVERITY_ORDER.includes(diagnostic.severity) ? diagnostic.severity : "info";
}

/** Turns a column counted in code points (as Python does) into one counted in UTF-16 units (as browsers do). */
export function utf16Column(line, column) {
  let at = 0;
  for (let left = column; left > 0 && at < line.length; left -= 1) {
    at += line.codePointAt(at) > 0xffff ? 2 : 1;
  }
  return at;
}

/** Gives the marked stretch of a line in UTF-16 units, kept inside the line; empty where nothing stands. */
export function markedRange(line, start = 0, stop = start) {
  const from = utf16Column(line, Math.max(0, start));
  return [from, Math.max(from, utf16Column(line, stop))];
}

/** Gives the row on which something is drawn: 0 (the whole program) or a row that exists. */
export function drawnRow(row, rowCount) {
  return Math.min(Math.max(0, Math.trunc(row) || 0), Math.max(1, rowCount));
}

/** Sorts what stands under one line: the gravest first, then from left to right. */
function inReadingOrder(a, b) {
  const grave = SEVERITY_ORDER.indexOf(severityOf(a)) - SEVERITY_ORDER.indexOf(severityOf(b));
  return grave || (a.start || 0) - (b.start || 0);
}

/**
 * Lays diagnostics out by row. A note about another row stands quietly under that row, any other note stays
 * with its diagnostic.
 * @param {Diagnostic[]} list @param {number} rowCount @returns {Map<number, RowOfProblems>}
 */
export function placeProblems(list, rowCount) {
  const rows = new Map();
  const at = (row) => {
    if (!rows.has(row)) rows.set(row, { problems: [], remarks: [] });
    return rows.get(row);
  };
  for (const diagnostic of [...list].sort(inReadingOrder)) {
    const row = drawnRow(diagnostic.row, rowCount);
    const away = (note) => note.row > 0 && drawnRow(note.row, rowCount) !== row;
    const notes = diagnostic.notes || [];
    at(row).problems.push({ ...diagnostic, near: notes.filter((note) => !away(note)) });
    for (const note of notes.filter(away)) {
      at(drawnRow(note.row, rowCount)).remarks.push({ ...note, code: diagnostic.code });
    }
  }
  return new Map([...rows].sort(([a], [b]) => a - b));
}

/** Counts diagnostics by severity. @param {Diagnostic[]} list */
export function countProblems(list) {
  const count = { error: 0, warning: 0, info: 0 };
  for (const diagnostic of list) count[severityOf(diagnostic)] += 1;
  return count;
}

/** Gives a text with line feeds only, as files from every system are read. */
export function plainLines(text) {
  return String(text ?? "").replace(/\r\n?/g, "\n");
}

/** Gives the smallest single replacement that turns one text into another, or null when they are the same. */
export function changeBetween(before, after) {
  if (before === after) return null;
  const most = Math.min(before.length, after.length);
  let head = 0;
  while (head < most && before[head] === after[head]) head += 1;
  let tail = 0;
  while (tail < most - head && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail += 1;
  return { from: head, to: before.length - tail, insert: after.slice(head, after.length - tail) };
}

/** Gives how many spaces lead from a column to the next stop. */
export function spacesToStop(column, width = 4) {
  return width - (column % width);
}

/** Gives how many spaces before a place go away, so that it falls back to the stop before it. */
export function spacesToDrop(before, width = 4) {
  const spaces = / *$/.exec(before)[0].length;
  return Math.min(spaces, before.length % width || width);
}

/**
 * Gathers many small changes into few messages: tells `pause` ms after the last touch, and never while
 * `busy()` (an input method is still composing).
 * @param {{tell: () => void, busy?: () => boolean, pause?: number}} options
 */
export function createTeller({ tell, busy = () => false, pause = 250 }) {
  let timer = 0;
  const tellNow = () => {
    clearTimeout(timer);
    timer = 0;
    tell();
  };
  const later = () => (busy() ? touch() : tellNow());
  const touch = () => {
    clearTimeout(timer);
    timer = setTimeout(later, pause);
  };
  const stop = () => {
    clearTimeout(timer);
    timer = 0;
  };
  return { touch, stop, flush: () => (timer ? tellNow() : undefined), pending: () => timer !== 0 };
}
