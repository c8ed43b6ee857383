// Knows how an answer that is no typed list is written as a text and read back: lines in order, a grid, blocks, a choice; no DOM.

/** The signs of a grid's cells, in the order in which a press goes through them. */
const CELL_SIGNS = { predict: [".", "0", "1", "x"], chart: [".", "1", "0"] };
/** A cell that nobody has filled in yet. */
export const EMPTY_CELL = ".";

/** Gives the signs that a cell of this kind of grid can hold, the empty one first. */
export function cellSigns(kind) {
  return CELL_SIGNS[kind] || CELL_SIGNS.predict;
}

/** Gives the sign after another, round and round. */
export function nextSign(kind, sign) {
  const signs = cellSigns(kind);
  return signs[(signs.indexOf(sign) + 1) % signs.length]; // a sign that is not among them goes back to the first
}

/** Gives a line as it is compared: one blank between its words, capitals only. */
function plainLine(text) {
  return text.trim().replace(/\s+/g, " ").toUpperCase();
}

/**
 * Finds the lines of an answer among those that are offered, each at most as often as it is offered.
 * @param {string} text @param {string[]} offered
 * @returns {{used: {text: string, at: number}[], tray: number[]}}  at: its place among the offered, -1 for a line of one's own
 */
export function orderedLines(text, offered) {
  const tray = offered.map((_, at) => at);
  const used = text.split("\n").filter((line) => line.trim()).map((line) => {
    const found = tray.findIndex((at) => plainLine(offered[at]) === plainLine(line));
    const at = found < 0 ? -1 : tray.splice(found, 1)[0];
    return { text: at < 0 ? line.trim() : offered[at], at };
  });
  return { used, tray };
}

/** Writes lines in order as an answer. */
export function orderText(used) {
  return used.map(({ text }) => `${text}\n`).join("");
}

/** Gives a list with one entry moved to another place; the ends stay ends. */
export function movedEntry(list, from, to) {
  const left = list.filter((_, at) => at !== from);
  const place = Math.min(Math.max(0, to), left.length);
  return [...left.slice(0, place), list[from], ...left.slice(place)];
}

/** Gives the place into which something falls that is let go at a height, between lines whose middles are given. */
export function placeAmong(middles, y) {
  return middles.filter((middle) => middle < y).length;
}

/** Reads the signs of one row of a grid, which may be parted by blanks or not, and fills it up to its length. */
function signsOf(words, count) {
  const known = CELL_SIGNS.predict;
  const same = { _: "0", "#": "1", "?": EMPTY_CELL, X: "x" };
  const signs = Array.from(words.replace(/\s+/g, "")).map((sign) => same[sign] ?? sign);
  return Array.from({ length: count }, (_, at) => (known.includes(signs[at]) ? signs[at] : EMPTY_CELL));
}

/** Gives the row of a chart's answer that names an address, without the name. */
function namedRow(lines, name) {
  const line = lines.find((one) => plainLine(one).split(" ")[0].replace(/[:=]$/, "") === plainLine(name));
  return line ? line.trim().slice(line.trim().split(/\s+/)[0].length) : "";
}

/**
 * Reads a grid: a prediction has one line an instruction, a chart one line an output, which begins with its name.
 * @param {string} text @param {{kind: string, rows: string[], columns: string[]}} task @returns {string[][]}
 */
export function gridCells(text, { kind, rows, columns }) {
  const lines = text.split("\n");
  return rows.map((name, at) => signsOf(kind === "chart" ? namedRow(lines, name) : lines[at] || "", columns.length));
}

/** Writes a grid as an answer: the signs of a chart in groups that the eye can count, as Python writes them. */
export function gridText(cells, { kind, rows }) {
  const grouped = (row) => row.join("").replace(/(.{5})(?=.)/g, "$1 ");
  if (kind === "chart") return cells.map((row, at) => `${rows[at]} ${grouped(row)}\n`).join("");
  return cells.map((row) => `${row.join(" ")}\n`).join("");
}

/** Gives a grid with one cell changed. */
export function withCell(cells, row, column, sign) {
  return cells.map((one, r) => (r === row ? one.map((old, c) => (c === column ? sign : old)) : one));
}

/** Gives what a verdict tells of a grid: the rows with a wrong cell, the others, and the cells; nothing where it names no cell. */
export function marksOfVerdict({ status, wrong = [] }, rows) {
  if (status === "error" || (status !== "equal" && !wrong.length)) return {};
  const bad = new Set(wrong.map(([row]) => row));
  return { rows: Array.from({ length: rows }, (_, row) => (bad.has(row) ? "wrong" : "right")), cells: wrong };
}

/** Gives the cell a key leads to from another, staying inside the grid; null for any other key. */
export function cellAfterKey(key, row, column, rows, columns) {
  const steps = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1], Home: [0, -columns], End: [0, columns] };
  if (!steps[key]) return null;
  const inside = (at, count) => Math.min(Math.max(0, at), count - 1);
  return [inside(row + steps[key][0], rows), inside(column + steps[key][1], columns)];
}

/** Gives the sign that a key writes into a cell of this kind; null for any other key. */
export function signOfKey(key, kind) {
  if (["Backspace", "Delete", "."].includes(key)) return EMPTY_CELL;
  const sign = key === "X" ? "x" : key;
  return cellSigns(kind).includes(sign) ? sign : null;
}

/** Reads the ends of blocks, as far as they have been chosen: `1-2 3-4` is four numbers, at most. */
export function blockEnds(text, count) {
  return (text.match(/\d+/g) || []).map(Number).filter((at) => at >= 1 && at <= count).slice(0, 4);
}

/** Writes the ends of blocks: the first and last instruction of each, as many as have been chosen. */
export function blockText(ends) {
  const pairs = [ends.slice(0, 2), ends.slice(2, 4)].filter((pair) => pair.length);
  return pairs.map((pair) => (pair.length === 2 ? [...pair].sort((a, b) => a - b) : pair).join("-")).join(" ");
}

/** Gives the block, 1 or 2, in which an instruction stands; 0 for none. */
export function blockOf(ends, at) {
  const inside = (pair) => pair.length > 0 && at >= Math.min(...pair) && at <= Math.max(...pair);
  if (inside(ends.slice(0, 2))) return 1;
  return inside(ends.slice(2, 4)) ? 2 : 0;
}

/** Gives the ends after one more instruction has been chosen; a fifth begins anew. */
export function withEnd(ends, at) {
  return ends.length < 4 ? [...ends, at] : [at];
}

/** Gives which of some choices an answer names, by its letter or its number; -1 for none. */
export function choiceOf(text, count) {
  const word = text.trim().toUpperCase();
  const at = /^[A-Z]$/.test(word) ? word.charCodeAt(0) - 65 : /^\d+$/.test(word) ? Number(word) - 1 : -1;
  return at < count ? at : -1;
}

/** Gives the letter of a choice. */
export function choiceLetter(at) {
  return String.fromCharCode(65 + at);
}

/**
 * Keeps what an answer was, so that it can be taken back.
 * @param {number} most  how many steps back there are
 */
export function makeHistory(most = 200) {
  const kept = [];
  return {
    keep: (text) => (kept.push(text), kept.length > most && kept.shift()),
    back: () => kept.pop(),
    some: () => kept.length > 0,
  };
}
