// Knows how to set the words under the picture: chips of what was read and written, a sentence, a warning, a question.

import { h, icon, say } from "./ui.js";
import { chipsAt, lineTextAt } from "./film.js";
import { questionWords, scoreWords } from "./ask.js";
import { playerWord } from "./transport.js";

/** An empty caption; `answers` (the buttons under a question) stand at its end. */
export function makeCaption(answers) {
  const chips = h("div", { className: "plc-chips" });
  const sentence = h("p", { className: "plc-say" });
  const warning = h("p", { className: "plc-warn", hidden: true });
  const live = h("div", { className: "plc-live", "aria-live": "polite", "aria-atomic": "true" }, sentence, warning);
  const node = h("div", { className: "plc-caption" }, chips, live, answers);
  return { node, chips, sentence, warning, answers };
}

/**
 * Sets the words of a step. `verdict` ({right, text}) comes before the sentence; `score` is the running count or null.
 */
export function showCaption(view, { film, index, lang, verdict, score }) {
  const step = film.steps[index];
  fillChips(view, lineTextAt(film, index), chipsAt(film, index), score, lang);
  const judged = verdict && h(
    "span", { className: `plc-verdict plc-${verdict.right ? "right" : "notyet"}` },
    icon(verdict.right ? "check" : "restart"), " ", verdict.text,
  );
  view.sentence.replaceChildren(...[judged, judged && " ", say(step.say, lang)].filter(Boolean));
  const warn = say(step.warn, lang);
  view.warning.hidden = !warn;
  view.warning.replaceChildren(...(warn ? [icon("flag"), h("strong", {}, playerWord("warn", lang)), " ", warn] : []));
  view.answers.hidden = true;
}

/** Sets a question about a step that is not shown yet: what it reads is given, what comes of it is not. */
export function showQuestion(view, { film, index, lang, score }) {
  const given = chipsAt(film, index).filter((chip) => chip.kind === "read");
  fillChips(view, lineTextAt(film, index), given, score, lang);
  view.sentence.replaceChildren(...questionWords(film, index, lang));
  view.warning.hidden = true;
  view.warning.replaceChildren();
  view.answers.hidden = false;
}

/** Says that there is nothing to show. */
export function showNothing(view, lang) {
  view.chips.replaceChildren();
  view.sentence.replaceChildren(playerWord("none", lang));
  view.warning.hidden = true;
  view.answers.hidden = true;
}

/** The instruction, its chips, and the score at the far end. */
function fillChips(view, text, chips, score, lang) {
  const kind = { 0: "zero", 1: "one" };
  view.chips.replaceChildren(
    ...(text ? [h("span", { className: "plc-when plc-code" }, text)] : []),
    ...chips.map((chip) => h(
      "span", { className: `plc-chip plc-chip-${chip.kind} plc-chip-${kind[chip.value] ?? "unknown"}` }, chip.text,
    )),
    ...(score?.size ? [h("span", { className: "plc-score" }, scoreWords(score, lang))] : []),
  );
}
