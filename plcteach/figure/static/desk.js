// Knows the exercise desk: the task and its ladder, the learner's list, hints, and the check with its verdict.

import { h, say } from "./ui.js";
import { mountEditor } from "./editor.js";
import { readTrait, paragraphs } from "./worksheet.js";
import { openSession, followTraits, viewChoices, wordButton, renameButton } from "./panel.js";
import { statusLine, keepDrafts, filmPanel, toolRoot, flushOnLeave } from "./panel.js";
import { drawVerdict, drawingOf } from "./verdict.js";

const DESK_WORDS = {
  desk: { zh: "练习台", en: "Exercise desk" },
  ladder: { zh: "梯形图", en: "Ladder diagram" },
  check: { zh: "检查", en: "Check" },
  checkKey: { zh: "Ctrl+Enter", en: "Ctrl+Enter" },
  checking: { zh: "正在检查……", en: "Checking …" },
  firstHint: { zh: "给个提示", en: "First hint" },
  nextHint: { zh: "再给一个提示", en: "Next hint" },
  hints: { zh: "提示", en: "Hints" },
  verdict: { zh: "检查结果", en: "Result of the check" },
  stale: { zh: "这是上次修改之前的检查结果", en: "Checked before your last change" },
  show: { zh: "演示给我看", en: "Show me" },
  shown: { zh: "你的程序，输入取自这组数据", en: "Your program, on these inputs" },
  shownOld: { zh: "检查时的程序（之后已修改）", en: "The program as it was checked (changed since)" },
};

/** Makes the task: its paragraphs and its ladder, drawn by Python for each language. */
function taskPart() {
  const words = h("div", { className: "plc-task" });
  const ladder = h("figure", { className: "plc-ladder" });
  const show = (task, lang) => {
    words.replaceChildren(...paragraphs(say(task.task, lang)).map((text) => h("p", {}, text)));
    ladder.replaceChildren(...ladderNodes(task, lang));
    ladder.hidden = !ladder.firstChild;
  };
  return { words, ladder, show };
}

/** Draws the ladder of a task under its name. */
function ladderNodes(task, lang) {
  const svg = drawingOf(say(task.ladder, lang));
  if (!svg) return [];
  const caption = say(DESK_WORDS.ladder, lang);
  if (!svg.hasAttribute("aria-label")) svg.setAttribute("aria-label", `${caption}: ${say(task.title, lang)}`);
  svg.setAttribute("role", "img");
  const scroll = h("div", { className: "plc-scroll", tabindex: "0", role: "region", "aria-label": caption }, svg);
  return [h("figcaption", {}, caption), scroll];
}

/** Makes the hints: one more with every press, none before the first. */
function hintPart() {
  const list = h("ol", { className: "plc-hints", "aria-live": "polite" });
  const more = wordButton("lightbulb", () => show(told.hints, told.lang, told.count + 1));
  const told = { hints: [], lang: "zh", count: 0 };
  const show = (hints, lang, count = told.count) => {
    Object.assign(told, { hints, lang, count: Math.min(count, hints.length) });
    list.replaceChildren(...hints.slice(0, told.count).map((hint) => h("li", {}, say(hint, lang))));
    list.hidden = told.count === 0;
    list.setAttribute("aria-label", say(DESK_WORDS.hints, lang));
    renameButton(more, say(told.count ? DESK_WORDS.nextHint : DESK_WORDS.firstHint, lang));
    more.hidden = hints.length === 0;
    more.disabled = told.count >= hints.length;
  };
  return { list, more, show };
}

