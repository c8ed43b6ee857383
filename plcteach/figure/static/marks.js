// Knows how diagnostics are drawn inside the editor: messages under their lines, marks on the text and in the margin.

import { h, svgEl, say } from "./ui.js";
import { placeProblems, markedRange, severityOf } from "./problems.js";
import { CM } from "./vendor/codemirror.js";

const MARK_WORDS = {
  error: { zh: "错误", en: "Error" },
  warning: { zh: "提醒", en: "Warning" },
  info: { zh: "说明", en: "Note" },
  elsewhere: { zh: "相关", en: "See" },
  program: { zh: "整个程序", en: "Whole program" },
};

/** One shape a severity, so that colour is never the only sign. */
const SEVERITY_SHAPES = {
  error: { d: "M5 1.2h6L14.8 5v6L11 14.8H5L1.2 11V5z", sign: "M5.3 5.3l5.4 5.4M10.7 5.3l-5.4 5.4" },
  warning: { d: "M8 1.4 15.2 14.2H.8z", sign: "M8 6v3.8M8 11.7v.5" },
  info: { d: "M8 1a7 7 0 1 0 0 14A7 7 0 0 0 8 1z", sign: "M8 7.2v4M8 4.6v.5" },
};

/** Draws the shape of a severity; its name is read aloud. */
export function severityShape(severity, lang) {
  const { d, sign } = SEVERITY_SHAPES[severity];
  return svgEl(
    "svg",
    { className: `plc-shape plc-${severity}`, viewBox: "0 0 16 16", role: "img", "aria-label": say(MARK_WORDS[severity], lang) },
    svgEl("path", { d, className: "plc-shape-body" }),
    svgEl("path", { d: sign, className: "plc-shape-sign" }),
  );
}

/** Draws one diagnostic: shape, code and text, then its notes, then what can be done about it. */
export function drawProblem(problem, lang) {
  const severity = severityOf(problem);
  const code = h("span", { className: "plc-problem-code" }, problem.code);
  const words = h("div", { className: "plc-problem-words" },
    h("div", {}, code, " ", say(problem.text, lang)),
    problem.near.map((note) => h("div", { className: "plc-problem-note" }, say(note.text, lang))),
    problem.fix && h("div", { className: "plc-problem-fix" }, say(problem.fix, lang)));
  return h("div", { className: `plc-problem plc-is-${severity}` }, severityShape(severity, lang), words);
}

/** Draws a note under the row it points at; the code says which diagnostic it belongs to. */
function drawRemark(remark, lang) {
  const code = h("span", { className: "plc-problem-code" }, `${say(MARK_WORDS.elsewhere, lang)} ${remark.code}`);
  return h("div", { className: "plc-remark" }, code, " ", say(remark.text, lang));
}

/** All messages of one row, as a block between two lines of text. */
class RowMessages extends CM.WidgetType {
  constructor(row, entry, lang) {
    super();
    Object.assign(this, { row, entry, lang, key: JSON.stringify([row === 0, entry, lang]) });
  }

  eq(other) {
    return this.key === other.key;
  }

  get estimatedHeight() {
    return 24 * (this.entry.problems.length * 2 + this.entry.remarks.length);
  }

  toDOM() {
    const { entry, lang } = this;
    const whole = this.row === 0 && h("div", { className: "plc-problem-whole" }, say(MARK_WORDS.program, lang));
    const inner = h("div", { className: "plc-problems" }, whole,
      entry.problems.map((problem) => drawProblem(problem, lang)),
      entry.remarks.map((remark) => drawRemark(remark, lang)));
    return h("div", { className: "plc-problem-block" }, inner);
  }

  ignoreEvent() {
    return true;
  }
}

/** A caret where a diagnostic points between two characters or past the end of a line. */
class PlaceMark extends CM.WidgetType {
  constructor(severity) {
    super();
    this.severity = severity;
  }

  eq(other) {
    return this.severity === other.severity;
  }

  toDOM() {
    return h("span", { className: `plc-place plc-is-${this.severity}`, "aria-hidden": "true" });
  }
}

/** The shape of a row's gravest diagnostic, in the margin. */
class MarginMark extends CM.GutterMarker {
  constructor(severity, lang) {
    super();
    Object.assign(this, { severity, lang });
  }

  eq(other) {
    return this.severity === other.severity && this.lang === other.lang;
  }

  toDOM() {
    return severityShape(this.severity, this.lang);
  }
}

const showProblems = CM.StateEffect.define();

