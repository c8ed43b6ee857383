// Knows how to read a Film: cells, lines, questions, and the words for a stack; pure functions, no DOM, no PLC logic.

import { say } from "./ui.js";

/**
 * @typedef {import("./ui.js").Text} Text
 * @typedef {{id: string, title: Text, register?: Text, depth: number, drawn: number, fixed?: boolean}} Column
 * @typedef {{key: string, column: number, position: number, value: "0"|"1"|"x", formula: string, name: string,
 *   spent: boolean, foreign: boolean, unused: boolean, tag: ""|"L"|"B"}} Cell
 * @typedef {{line: number, scan: number, cells: Array<Array<string|number>>, from?: Object<string, string[]>,
 *   enter?: Object<string, string>, leave?: Object<string, string>, changed?: string[],
 *   read?: string[][], write?: string[][], say?: Text, warn?: Text,
 *   faces?: Object<string, Object<string, *>>}} Step
 * @typedef {{title: Text, digest: string, lines: Array<{text: string, comment?: string, row: number, network: number}>,
 *   networks: Array<{title: string, first: number}>, columns: Column[], texts: string[], steps: Step[],
 *   faces?: import("./block-shape.js").BlockFace[]}} Film
 */

const FILM_WORDS = {
  before: { zh: "程序开始之前", en: "before the first instruction" },
  after: { zh: "执行 {} 之后", en: "after {}" },
  step: { zh: "第 {i} 步，共 {n} 步", en: "Step {i} of {n}" },
  stack: { zh: "{}，从栈顶到栈底：", en: "{}, from top to bottom: " },
  empty: { zh: "空", en: "empty" },
  level: { zh: ["第", "层"], en: ["level ", ""] },
  spent: { zh: "已用过", en: "used" },
  foreign: { zh: "别的网络留下的", en: "left by another network" },
  B: { zh: "分支点", en: "branch point" },
  L: { zh: "电路块", en: "block" },
};

const LONGEST_LABEL = 160;

/** Takes a Film as JSON text or as an object; an empty text is no film. @returns {Film|null} */
export function readFilm(source) {
  const film = typeof source === "string" ? (source ? JSON.parse(source) : null) : source;
  return film && film.steps && film.steps.length ? film : null;
}

/** The index of the last step. */
export function lastIndex(film) {
  return film.steps.length - 1;
}

/** The nearest step that exists. */
export function clampIndex(film, index) {
  const whole = Math.round(Number(index)) || 0;
  return Math.max(0, Math.min(lastIndex(film), whole));
}

/** One cell of a step with its names instead of places in an array. @returns {Cell} */
export function cellOf(film, [key, column, position, value, formula, name, flags = ""]) {
  return {
    key, column, position, value,
    formula: film.texts[formula] ?? "",
    name: film.texts[name] ?? "",
    spent: flags.includes("s"),
    foreign: flags.includes("f"),
    unused: flags.includes("u"),
    tag: flags.includes("L") ? "L" : flags.includes("B") ? "B" : "",
  };
}

/** All cells of one step; the bit that is being written looks used only from the next step on. @returns {Cell[]} */
export function cellsAt(film, index) {
  const { cells, write } = film.steps[index];
  const inUse = (cell) => write?.length > 0 && cell.column === 0 && cell.position === 0;
  return cells.map((row) => cellOf(film, row)).map((cell) => (inUse(cell) ? { ...cell, spent: false } : cell));
}

const FACES_OF = new WeakMap();

/**
 * What every function block shows at a step; none for a film without blocks. A face that has not changed since the step
 * before is the same object, and so is the whole list. @returns {import("./block-shape.js").BlockFace[]}
 */
export function facesAt(film, index) {
  if (!film.faces?.length) return [];
  const known = FACES_OF.get(film) ?? [changedFaces(film.faces, film.steps[0].faces)];
  FACES_OF.set(film, known);
  for (let at = known.length; at <= index; at += 1) known.push(changedFaces(known[at - 1], film.steps[at].faces));
  return known[index];
}

/** Faces with some of their keys changed; a key that comes as null is gone. */
function changedFaces(faces, changes) {
  if (!changes) return faces;
  return faces.map((face) => {
    const own = changes[face.address];
    if (!own) return face;
    return Object.fromEntries(Object.entries({ ...face, ...own }).filter(([, value]) => value !== null));
  });
}

/** The letters on cells that a film shows anywhere, each with its word. @returns {[string, string][]} */
export function tagsOf(film, lang) {
  const shown = (tag) => film.steps.some((step) => step.cells.some((cell) => cell[6]?.includes(tag)));
  return ["B", "L"].filter(shown).map((tag) => [tag, say(FILM_WORDS[tag], lang)]);
}

/** The cell at position 0 of the first column, or undefined while that column is empty. */
export function topAt(film, index) {
  const row = film.steps[index].cells.find((cell) => cell[1] === 0 && cell[2] === 0);
  return row && cellOf(film, row);
}

