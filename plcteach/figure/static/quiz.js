// Knows the concept test: its questions one after the other on a quiet desk, and what may be told of the results.

import { h, say } from "./ui.js";
import { readTrait } from "./worksheet.js";
import { followTraits, renameButton, wordButton } from "./panel.js";
import { mountDesk } from "./desk.js";

const QUIZ_WORDS = {
  test: { zh: "概念测验", en: "Concept test" },
  before: { zh: "课前", en: "before the course" },
  after: { zh: "课后", en: "after the course" },
  question: { zh: "第 {} 题", en: "Question {}" },
  answered: { zh: "已作答", en: "answered" },
  back: { zh: "上一题", en: "Back" },
  next: { zh: "下一题", en: "Next" },
  finish: { zh: "交卷", en: "Finish" },
  open: { zh: "还有 {} 题没有作答", en: "{} not answered yet" },
  between: {
    zh: "课前答对 {before} / {all} 题。学完以后再做一次，两次会放在一起比较。",
    en: "Before the course {before} of {all} were right. Take the test again when the course is done: the two will be compared.",
  },
  begin: { zh: "课后再做一次", en: "Take it again, after the course" },
  result: { zh: "两次的结果", en: "Both results" },
  right: { zh: "对", en: "right" },
  wrong: { zh: "不对", en: "not right" },
  lesson: { zh: "见第 {} 课", en: "see lesson {}" },
};

/** Gives a text with its named places filled. */
export function filledText(text, lang, values) {
  return say(text, lang).replace(/\{(\w*)\}/g, (_, name) => String(values[name] ?? values.value ?? ""));
}

/** Draws the numbers of the questions: where one is, and which are answered. */
function questionButtons(state, lang, go) {
  return state.answered.map((answered, at) => {
    const name = filledText(QUIZ_WORDS.question, lang, { value: at + 1 });
    return h("button", {
      type: "button", className: `plc-button plc-quiz-number${answered ? " plc-quiz-answered" : ""}`, onclick: () => go(at),
      "aria-label": answered ? `${name}, ${say(QUIZ_WORDS.answered, lang)}` : name, "aria-current": at === state.at ? "step" : null,
    }, String(at + 1));
  });
}

/** Draws one answer of the comparison: a sign and a word. */
function resultCell(right, lang) {
  return h("td", { className: right ? "plc-mark-right" : "plc-mark-wrong" }, `${right ? "✓" : "✗"} ${say(right ? QUIZ_WORDS.right : QUIZ_WORDS.wrong, lang)}`);
}

/** Draws the results of both times, question by question. */
function resultTable(result, lang) {
  const head = ["before", "after"].map((name) => h("th", { scope: "col" }, say(QUIZ_WORDS[name], lang)));
  const rows = result.rows.map((row) => h("tr", {}, h("th", { scope: "row" }, say(row.title, lang)), resultCell(row.before, lang), resultCell(row.after, lang),
    h("td", {}, !row.after && row.lesson >= 0 && filledText(QUIZ_WORDS.lesson, lang, { value: row.lesson }))));
  const table = h("table", { className: "plc-quiz-table" }, h("thead", {}, h("tr", {}, h("td", {}), head, h("td", {}))), h("tbody", {}, rows));
  return h("div", { className: "plc-scroll", tabindex: "0", role: "region", "aria-label": say(QUIZ_WORDS.result, lang) }, table);
}

/** Draws what may be told between the two times, and after the second. */
function resultNodes(state, lang, begin) {
  if (state.phase === "between") {
    const again = wordButton("restart", begin, "plc-primary");
    renameButton(again, say(QUIZ_WORDS.begin, lang));
    return [h("p", {}, filledText(QUIZ_WORDS.between, lang, state.result)), h("div", { className: "plc-actions" }, again)];
  }
  return state.phase === "done" ? [h("p", {}, say(state.result.say, lang)), resultTable(state.result, lang)] : [];
}

/** Makes the buttons and places of a quiz. */
function quizParts(tell) {
  const parts = { title: h("p", { className: "plc-show-title" }), numbers: h("div", { className: "plc-quiz-numbers", role: "group" }) };
  parts.back = wordButton("prev", () => tell({ type: "go", at: parts.state.at - 1 }));
  parts.next = wordButton("next", () => tell({ type: "go", at: parts.state.at + 1 }), "plc-primary");
  parts.finish = wordButton("flag", () => tell({ type: "finish" }));
  parts.open = h("span", { className: "plc-quiet", role: "status" });
  parts.box = h("div", { className: "plc-quiz-desk" });
  parts.result = h("div", { className: "plc-quiz-result" });
  parts.steps = h("div", { className: "plc-actions" }, parts.back, parts.next, parts.finish, parts.open);
  parts.node = h("div", { className: "plc-tool plc-desk plc-quiz" }, parts.title, parts.numbers, parts.box, parts.steps, parts.result);
  return parts;
}

/** Writes a quiz anew: where one is, what is answered, what is told. */
function showQuiz(parts, lang, tell) {
  const { state } = parts;
  const running = state.phase === "before" || state.phase === "after";
  const open = state.answered.filter((answered) => !answered).length;
  parts.node.setAttribute("lang", lang === "zh" ? "zh-CN" : "en");
  parts.title.textContent = [say(QUIZ_WORDS.test, lang), running && say(QUIZ_WORDS[state.phase], lang)].filter(Boolean).join(" · ");
  parts.numbers.setAttribute("aria-label", say(QUIZ_WORDS.test, lang));
  parts.numbers.replaceChildren(...questionButtons(state, lang, (at) => tell({ type: "go", at })));
  for (const name of ["back", "next", "finish"]) renameButton(parts[name], say(QUIZ_WORDS[name], lang));
  parts.back.disabled = state.at === 0;
  parts.next.disabled = state.at === state.answered.length - 1;
  parts.open.textContent = open ? filledText(QUIZ_WORDS.open, lang, { value: open }) : "";
  for (const node of [parts.numbers, parts.box, parts.steps]) node.hidden = !running;
  parts.result.replaceChildren(...resultNodes(state, lang, () => tell({ type: "begin" })));
}

/**
 * Mounts a concept test on an anywidget model (that of a desk, with `quiz`: see widgets/quiz.py).
 * @param {HTMLElement} root @param {object} model
 */
export function mountQuiz(root, model) {
  let desk = null;
  const tell = (message) => (desk?.flush(), model.send(message));
  const parts = quizParts(tell);
  const lang = () => (model.get("language") === "en" ? "en" : "zh");
  const show = () => {
    parts.state = readTrait(model, "quiz", { phase: "before", at: 0, answered: [], result: {} });
    parts.node.style.setProperty("--plc-size", String(model.get("size") || 1));
    showQuiz(parts, lang(), tell);
  };
  const open = () => {
    desk?.destroy();
    show();
    desk = mountDesk(parts.box, model, { quiet: true, draft: `quiz-${parts.state.phase}-` });
  };
  root.append(parts.node);
  open();
  const unfollow = followTraits(model, { quiz: show, language: show, size: show, task: open });
  return { destroy: () => (unfollow(), desk?.destroy(), parts.node.remove()) };
}