/** Gives the mark on a stretch of text, or a caret where the stretch is empty. */
function markOf(line, { start, stop }, kind) {
  const [from, to] = markedRange(line.text, start, stop);
  if (from < to) return CM.Decoration.mark({ class: `plc-mark plc-is-${kind}` }).range(line.from + from, line.from + to);
  return CM.Decoration.widget({ widget: new PlaceMark(kind), side: 1 }).range(line.from + from);
}

/** Gives the marks on the text of one row; the whole program has none. */
function rowMarks(doc, row, entry) {
  if (row === 0) return [];
  const line = doc.line(row);
  return [
    ...entry.problems.map((problem) => markOf(line, problem, severityOf(problem))),
    ...entry.remarks.filter((remark) => remark.stop > remark.start).map((remark) => markOf(line, remark, "remark")),
  ];
}

/** Places messages and margin marks by the starts of their lines, so that Enter at a line's end leaves them there. */
function layProblems(doc, marks, spots) {
  const blocks = [];
  const margin = [];
  for (const { from, row, entry, widget, lang } of spots) {
    const line = doc.lineAt(from);
    const place = row === 0 ? 0 : line.to;
    blocks.push(CM.Decoration.widget({ widget, block: true, side: row === 0 ? -1 : 1 }).range(place));
    if (row && entry.problems.length) margin.push(new MarginMark(severityOf(entry.problems[0]), lang).range(line.from));
  }
  return { marks, spots, blocks: CM.Decoration.set(blocks, true), margin: CM.RangeSet.of(margin, true) };
}

/** Reads a list of diagnostics into what the editor draws. */
function readProblems(doc, { list, lang }) {
  const rows = [...placeProblems(list, doc.lines)];
  const marks = rows.flatMap(([row, entry]) => rowMarks(doc, row, entry));
  const spots = rows.map(([row, entry]) => (
    { from: row ? doc.line(row).from : 0, row, entry, lang, widget: new RowMessages(row, entry, lang) }
  ));
  return layProblems(doc, CM.Decoration.set(marks, true), spots);
}

/** Carries what is drawn along with an edit, until the next report. */
function carried(value, transaction) {
  const spots = value.spots.map((spot) => ({ ...spot, from: transaction.changes.mapPos(spot.from, 1) }));
  return layProblems(transaction.newDoc, value.marks.map(transaction.changes), spots);
}

const problemField = CM.StateField.define({
  create: (state) => layProblems(state.doc, CM.Decoration.none, []),
  update(value, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(showProblems)) return readProblems(transaction.newDoc, effect.value);
    }
    return transaction.docChanged ? carried(value, transaction) : value;
  },
  provide: (field) => [
    CM.EditorView.decorations.from(field, (value) => value.marks),
    CM.EditorView.decorations.from(field, (value) => value.blocks),
  ],
});

const showCurrent = CM.StateEffect.define();
const currentMark = CM.Decoration.line({ class: "plc-editor-now", attributes: { "aria-current": "step" } });

/** Gives the mark on the line that the player stands on; no row, no mark. */
function currentLine(doc, row) {
  return row >= 1 && row <= doc.lines ? CM.Decoration.set([currentMark.range(doc.line(row).from)]) : CM.Decoration.none;
}

const currentField = CM.StateField.define({
  create: () => CM.Decoration.none,
  update(value, transaction) {
    for (const effect of transaction.effects) {
      if (effect.is(showCurrent)) return currentLine(transaction.newDoc, effect.value);
    }
    return value.map(transaction.changes);
  },
  provide: (field) => CM.EditorView.decorations.from(field),
});

/** What the editor needs to show diagnostics and the player's line, and the margin for their shapes. */
export const problemDrawing = [problemField, currentField];
export const problemMargin = CM.gutter({ class: "plc-margin", markers: (view) => view.state.field(problemField).margin });

/** Draws these diagnostics instead of those before; cursor, scrolling and undo history stay as they are. */
export function drawProblems(view, list, lang) {
  view.dispatch({ effects: showProblems.of({ list, lang }) });
}

/** Marks the row that the player stands on, and brings it into sight without moving page or cursor. */
export function drawCurrent(view, row) {
  view.dispatch({ effects: showCurrent.of(row || 0) });
  if (!(row >= 1 && row <= view.state.doc.lines) || view.hasFocus) return;
  const { top, bottom } = view.lineBlockAt(view.state.doc.line(row).from);
  const { scrollTop, clientHeight } = view.scrollDOM;
  if (top < scrollTop) view.scrollDOM.scrollTop = top;
  else if (bottom > scrollTop + clientHeight) view.scrollDOM.scrollTop = bottom - clientHeight;
}
