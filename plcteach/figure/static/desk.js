// Knows the exercise desk: the task, the place for its answer, hints, the check with its verdict, and what is kept of it.

import { h, say } from "./ui.js";
import { readTrait } from "./worksheet.js";
import { openSession, followTraits, viewChoices, wordButton, renameButton } from "./panel.js";
import { statusLine, keepDrafts, filmPanel, toolRoot, flushOnLeave } from "./panel.js";
import { marksOfVerdict } from "./desk-answer.js";
import { mountAnswer } from "./desk-form.js";
import { hintPart, keptPart, modelPart, showPart, taskPart, verdictPart } from "./desk-parts.js";

const DESK_WORDS = {
  desk: { zh: "练习台", en: "Exercise desk" },
  check: { zh: "检查", en: "Check" },
  checkKey: { zh: "Ctrl+Enter", en: "Ctrl+Enter" },
  shown: { zh: "你的程序，输入取自这组数据", en: "Your program, on these inputs" },
  shownOld: { zh: "检查时的程序（之后已修改）", en: "The program as it was checked (changed since)" },
  run: { zh: "题目中的程序", en: "The program of the task" },
};

/** Makes the parts of a desk that talk with the kernel. */
function talkingParts(parts, model, options) {
  parts.status = statusLine();
  parts.session = openSession(model, {
    onReport: (report) => parts.report(report),
    onWaiting: (late) => parts.status.show(parts.lang(), { late }),
    beforeTelling: () => parts.answer?.flush(),
  });
  parts.film = filmPanel({
    lang: parts.lang(), index: 0,
    onIndex: (index) => index !== model.get("index") && parts.session.put({ index }),
    onRow: (row) => parts.answer?.highlight(parts.showing && !parts.old() ? row : 0),
  });
  parts.choices = viewChoices(model, parts.session);
  parts.drafts = keepDrafts({
    filename: () => `${options.draft || ""}${parts.task().id}`, source: model.get("source") || "",
    restore: (text) => (parts.answer.setText(text), parts.typed(text)),
  });
}

/** Makes the parts of a desk and puts them on it. */
function deskParts(model, tool, options) {
  const parts = { lang: () => (model.get("language") === "en" ? "en" : "zh"), task: () => readTrait(model, "task", {}) };
  talkingParts(parts, model, options);
  parts.material = taskPart();
  parts.hints = hintPart(() => parts.session.send({ type: "hint" }));
  parts.kept = keptPart(() => parts.session.send({ type: "restore" }));
  parts.verdict = verdictPart(() => parts.play("show"), () => parts.play("model"));
  parts.model = modelPart();
  parts.show = showPart(parts.film);
  parts.title = h("strong", { className: "plc-family" });
  parts.list = h("span", { className: "plc-list-name" });
  parts.check = wordButton("check", () => parts.ask(), "plc-primary");
  layDesk(parts, tool, options);
  return parts;
}

/** Lays the parts of a desk out: task and material beside the answer, the verdict and what it shows below. */
function layDesk(parts, tool, options) {
  parts.desk = h("div", { className: "plc-work-text" });
  parts.actions = h("div", { className: "plc-actions" }, parts.check,
    h("kbd", { className: "plc-key" }, say(DESK_WORDS.checkKey, "en")), parts.hints.more);
  tool.node.append(
    h("div", { className: "plc-bar" }, h("div", { className: "plc-bar-names" }, parts.title, parts.list),
      h("div", { className: "plc-bar-tools" }, parts.choices.nodes)),
    ...(options.quiet ? [] : [parts.kept.node]), parts.kept.trouble, ...(options.quiet ? [] : [parts.kept.earlier]), parts.material.words, parts.drafts.node,
    h("div", { className: "plc-work" }, parts.material.figures, parts.desk),
    ...(options.quiet ? [] : [parts.verdict.node, parts.model.node, parts.show.node]),
  );
}

/** Lets a desk ask for a check, for a hint, and for what is to be played. */
function connectChecks(parts, model) {
  parts.verdictNow = readTrait(model, "verdict", null);
  parts.checkedText = model.get("source") || "";
  parts.old = () => parts.answer.text() !== parts.checkedText;
  parts.canModel = () => Boolean(parts.task().model && readTrait(model, "kept", {}).attempts);
  parts.judge = () => {
    const lang = parts.lang();
    parts.verdict.show({ verdict: parts.verdictNow, lang, old: parts.old(), checking: parts.checking, canModel: parts.canModel() });
    const words = parts.task().form !== "list" && model.get("model") ? DESK_WORDS.run : parts.old() ? DESK_WORDS.shownOld : DESK_WORDS.shown;
    parts.show.show(parts.showing, say(words, lang), parts.beside || {}, lang);
    parts.model.show(model.get("model") || "", parts.task(), lang);
    if (parts.showing && parts.old()) parts.answer.highlight(0);
  };
  parts.ask = () => {
    parts.answer.flush();
    Object.assign(parts, { checking: true, checkedText: parts.answer.text(), showing: false });
    parts.session.put({ verdict: "" });
    parts.session.send({ type: "check" });
    parts.judge();
  };
  parts.play = (type) => {
    parts.awaited = true;
    parts.session.put({ film: "" });
    parts.session.send({ type });
  };
}

