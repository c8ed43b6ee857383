// Knows how an instruction list is typed: the editor, its keys and its messages; nothing of what a program means.

import { h, say } from "./ui.js";
import { plainLines, changeBetween, spacesToStop, spacesToDrop, createTeller } from "./problems.js";
import { problemDrawing, problemMargin, drawProblems, drawCurrent } from "./marks.js";
import { CM } from "./vendor/codemirror.js";

const EDITOR_WORDS = {
  label: { zh: "程序编辑区", en: "Program editor" },
  keys: {
    zh: "Tab 跳到下一列；先按 Esc 再按 Tab 离开编辑区",
    en: "Tab goes to the next column; Esc, then Tab, leaves the editor",
  },
  fixed: { zh: "只读", en: "read only" },
};

const TAB_WIDTH = 4;
const fromOutside = CM.Annotation.define();

/** Gives the column of a place in its line, in code points. */
function columnOf(line, position) {
  return Array.from(line.text.slice(0, position - line.from)).length;
}

/** Gives the starts of all lines that a selection touches. */
function touchedLines({ doc }, { from, to }) {
  const lines = [];
  for (let n = doc.lineAt(from).number; n <= doc.lineAt(to).number; n += 1) lines.push(doc.line(n));
  return lines;
}

/** Tab: spaces up to the next column stop; with several lines selected, moves them all right by one stop. */
function tabForward(view) {
  const { state } = view;
  const { main } = state.selection;
  const lines = touchedLines(state, main);
  if (lines.length > 1) {
    const changes = lines.filter((line) => line.length).map((line) => ({ from: line.from, insert: " ".repeat(TAB_WIDTH) }));
    view.dispatch({ changes, userEvent: "input.indent" });
  } else {
    const spaces = " ".repeat(spacesToStop(columnOf(lines[0], main.from), TAB_WIDTH));
    view.dispatch(state.replaceSelection(spaces), { userEvent: "input", scrollIntoView: true });
  }
  return true;
}

/** Shift-Tab: takes away the spaces before the cursor down to the stop before; of several lines, their first ones. */
function tabBack(view) {
  const { state } = view;
  const { main } = state.selection;
  const lines = touchedLines(state, main);
  const ends = lines.length > 1
    ? lines.map((line) => line.from + Math.min(TAB_WIDTH, /^ */.exec(line.text)[0].length))
    : [main.from];
  const changes = ends.map((to) => {
    const line = state.doc.lineAt(to);
    return { from: to - spacesToDrop(line.text.slice(0, to - line.from), TAB_WIDTH), to };
  });
  view.dispatch({ changes, userEvent: "delete.dedent", scrollIntoView: lines.length === 1 });
  return true;
}

/** Escape: the next Tab leaves the editor, however long one thinks about it. */
function escapeTab(view) {
  view.setTabFocusMode(600000);
  return true;
}

const EDITOR_KEYS = [
  { key: "Tab", run: tabForward, shift: tabBack },
  { key: "Escape", run: escapeTab, stopPropagation: true },
  { key: "Enter", run: CM.insertNewlineKeepIndent, shift: CM.insertNewlineKeepIndent },
  { key: "Mod-y", run: CM.redo, preventDefault: true },
  { key: "Mod-Shift-z", run: CM.redo, preventDefault: true },
];

/** Keeps from the page every key that the editor has used; chords that it leaves alone go on. */
function keepUsedKeys(box) {
  box.addEventListener("keydown", (event) => {
    const chord = event.ctrlKey || event.metaKey;
    const plain = !chord && event.key !== "Tab";
    if (event.defaultPrevented || plain || event.key === "Enter") event.stopPropagation();
  });
}

/** Gives what assistive technology and the browser are told about the text area. */
function contentAttributes({ label, readOnly }, lang) {
  const parts = [say(label || EDITOR_WORDS.label, lang), readOnly && say(EDITOR_WORDS.fixed, lang), say(EDITOR_WORDS.keys, lang)];
  return CM.EditorView.contentAttributes.of({
    "aria-label": parts.filter(Boolean).join(lang === "zh" ? "。" : ". "),
    tabindex: "0",
    spellcheck: "false",
    autocorrect: "off",
    autocapitalize: "off",
    autocomplete: "off",
    writingsuggestions: "false",
    translate: "no",
  });
}

