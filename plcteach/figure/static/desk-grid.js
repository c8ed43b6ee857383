// Knows how a grid is filled in: the stack after each instruction, or outputs over scans drawn as a timing chart; by press or key.

import { h, say } from "./ui.js";
import { EMPTY_CELL, cellAfterKey, gridCells, gridText, nextSign, signOfKey, withCell } from "./desk-answer.js";

const GRID_WORDS = {
  predict: { zh: "每条指令执行后的堆栈", en: "The stack after each instruction" },
  chart: { zh: "各扫描周期的输出", en: "The outputs, scan by scan" },
  column: { predict: { zh: "层", en: "level" }, chart: { zh: "扫描", en: "scan" } },
  keys: {
    predict: { zh: "点击单元格，或用方向键移动、按 0 1 x 填写；空着的层留空，或者写“.”", en: "Press a cell, or move with the arrows and type 0, 1 or x; a level that holds nothing stays empty, or gets a dot" },
    chart: { zh: "点击或拖过单元格画线，或用方向键移动、按 0 1 填写", en: "Press the cells or draw across them, or move with the arrows and type 0 or 1" },
  },
  empty: { zh: "空", en: "empty" },
  wrong: { zh: "还不对", en: "not right yet" },
  right: { zh: "对", en: "right" },
  given: { zh: "已给出", en: "given" },
};
const CELL_WORDS = { 0: "plc-cell-zero", 1: "plc-cell-one", x: "plc-cell-x", [EMPTY_CELL]: "plc-cell-empty" };

/** Names the classes of a cell; in a chart its line joins the one before. */
function cellClass(sign, before, wrong) {
  const turn = before !== undefined && before !== EMPTY_CELL && sign !== EMPTY_CELL && before !== sign;
  return ["plc-grid-cell", CELL_WORDS[sign], turn && "plc-cell-turn", wrong && "plc-cell-wrong"].filter(Boolean).join(" ");
}

/** Draws one cell to be filled in. */
function gridCell(form, cells, row, column) {
  const { api } = form;
  const sign = cells[row][column];
  const wrong = form.marks.cells.some(([r, c]) => r === row && c === column);
  const head = say(api.task.heads?.[column], api.lang) || `${say(GRID_WORDS.column[form.kind], api.lang)} ${api.task.columns[column]}`;
  const where = `${api.task.rows[row]}, ${head}`;
  const value = sign === EMPTY_CELL ? say(GRID_WORDS.empty, api.lang) : sign;
  const here = form.at[0] === row && form.at[1] === column;
  return h("td", {
    className: cellClass(sign, cells[row][column - 1], wrong), tabindex: here ? "0" : "-1",
    "aria-label": `${where}: ${value}${wrong ? `, ${say(GRID_WORDS.wrong, api.lang)}` : ""}`,
    "aria-readonly": api.readOnly ? "true" : null, dataset: { key: `c${row}-${column}`, row, column, sign },
  }, sign === EMPTY_CELL ? "" : sign);
}

/** Draws what is known of a row: right, not right yet, or nothing. */
function rowMark(form, row) {
  const known = form.marks.rows[row];
  const sign = { right: "✓", wrong: "✗" }[known] || "";
  return h("td", { className: `plc-grid-mark plc-mark-${known || "none"}`, "aria-label": known ? say(GRID_WORDS[known], form.api.lang) : null }, sign);
}

/** Draws a row of a chart that is given: an input. */
function waveRow({ address, values }, lang) {
  const cells = values.map((value, at) => h("td", {
    className: `${cellClass(value, values[at - 1], false)} plc-cell-given`, "aria-label": `${address}: ${value}, ${say(GRID_WORDS.given, lang)}`,
  }, value));
  return h("tr", { className: "plc-wave-given" }, h("th", { scope: "row" }, address), cells, h("td", { className: "plc-grid-mark" }));
}