/** Lets a desk hear the kernel: a verdict, a film, a report. */
function hearKernel(parts, model) {
  parts.onVerdict = () => {
    const verdict = readTrait(model, "verdict", null);
    if (!verdict) return;
    Object.assign(parts, { verdictNow: verdict, checking: false });
    parts.session.answered();
    parts.answer.mark(marksOfVerdict(verdict, parts.task().rows?.length || 0));
    parts.judge();
  };
  parts.onFilm = () => {
    if (!parts.awaited || !model.get("film")) return;
    Object.assign(parts, { awaited: false, showing: true, beside: readTrait(model, "beside", {}) });
    parts.session.answered();
    parts.judge();
    const index = model.get("index");
    parts.film.show(model.get("film"));
    parts.film.go(index);
    parts.show.node.scrollIntoView({ block: "nearest" });
  };
  parts.report = (report) => {
    parts.answer.report(report);
    if (parts.task().form === "list") parts.status.show(parts.lang(), { report });
  };
  parts.typed = (text) => {
    parts.drafts.keep(text);
    parts.session.tell({ source: text });
    parts.judge();
  };
  parts.words = () => {
    parts.session.answered();
    parts.hints.show(readTrait(model, "hints", {}), parts.lang());
    parts.kept.show(readTrait(model, "kept", {}), parts.task(), parts.lang());
    parts.judge();
  };
}

/** Writes every word of a desk anew in the chosen language. */
function relabelDesk(parts) {
  const [lang, task] = [parts.lang(), parts.task()];
  parts.title.textContent = say(task.title, lang);
  parts.list.textContent = [say(task.dialect?.title || task.dialect, lang), say(task.list, lang)].filter(Boolean).join(" · ");
  parts.material.show(task, lang);
  renameButton(parts.check, say(DESK_WORDS.check, lang));
  parts.choices.show(lang);
  parts.answer.lang(lang);
  parts.film.lang(lang);
  parts.drafts.show(lang);
  parts.status.show(lang);
  parts.words();
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
  const relabel = () => (resize(), relabelDesk(parts));
  return followTraits(model, {
    source: () => (parts.answer.setText(model.get("source") || ""), parts.session.answered(), parts.judge()),
    verdict: parts.onVerdict, film: parts.onFilm, hints: parts.words, kept: parts.words, model: parts.words,
    feedback: () => parts.answer.lang(parts.lang()),
    size: resize, language: relabel,
    index: () => parts.showing && parts.film.go(model.get("index")),
  });
}

/** Puts the place for the answer on a desk. */
function answerOf(parts, model, options) {
  return mountAnswer(parts.desk, {
    task: parts.task(), text: model.get("source") || "", lang: parts.lang(), onTouch: () => parts.judge(),
    onChange: parts.typed, onCursor: (row) => parts.showing && !parts.old() && parts.film.goRow(row),
    feedback: () => model.get("feedback"), onFeedback: options.quiet ? null : (feedback) => parts.session.tell({ feedback }),
  });
}

/**
 * Mounts an exercise desk on an anywidget model (its traits and messages: see widgets/desk.py).
 * @param {HTMLElement} root @param {object} model
 * @param {{quiet?: boolean, draft?: string}} options  quiet: no check, no hints, no verdict, as in a test; draft: stands before
 *   the name under which this browser keeps what is typed
 */
export function mountDesk(root, model, options = {}) {
  const tool = toolRoot(root, "plc-desk");
  const parts = deskParts(model, tool, options);
  hearKernel(parts, model);
  connectChecks(parts, model);
  parts.answer = answerOf(parts, model, options);
  parts.desk.append(parts.status.node, ...(options.quiet ? [] : [parts.actions, parts.hints.list]));
  if (!options.quiet) checkByKey(tool.node, () => parts.ask());
  const resize = () => tool.show(parts.lang(), model.get("size"), say(DESK_WORDS.desk, parts.lang()));
  const unfollow = followDesk(parts, model, resize);
  resize();
  relabelDesk(parts);
  parts.session.settle();
  const unflush = flushOnLeave(parts.answer);
  const ends = [unflush, parts.answer.destroy, parts.model.destroy, parts.show.destroy, parts.film.destroy, parts.session.close, unfollow, tool.remove];
  return { flush: () => parts.answer.flush(), destroy: () => ends.forEach((end) => end()) };
}