/** Makes the place of the verdict; it says so itself when the text has changed since. */
function verdictPart(onShow) {
  const body = h("div", {});
  const stale = h("p", { className: "plc-verdict-stale" });
  const see = wordButton("eye", onShow, "plc-primary");
  const drawn = {};
  const node = h("section", { className: "plc-judgement", hidden: true, "aria-live": "polite" }, stale, body, see);
  const show = ({ verdict, lang, old, checking }) => {
    node.hidden = !verdict && !checking;
    node.setAttribute("aria-label", say(DESK_WORDS.verdict, lang));
    node.classList.toggle("plc-is-old", Boolean(old || checking));
    stale.textContent = checking ? say(DESK_WORDS.checking, lang) : old ? say(DESK_WORDS.stale, lang) : "";
    if (verdict !== drawn.verdict || lang !== drawn.lang) body.replaceChildren(...(verdict ? [drawVerdict(verdict, lang)] : []));
    Object.assign(drawn, { verdict, lang });
    renameButton(see, say(DESK_WORDS.show, lang));
    see.hidden = !verdict?.canShow || Boolean(old || checking);
  };
  return { node, show };
}

/** Makes the place where the learner's program runs on the counterexample, with the ladder once more beside it. */
function showPart(film) {
  const twin = h("figure", { className: "plc-ladder", "aria-hidden": "true", inert: true });
  const title = h("p", { className: "plc-show-title" });
  const node = h("section", { className: "plc-show", hidden: true }, title,
    h("div", { className: "plc-show-pair" }, twin, film.node));
  const copy = (ladder) => {
    const drawing = ladder.querySelector("svg")?.cloneNode(true);
    twin.replaceChildren(...(drawing ? [drawing] : []));
    twin.hidden = !drawing;
  };
  const show = (shown, text) => {
    node.hidden = !shown;
    title.textContent = text;
    node.setAttribute("aria-label", text);
  };
  return { node, copy, show };
}

/** Makes the parts of a desk and puts them on it. */
function deskParts(model, tool) {
  const parts = { lang: () => (model.get("language") === "en" ? "en" : "zh") };
  parts.status = statusLine();
  parts.session = openSession(model, {
    onReport: (report) => parts.report(report),
    onWaiting: (late) => parts.status.show(parts.lang(), { late }),
    beforeTelling: () => parts.editor?.flush(),
  });
  parts.film = filmPanel({
    lang: parts.lang(), index: 0,
    onIndex: (index) => index !== model.get("index") && parts.session.put({ index }),
    onRow: (row) => parts.editor?.highlight(parts.showing && !parts.old() ? row : 0),
  });
  parts.task = taskPart();
  parts.hints = hintPart();
  parts.verdict = verdictPart(() => parts.play());
  parts.show = showPart(parts.film);
  parts.choices = viewChoices(model, parts.session);
  parts.title = h("strong", { className: "plc-family" });
  parts.list = h("span", { className: "plc-list-name" });
  parts.check = wordButton("check", () => parts.ask(), "plc-primary");
  parts.drafts = keepDrafts({
    filename: () => model.get("filename") || readTrait(model, "task", {}).id, source: model.get("source") || "",
    restore: (text) => (parts.editor.setText(text), parts.typed(text)),
  });
  layDesk(parts, tool);
  return parts;
}

/** Lays the parts of a desk out: task and ladder beside the editor, the verdict and what it shows below. */
function layDesk(parts, tool) {
  parts.desk = h("div", { className: "plc-work-text" });
  parts.actions = h("div", { className: "plc-actions" }, parts.check,
    h("kbd", { className: "plc-key" }, say(DESK_WORDS.checkKey, "en")), parts.hints.more);
  tool.node.append(
    h("div", { className: "plc-bar" }, h("div", { className: "plc-bar-names" }, parts.title, parts.list),
      h("div", { className: "plc-bar-tools" }, parts.choices.nodes)),
    parts.task.words, parts.drafts.node,
    h("div", { className: "plc-work" }, parts.task.ladder, parts.desk),
    parts.verdict.node, parts.show.node,
  );
}

/** Lets a desk ask for a check and for the film of the counterexample. */
function connectChecks(parts, model) {
  parts.verdictNow = readTrait(model, "verdict", null);
  parts.checkedText = model.get("source") || "";
  parts.old = () => parts.editor.text() !== parts.checkedText;
  parts.judge = () => {
    const lang = parts.lang();
    parts.verdict.show({ verdict: parts.verdictNow, lang, old: parts.old(), checking: parts.checking });
    parts.show.show(parts.showing, say(parts.old() ? DESK_WORDS.shownOld : DESK_WORDS.shown, lang));
    if (parts.showing && parts.old()) parts.editor.highlight(0);
  };
  parts.ask = () => {
    parts.editor.flush();
    Object.assign(parts, { checking: true, checkedText: parts.editor.text(), showing: false });
    parts.session.put({ verdict: "" });
    parts.session.send({ type: "check" });
    parts.judge();
  };
  parts.play = () => {
    parts.awaited = true;
    parts.session.put({ film: "" });
    parts.session.send({ type: "show" });
  };
}

