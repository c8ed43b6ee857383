// Knows how to ask "what will the top be?", to take a guess and to count; it is told the answer only when it is shown.

import { button, h, say } from "./ui.js";
import { lineTextAt, positionName, topAt, writesTop } from "./film.js";

const ASK_WORDS = {
  question: { zh: "执行 {line} 之后，{level}是多少？", en: "What will {level} be after {line}?" },
  answers: { zh: "你的回答", en: "Your answer" },
  guess: { zh: "回答 {}（按键 {}）", en: "Answer {} (key {})" },
  show: { zh: "揭晓", en: "Show" },
  showKey: { zh: "揭晓（Enter 或 →）", en: "Show (Enter or →)" },
  right: { zh: "对了。", en: "Right." },
  notYet: { zh: "还没对：{level}是 {value}。", en: "Not yet: {level} is {value}." },
  score: { zh: "答对 {right} / {all}", en: "{right} of {all} right" },
};
const GUESSES = ["0", "1", "x"];

/** The buttons under a question. `onGuess(value)` takes a guess, `onShow()` shows the answer without one. */
export function makeAskView(onGuess, onShow) {
  return { node: h("div", { className: "plc-answers", role: "group", hidden: true }), onGuess, onShow };
}

/** Writes the answer buttons in one language. */
export function translateAsk(view, lang) {
  view.node.setAttribute("aria-label", say(ASK_WORDS.answers, lang));
  const guesses = GUESSES.map((value) => {
    const label = say(ASK_WORDS.guess, lang).replaceAll("{}", value);
    return button({ label, text: value, className: "plc-guess", onclick: () => view.onGuess(value) });
  });
  const label = say(ASK_WORDS.showKey, lang);
  const show = button({ icon: "eye", label, text: say(ASK_WORDS.show, lang), onclick: () => view.onShow() });
  view.node.replaceChildren(...guesses, show);
}

/** An empty score; `guesses` remembers for each step whether its last guess was right. */
export function freshScore() {
  return new Map();
}

/** Whether a step forward is worth a question. */
export function isQuestion(film, index) {
  return writesTop(film, index);
}

/** What the top of the first column is called inside a sentence: level 1, the result register. */
function nameOfTop(film, lang) {
  const [column] = film.columns;
  return (column.register && lang === "en" ? "the " : "") + positionName(column, 0, lang);
}

/** The question before a step, with the instruction set as code. @returns {Array<string|Node>} */
export function questionWords(film, index, lang) {
  const level = nameOfTop(film, lang);
  const [before, after] = say(ASK_WORDS.question, lang).replace("{level}", () => level).split("{line}");
  return [before, h("code", { className: "plc-code" }, lineTextAt(film, index)), after];
}

/** Whether a guess is right. */
export function isRight(film, index, guess) {
  return topAt(film, index).value === guess;
}

/** What is said to a guess: right, or not yet and what it is. */
export function verdictWords(film, index, right, lang) {
  if (right) return say(ASK_WORDS.right, lang);
  return say(ASK_WORDS.notYet, lang)
    .replace("{level}", () => nameOfTop(film, lang))
    .replace("{value}", topAt(film, index).value);
}

/** The running count of right guesses. */
export function scoreWords(score, lang) {
  const right = [...score.values()].filter(Boolean).length;
  return say(ASK_WORDS.score, lang).replace("{right}", right).replace("{all}", score.size);
}