/**
 * Whether an instruction writes the top of the first column: another cell stands there, or the same one with another
 * value or formula. The formula counts so that a question does not betray that the value changes.
 */
export function writesTop(film, index) {
  if (index < 1 || index > lastIndex(film) || film.steps[index].line < 0) return false;
  const [before, top] = [topAt(film, index - 1), topAt(film, index)];
  if (!top) return false;
  const changed = film.steps[index].changed ?? [];
  return changed.includes(top.key) || before?.key !== top.key || before.formula !== top.formula;
}

/** The text of the line that a step has executed; empty before the first. */
export function lineTextAt(film, index) {
  return film.lines[film.steps[index].line]?.text ?? "";
}

/** The first step of a line: in the scan that is on screen if it comes there, else in the whole film; -1 if never. */
export function stepOfLine(film, line, near = 0) {
  const { scan } = film.steps[near];
  const here = film.steps.findIndex((step) => step.line === line && step.scan === scan);
  return here >= 0 ? here : film.steps.findIndex((step) => step.line === line);
}

/** Splits an instruction for setting in two columns: its first word, and the rest. */
export function splitLine(text) {
  const [, head, rest] = /^\s*(\S*)\s*(.*?)\s*$/su.exec(text);
  return { head, rest };
}

/** The width in characters that the first words of a list need, kept between 3 and 8. */
export function headWidth(film) {
  const widest = film.lines.reduce((most, line) => Math.max(most, splitLine(line.text).head.length), 0);
  return Math.max(3, Math.min(8, widest));
}

/** What a step read and wrote, ready for small chips. */
export function chipsAt(film, index) {
  const step = film.steps[index];
  const chip = (kind, sign) => ([address, value]) => ({ kind, address, value, text: `${address} ${sign} ${value}` });
  return [...(step.read ?? []).map(chip("read", "=")), ...(step.write ?? []).map(chip("write", ":="))];
}

/** How many scans a film shows. */
export function scanCount(film) {
  return film.steps[lastIndex(film)].scan - film.steps[0].scan + 1;
}

/** The number of the level at a position: 1 below a register or at the top, 0 for the register itself. */
export function levelOf(column, position) {
  return column.register ? position : position + 1;
}

/** The words around the number of a level: 第…层, level …. @returns {[string, string]} */
export function levelWords(lang) {
  return FILM_WORDS.level[lang];
}

/** What a position is called: level 1, 第1层, or the name of the register. */
export function positionName(column, position, lang) {
  const level = levelOf(column, position);
  if (level === 0) return say(column.register, lang);
  const [before, after] = levelWords(lang);
  return `${before}${level}${after}`;
}

/** What the small marks on a cell mean, in words. @param {Cell} cell */
export function cellMarks(cell, lang) {
  return ["tag", "spent", "foreign"]
    .filter((mark) => cell[mark])
    .map((mark) => say(FILM_WORDS[mark === "tag" ? cell.tag : mark], lang));
}

/** A cell in one line: its name, formula and value as far as they are wanted, and its marks. */
export function describeCell(cell, lang, { formulas = false, names = false } = {}) {
  const words = [cell.value];
  if (names && cell.name) words.unshift(`${cell.name} =`);
  const telling = formulas && cell.formula !== cell.value;
  if (telling && cell.formula) words.push(`= ${shortenText(cell.formula, LONGEST_LABEL)}`);
  const marks = cellMarks(cell, lang);
  return words.join(" ") + (marks.length ? ` (${marks.join(", ")})` : "");
}

/** Cuts a long text and says so with an ellipsis. */
export function shortenText(text, longest) {
  const points = [...text.slice(0, 2 * longest + 2)];
  return points.length > longest ? `${points.slice(0, longest - 1).join("")}…` : text;
}

/** Where a step stands: "Step 3 of 12, after OLD". */
export function describeStep(film, index, lang) {
  const count = say(FILM_WORDS.step, lang).replace("{i}", index).replace("{n}", lastIndex(film));
  const text = lineTextAt(film, index);
  const when = text ? say(FILM_WORDS.after, lang).replace("{}", () => text) : say(FILM_WORDS.before, lang);
  return `${count}${lang === "zh" ? "，" : ", "}${when}`;
}

/** The whole picture in words: the step, then every column from top to bottom. */
export function describePicture(film, index, lang, wanted) {
  const cells = cellsAt(film, index).sort((a, b) => a.position - b.position);
  const columns = film.columns.map((column, at) => {
    const own = cells.filter((cell) => cell.column === at).map(
      (cell) => `${positionName(column, cell.position, lang)} ${describeCell(cell, lang, wanted)}`,
    );
    const title = say(FILM_WORDS.stack, lang).replace("{}", () => say(column.title, lang));
    return title + (own.join(lang === "zh" ? "；" : "; ") || say(FILM_WORDS.empty, lang));
  });
  const stop = lang === "zh" ? "。" : ". ";
  return [describeStep(film, index, lang), ...columns].join(stop);
}
