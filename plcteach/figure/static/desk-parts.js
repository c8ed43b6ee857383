// Knows the parts of a desk beside the answer: task and ladder, hints one by one, what is kept, the verdict, and what it plays.

import { h, say } from "./ui.js";
import { marksText, paragraphs } from "./worksheet.js";
import { renameButton, wordButton } from "./panel.js";
import { mountPlayer } from "./player.js";
import { drawVerdict, drawingOf } from "./verdict.js";
import { mountAnswer } from "./desk-form.js";

const PART_WORDS = {
  ladder: { zh: "梯形图", en: "Ladder diagram" },
  program: { zh: "程序", en: "Program" },
  task: { zh: "题目", en: "the task" },
  firstHint: { zh: "给个提示", en: "First hint" },
  nextHint: { zh: "再给一个提示", en: "Next hint" },
  hints: { zh: "提示", en: "Hints" },
  attempts: { zh: "检查 {} 次", en: "checked {}×" },
  best: { zh: "最好成绩 {} / {max}", en: "best mark {} / {max}" },
  used: { zh: "用了 {} 个提示", en: "hints used: {}" },
  seen: { zh: "看过答案", en: "answer seen" },
  earlier: { zh: "另外还保存着 {} 份以前输入的内容", en: "Texts that you typed before and that are kept: {}" },
  restore: { zh: "恢复以前的内容", en: "Put back what was typed before" },
  fresh: { zh: "还没有检查过", en: "not checked yet" },
  verdict: { zh: "检查结果", en: "Result of the check" },
  checking: { zh: "正在检查……", en: "Checking …" },
  stale: { zh: "这是上次修改之前的检查结果", en: "Checked before your last change" },
  show: { zh: "演示给我看", en: "Show me" },
  model: { zh: "看答案", en: "Model answer" },
  modelNote: { zh: "看过答案以后的得分不计入最好成绩", en: "Marks after the model answer are not counted as the best" },
  yours: { zh: "你的程序", en: "Your program" },
  reference: { zh: "参考程序", en: "The reference" },
};

/** Makes the task: its paragraphs, its ladders drawn by Python for each language, and the list that is looked at. */
export function taskPart() {
  const words = h("div", { className: "plc-task" });
  const figures = h("div", { className: "plc-material" });
  const show = (task, lang) => {
    const texts = [...paragraphs(say(task.task, lang)), ...paragraphs(say(task.text, lang))];
    words.replaceChildren(...texts.map((text) => h("p", {}, text)));
    figures.replaceChildren(...(task.ladders || []).map((one) => ladderFigure(one, task, lang)), programFigure(task, lang));
    figures.hidden = ![...figures.children].some((one) => !one.hidden);
  };
  return { words, figures, show };
}

/** Draws a ladder of a task under its name. */
function ladderFigure(drawing, task, lang) {
  const svg = drawingOf(say(drawing, lang));
  const caption = say(PART_WORDS.ladder, lang);
  if (svg && !svg.hasAttribute("aria-label")) svg.setAttribute("aria-label", `${caption}: ${say(task.title, lang)}`);
  svg?.setAttribute("role", "img");
  const scroll = h("div", { className: "plc-scroll", tabindex: "0", role: "region", "aria-label": `${caption}, ${say(PART_WORDS.task, lang)}` }, svg);
  return h("figure", { className: "plc-ladder", hidden: !svg }, h("figcaption", {}, caption), scroll);
}

/** Draws the list that a task is about, its instructions numbered. */
function programFigure(task, lang) {
  const lines = (task.program || "").split("\n").filter(Boolean);
  const caption = say(PART_WORDS.program, lang);
  return h("figure", { className: "plc-ladder plc-given", hidden: lines.length === 0 }, h("figcaption", {}, caption),
    h("ol", { className: "plc-given-lines" }, lines.map((line) => h("li", {}, h("code", {}, line)))));
}

/** Makes the hints: Python gives one more with every press. */
export function hintPart(onMore) {
  const list = h("ol", { className: "plc-hints", "aria-live": "polite" });
  const more = wordButton("lightbulb", onMore);
  const show = ({ shown = [], left = 0 }, lang) => {
    list.replaceChildren(...shown.map((hint) => h("li", {}, say(hint, lang))));
    list.hidden = shown.length === 0;
    list.setAttribute("aria-label", say(PART_WORDS.hints, lang));
    renameButton(more, say(shown.length ? PART_WORDS.nextHint : PART_WORDS.firstHint, lang));
    more.hidden = shown.length === 0 && left === 0;
    more.disabled = left === 0;
  };
  return { list, more, show };
}

/** Says in a few words what the learner has done with a task. */
export function keptWords(kept, max, lang) {
  if (!kept.attempts) return [say(PART_WORDS.fresh, lang)];
  const fill = (word, value) => say(word, lang).replace("{}", value).replace("{max}", marksText(max));
  return [
    fill(PART_WORDS.attempts, kept.attempts),
    Number.isFinite(kept.best) && fill(PART_WORDS.best, marksText(kept.best)),
    kept.hints > 0 && fill(PART_WORDS.used, kept.hints),
    kept.model && say(PART_WORDS.seen, lang),
  ].filter(Boolean);
}