/** Fills a cell in and, where a key did it, goes on to the next one. */
function fillCell(form, row, column, sign, onward = false) {
  const last = form.api.task.columns.length - 1;
  const end = row === form.api.task.rows.length - 1 && column === last;
  if (onward && !end) form.at = column < last ? [row, column + 1] : [row + 1, 0];
  else form.at = [row, column];
  form.api.put(gridText(withCell(form.cells, row, column, sign), form.api.task), `c${form.at.join("-")}`);
}

/** Goes to a cell without changing it. */
function goCell(form, row, column) {
  form.at = [row, column];
  form.api.redraw(`c${row}-${column}`);
}

/** Acts on a key pressed on a cell. */
function gridKey(form, event) {
  const cell = event.target.closest?.("[data-row]");
  if (!cell || event.ctrlKey || event.metaKey || event.altKey) return;
  const [row, column] = [Number(cell.dataset.row), Number(cell.dataset.column)];
  const to = cellAfterKey(event.key, row, column, form.api.task.rows.length, form.api.task.columns.length);
  const sign = [" ", "Enter"].includes(event.key) ? nextSign(form.kind, cell.dataset.sign) : signOfKey(event.key, form.kind);
  if (to) goCell(form, ...to);
  else if (sign !== null && !form.api.readOnly) fillCell(form, row, column, sign, ![" ", "Enter", "Backspace", "Delete"].includes(event.key));
  else return;
  event.preventDefault();
  event.stopPropagation();
}

/** Lets the pointer press a cell, and in a chart draw on across its neighbours. */
function listenToPointer(form) {
  let paint = null;
  const cellAt = (event) => document.elementFromPoint(event.clientX, event.clientY)?.closest?.("[data-row]");
  const set = (cell) => fillCell(form, Number(cell.dataset.row), Number(cell.dataset.column), paint);
  form.node.addEventListener("pointerdown", (event) => {
    const cell = event.target.closest("[data-row]");
    if (!cell || form.api.readOnly || event.button !== 0) return;
    event.preventDefault();
    paint = nextSign(form.kind, cell.dataset.sign);
    set(cell);
  });
  form.node.addEventListener("pointermove", (event) => {
    if (paint === null || form.kind !== "chart") return;
    if (!event.buttons) return void (paint = null);
    const cell = cellAt(event);
    if (cell && form.node.contains(cell) && cell.dataset.sign !== paint) set(cell);
  });
  for (const name of ["pointerup", "pointercancel"]) form.node.addEventListener(name, () => (paint = null));
}

/**
 * Makes the form in which a grid is filled in.
 * @param {object} api  {task, lang, readOnly, put(text, key), redraw(key)}
 */
export function makeGrid(api) {
  const kind = api.task.kind === "chart" ? "chart" : "predict";
  const table = h("table", { className: `plc-grid plc-grid-${kind}`, role: "grid" });
  const keys = h("p", { className: "plc-editor-keys" });
  const node = h("div", { className: "plc-grid-box" }, h("div", { className: "plc-scroll" }, table), keys);
  const form = { api, node, kind, at: [0, 0], cells: [], marks: { rows: [], cells: [] } };
  node.addEventListener("keydown", (event) => gridKey(form, event));
  listenToPointer(form);
  const draw = (text) => {
    const { task, lang } = api;
    form.cells = gridCells(text, { ...task, kind });
    keys.textContent = api.readOnly ? "" : say(GRID_WORDS.keys[kind], lang);
    const head = h("tr", {}, h("th", { scope: "row" }, say(GRID_WORDS.column[kind], lang)), task.columns.map((one, at) => h("th", { scope: "col", title: say(task.heads?.[at], lang) || null }, one)), h("td", { className: "plc-grid-mark" }));
    const given = (task.waves || []).map((wave) => waveRow(wave, lang));
    const rows = form.cells.map((cells, row) => h("tr", {}, h("th", { scope: "row" }, task.rows[row]),
      cells.map((_, column) => gridCell(form, form.cells, row, column)), rowMark(form, row)));
    table.setAttribute("aria-label", say(GRID_WORDS[kind], lang));
    table.replaceChildren(h("thead", {}, head), h("tbody", {}, given, rows));
  };
  return { node, draw, mark: (marks) => (form.marks = { rows: [], cells: [], ...marks }) };
}