/** Lets a desk hear the kernel: a verdict, a film, a report. */
function hearKernel(parts, model) {
  parts.onVerdict = () => {
    const verdict = readTrait(model, "verdict", null);
    if (!verdict) return;
    Object.assign(parts, { verdictNow: verdict, checking: false });
    parts.session.answered();
    parts.judge();
  };
  parts.onFilm = () => {
    if (!parts.awaited || !model.get("film")) return;
    Object.assign(parts, { awaited: false, showing: true });
    parts.session.answered();
    parts.judge();
    parts.film.show(model.get("film"));
    parts.show.node.scrollIntoView({ block: "nearest" });
  };
  parts.report = (report) => {
    parts.editor.diagnostics(report.diagnostics || []);
    parts.status.show(parts.lang(), { report });
  };
  parts.typed = (text) => {
    parts.drafts.keep(text);
    parts.session.tell({ source: text });
    parts.judge();
  };
}

/** Writes every word of a desk anew in the chosen language. */
function relabelDesk(parts, model) {
  const lang = parts.lang();
  const task = readTrait(model, "task", {});
  parts.title.textContent = say(task.title, lang);
  parts.list.textContent = [say(task.dialect?.title || task.dialect, lang), say(task.list, lang)].filter(Boolean).join(" · ");
  parts.task.show(task, lang);
  parts.show.copy(parts.task.ladder);
  parts.hints.show(task.hints || [], lang);
  renameButton(parts.check, say(DESK_WORDS.check, lang));
  parts.choices.show(lang);
  parts.editor.lang(lang);
  parts.film.lang(lang);
  parts.drafts.show(lang);
  parts.status.show(lang);
  parts.judge();
}

/** Ctrl-Enter checks, wherever on the desk one is; the notebook around it does not hear of it. */
function checkByKey(node, ask) {
  node.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey) || event.isComposing) return;
    event.preventDefault();
    event.stopPropagation();
    ask();
  }, true);
}

/** Follows what Python, or another view of the same desk, does to the model. */
function followDesk(parts, model, resize) {
  const relabel = () => (resize(), relabelDesk(parts, model));
  return followTraits(model, {
    source: () => (parts.editor.setText(model.get("source") || ""), parts.judge()),
    verdict: parts.onVerdict, film: parts.onFilm, size: resize, language: relabel, task: relabel,
    index: () => parts.showing && parts.film.go(model.get("index")),
  });
}

/**
 * Mounts an exercise desk on an anywidget model (its traits and messages: see the contract in figure/static).
 * @param {HTMLElement} root @param {object} model
 */
export function mountDesk(root, model) {
  const tool = toolRoot(root, "plc-desk");
  const parts = deskParts(model, tool);
  hearKernel(parts, model);
  connectChecks(parts, model);
  parts.editor = mountEditor(parts.desk, {
    text: model.get("source") || "", lang: parts.lang(), onTouch: () => parts.judge(),
    onChange: parts.typed, onCursor: (row) => parts.showing && !parts.old() && parts.film.goRow(row),
  });
  parts.desk.append(parts.status.node, parts.actions, parts.hints.list);
  checkByKey(tool.node, () => parts.ask());
  const resize = () => tool.show(parts.lang(), model.get("size"), say(DESK_WORDS.desk, parts.lang()));
  const unfollow = followDesk(parts, model, resize);
  resize();
  relabelDesk(parts, model);
  parts.session.settle();
  const unflush = flushOnLeave(parts.editor);
  return { destroy: () => (unflush(), parts.editor.destroy(), parts.film.destroy(), parts.session.close(), unfollow(), tool.remove()) };
}