/** Makes the line that says what is kept of a task, what went wrong with the file, and the way back to a text typed before. */
export function keptPart(onRestore) {
  const node = h("p", { className: "plc-kept" });
  const trouble = h("p", { className: "plc-late", role: "status" });
  const words = h("span", {});
  const back = wordButton("restart", onRestore);
  const earlier = h("div", { className: "plc-draft", role: "region", hidden: true }, words, back);
  const show = (kept, task, lang) => {
    node.replaceChildren(...keptWords(kept, task.max, lang).map((words) => h("span", {}, words)));
    trouble.textContent = say(kept.trouble, lang);
    trouble.hidden = !trouble.textContent;
    earlier.hidden = !(kept.earlier > 0);
    earlier.setAttribute("aria-label", words.textContent = say(PART_WORDS.earlier, lang).replace("{}", kept.earlier || 0));
    renameButton(back, say(PART_WORDS.restore, lang));
  };
  return { node, trouble, earlier, show };
}

/** Makes the place of the verdict; it says so itself when the answer has changed since. */
export function verdictPart(onShow, onModel) {
  const body = h("div", {});
  const stale = h("p", { className: "plc-verdict-stale" });
  const see = wordButton("eye", onShow, "plc-primary");
  const model = wordButton("flag", onModel);
  const drawn = {};
  const node = h("section", { className: "plc-judgement", hidden: true, "aria-live": "polite" }, stale, body,
    h("div", { className: "plc-actions" }, see, model));
  const show = ({ verdict, lang, old, checking, canModel }) => {
    node.hidden = !verdict && !checking;
    node.setAttribute("aria-label", say(PART_WORDS.verdict, lang));
    node.classList.toggle("plc-is-old", Boolean(old || checking));
    stale.textContent = checking ? say(PART_WORDS.checking, lang) : old ? say(PART_WORDS.stale, lang) : "";
    if (verdict !== drawn.verdict || lang !== drawn.lang) body.replaceChildren(...(verdict ? [drawVerdict(verdict, lang)] : []));
    Object.assign(drawn, { verdict, lang });
    renameButton(see, say(PART_WORDS.show, lang));
    renameButton(model, say(PART_WORDS.model, lang));
    model.title = say(PART_WORDS.modelNote, lang);
    see.hidden = !verdict?.canShow || Boolean(old || checking);
    model.hidden = !canModel || Boolean(checking);
  };
  return { node, show };
}

/** Makes the place of the model answer: the same form once more, only to be looked at. */
export function modelPart() {
  const title = h("p", { className: "plc-show-title" });
  const place = h("div", {});
  const node = h("section", { className: "plc-show plc-model", hidden: true }, title, place);
  const drawn = { text: "", handle: null };
  const show = (text, task, lang) => {
    node.hidden = !text;
    title.textContent = say(PART_WORDS.model, lang);
    node.setAttribute("aria-label", title.textContent);
    if (text !== drawn.text) {
      drawn.handle?.destroy();
      drawn.handle = text ? mountAnswer(place, { task, text, lang, readOnly: true }) : null;
    }
    drawn.text = text;
    drawn.handle?.lang(lang);
  };
  return { node, show, destroy: () => drawn.handle?.destroy() };
}

/** Makes the place where a program is played, with a sentence above it and the reference's run beside it. */
export function showPart(film) {
  const title = h("p", { className: "plc-show-title" });
  const sentence = h("p", { className: "plc-show-say" });
  const [mine, theirs] = [h("p", { className: "plc-quiet" }), h("p", { className: "plc-quiet" })];
  const stage = h("div", { className: "plc-film" });
  const other = h("div", { className: "plc-show-other", hidden: true }, theirs, stage);
  const node = h("section", { className: "plc-show", hidden: true }, title, sentence,
    h("div", { className: "plc-show-pair" }, h("div", { className: "plc-show-mine" }, mine, film.node), other));
  const drawn = { beside: null, player: null };
  const show = (shown, text, beside, lang) => {
    node.hidden = !shown;
    title.textContent = text;
    node.setAttribute("aria-label", text);
    sentence.textContent = say(beside.say, lang);
    sentence.hidden = !sentence.textContent;
    mine.textContent = say(PART_WORDS.yours, lang);
    theirs.textContent = say(PART_WORDS.reference, lang);
    other.hidden = mine.hidden = !beside.film;
    if (shown && beside !== drawn.beside) playBeside(drawn, stage, beside, lang);
    drawn.player?.lang(lang);
  };
  return { node, show, destroy: () => drawn.player?.destroy() };
}

/** Puts the reference's run on its stage, standing on its own step. */
function playBeside(drawn, stage, beside, lang) {
  drawn.player?.destroy();
  stage.replaceChildren();
  drawn.beside = beside;
  drawn.player = beside.film ? mountPlayer(stage, { film: beside.film, lang, index: beside.index || 0, compact: true }) : null;
}