/** Tells messages how wide the visible part is, so that they wrap there even beside very long lines. */
function measureWidth(view) {
  view.requestMeasure({
    key: "plc-visible",
    read: () => [view.scrollDOM.clientWidth, view.scrollDOM.querySelector(".cm-gutters")?.offsetWidth || 0],
    write: ([whole, gutters]) => {
      view.dom.style.setProperty("--plc-visible", `${Math.max(120, whole - gutters)}px`);
      view.dom.style.setProperty("--plc-gutters", `${gutters}px`);
    },
  });
}

/** Listens to the editor: text typed here, the cursor moved by hand, the width changed. */
function listener({ touch, onCursor }) {
  let last = 0;
  return CM.EditorView.updateListener.of((update) => {
    if (update.geometryChanged) measureWidth(update.view);
    const here = update.transactions.every((transaction) => !transaction.annotation(fromOutside));
    if (update.docChanged && here) touch();
    const row = update.state.doc.lineAt(update.state.selection.main.head).number;
    if (update.selectionSet && !update.docChanged && row !== last) onCursor?.(row);
    last = row;
  });
}

/** Builds the CodeMirror view from the parts above. */
function makeView(box, options, attributes, touch) {
  const extensions = [
    CM.history(),
    CM.keymap.of([...EDITOR_KEYS, ...CM.historyKeymap, ...CM.standardKeymap]),
    problemDrawing,
    CM.lineNumbers(),
    problemMargin,
    CM.EditorState.tabSize.of(TAB_WIDTH),
    CM.EditorState.readOnly.of(Boolean(options.readOnly)),
    attributes.of(contentAttributes(options, options.lang)),
    listener({ touch, onCursor: options.onCursor }),
  ];
  return new CM.EditorView({ parent: box, state: CM.EditorState.create({ doc: plainLines(options.text), extensions }) });
}

/** Replaces the text as one change that can be undone; the same text changes nothing. */
function replaceText(view, text) {
  const change = changeBetween(view.state.doc.toString(), plainLines(text));
  if (change) view.dispatch({ changes: change, annotations: [fromOutside.of(true), CM.isolateHistory.of("full")] });
}

/** Draws diagnostics, but not into the middle of a word that an input method is still composing. */
function makePainter(view, lang) {
  const shown = { list: [], lang };
  const later = createTeller({ tell: () => drawProblems(view, shown.list, shown.lang), busy: () => view.composing, pause: 60 });
  const paint = (news) => {
    Object.assign(shown, news);
    later.touch();
    if (!view.composing) later.flush();
  };
  return { paint, stop: later.stop };
}

/**
 * Mounts an editor. `onChange(text)` comes 250 ms after the last key and never while an input method composes,
 * `onTouch` at every key, `onCursor(row)` when the cursor is moved to another row without typing.
 * @param {HTMLElement} root
 * @param {{text?: string, lang?: "zh"|"en", label?: object|string, readOnly?: boolean,
 *   onChange?: (text: string) => void, onTouch?: () => void, onCursor?: (row: number) => void}} options
 */
export function mountEditor(root, options) {
  const box = h("div", { className: "plc-editor-box" });
  const hint = h("p", { className: "plc-editor-keys" });
  const node = h("div", { className: "plc-editor" }, box, hint);
  const attributes = new CM.Compartment();
  const text = () => view.state.doc.toString();
  const teller = createTeller({ tell: () => options.onChange?.(text()), busy: () => view.composing });
  const touch = () => (teller.touch(), options.onTouch?.());
  const view = makeView(box, options, attributes, touch);
  const painter = makePainter(view, options.lang);
  const lang = (next) => {
    hint.textContent = say(EDITOR_WORDS.keys, next);
    view.dispatch({ effects: attributes.reconfigure(contentAttributes(options, next)) });
    painter.paint({ lang: next });
  };
  keepUsedKeys(box);
  root.append(node);
  lang(options.lang || "zh");
  return {
    text,
    lang,
    setText: (next) => replaceText(view, next),
    diagnostics: (list) => painter.paint({ list }),
    highlight: (row) => drawCurrent(view, row),
    focus: () => view.focus(),
    flush: teller.flush,
    destroy: () => (teller.flush(), painter.stop(), view.destroy(), node.remove()),
  };
}
