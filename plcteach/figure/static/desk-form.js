// Knows the answer of a task as one text, whatever it is given in: the editor, lines in order, a grid, blocks or a choice.

import { h, icon, say } from "./ui.js";
import { createTeller, plainLines } from "./problems.js";
import { mountEditor } from "./editor.js";
import { makeHistory } from "./desk-answer.js";
import { makeRows } from "./desk-rows.js";
import { makeGrid } from "./desk-grid.js";
import { makeBlocks, makeChoice } from "./desk-pick.js";

const FORM_WORDS = {
  undo: { zh: "撤销", en: "Undo" },
  clear: { zh: "从头再来", en: "Start over" },
  feedback: { zh: "反馈", en: "Feedback" },
  each: { zh: "每行之后", en: "after each row" },
  final: { zh: "最后才给", en: "only at the end" },
};
const FORMS = { rows: makeRows, grid: makeGrid, blocks: makeBlocks, choice: makeChoice };

/** Makes a button with words that change with the language. */
function formButton(name, onclick) {
  const words = h("span", {});
  const node = h("button", { type: "button", className: "plc-button", onclick }, name && icon(name), words);
  return { node, show: (text) => (words.textContent = text) };
}

/** Makes the choice between being told after each row and only at the end. */
function feedbackChoice(onFeedback) {
  const nodes = ["each", "final"].map((value) => [value, formButton(null, () => onFeedback(value))]);
  const name = h("span", { className: "plc-quiet" });
  const group = h("span", { className: "plc-choices", role: "group" }, nodes.map(([, one]) => one.node));
  const show = (lang, feedback) => {
    name.textContent = say(FORM_WORDS.feedback, lang);
    group.setAttribute("aria-label", say(FORM_WORDS.feedback, lang));
    for (const [value, one] of nodes) {
      one.show(say(FORM_WORDS[value], lang));
      one.node.setAttribute("aria-pressed", String(value === feedback));
    }
  };
  return { node: h("span", { className: "plc-feedback" }, name, group), show };
}

/** Puts the focus back on what has been drawn anew, or on what a change leads to. */
function refocus(node, key) {
  if (key) node.querySelector(`[data-key="${CSS.escape(key)}"]`)?.focus();
}

/** Draws a form anew, keeping the focus where it was unless a change leads elsewhere. */
function redrawForm(now, form, key) {
  const active = form.node.contains(document.activeElement) ? document.activeElement.dataset?.key : null;
  form.draw(now.text);
  refocus(form.node, key || active);
  now.tools();
}

/** Makes the buttons below a form: undo, start over, and for a grid when feedback comes. */
function formTools(now, options, history) {
  const undo = formButton("restart", () => now.undo());
  const clear = formButton(null, () => now.put(options.task.start || ""));
  const feedback = options.task.form === "grid" && options.task.tells !== false && options.onFeedback ? feedbackChoice(options.onFeedback) : null;
  const node = h("div", { className: "plc-form-tools" }, undo.node, clear.node, feedback?.node);
  now.tools = () => {
    undo.show(say(FORM_WORDS.undo, now.api.lang));
    clear.show(say(FORM_WORDS.clear, now.api.lang));
    feedback?.show(now.api.lang, options.feedback?.());
    undo.node.disabled = !history.some();
    clear.node.disabled = now.text === plainLines(options.task.start || "");
  };
  return options.readOnly ? null : node;
}

/** Takes the last change back with Ctrl+Z, anywhere in the form. */
function undoByKey(node, undo) {
  node.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() !== "z" || !(event.ctrlKey || event.metaKey) || event.shiftKey) return;
    event.preventDefault();
    event.stopPropagation();
    undo();
  });
}

/** Makes the state of a form that is no editor: its text, how it changes, and how it comes back. */
function formState(options, teller, history) {
  const now = { text: plainLines(options.text), tools: () => {} };
  now.put = (text, key) => {
    if (text === now.text || options.readOnly) return now.redraw(key);
    history.keep(now.text);
    now.text = text;
    now.redraw(key);
    options.onTouch?.();
    teller.touch();
  };
  now.undo = () => {
    if (!history.some()) return;
    now.text = history.back();
    now.redraw();
    options.onTouch?.();
    teller.touch();
  };
  now.setText = (text) => {
    if (plainLines(text) === now.text) return;
    history.keep(now.text);
    now.text = plainLines(text);
    now.redraw();
  };
  now.api = { task: options.task, lang: options.lang, readOnly: Boolean(options.readOnly), put: now.put, redraw: (key) => now.redraw(key) };
  return now;
}

/** Mounts one of the forms that are no editor, with the same handle as the editor has. */
function mountForm(root, options) {
  const history = makeHistory();
  const teller = createTeller({ tell: () => options.onChange?.(now.text) });
  const now = formState(options, teller, history);
  const form = FORMS[options.task.form](now.api);
  const node = h("div", { className: "plc-form" }, form.node, formTools(now, options, history));
  now.redraw = (key) => redrawForm(now, form, key);
  if (!options.readOnly) undoByKey(node, now.undo);
  root.append(node);
  now.redraw();
  const mark = (marks) => form.mark && (form.mark(marks), now.redraw());
  return {
    text: () => now.text, setText: now.setText, flush: teller.flush, mark,
    report: (report) => mark(report?.marks || {}), highlight: () => {}, focus: () => node.querySelector("[data-key]")?.focus(),
    lang: (lang) => (Object.assign(now.api, { lang }), now.redraw()),
    destroy: () => (teller.flush(), node.remove()),
  };
}

/**
 * Mounts the place where the answer of a task is given: the editor for a list, else a form of its own.
 * @param {HTMLElement} root
 * @param {{task: object, text: string, lang: "zh"|"en", readOnly?: boolean, onChange?: (text: string) => void,
 *   onTouch?: () => void, onCursor?: (row: number) => void, feedback?: () => string, onFeedback?: (how: string) => void}} options
 */
export function mountAnswer(root, options) {
  if (Object.hasOwn(FORMS, options.task.form)) return mountForm(root, options);
  const editor = mountEditor(root, options);
  return { ...editor, mark: () => {}, report: (report) => editor.diagnostics(report.diagnostics || []) };
}
