// Knows how something is picked: the two blocks that a join connects, in a list; or one of several ladders.

import { h, say } from "./ui.js";
import { blockEnds, blockOf, blockText, choiceLetter, choiceOf, withEnd } from "./desk-answer.js";
import { drawingOf } from "./verdict.js";

const PICK_WORDS = {
  lines: { zh: "程序的各行", en: "The lines of the program" },
  join: { zh: "这条指令连接哪两块？", en: "Which two blocks does this one join?" },
  block: { zh: "第 {} 块", en: "block {}" },
  next: [
    { zh: "点出一个电路块的第一行", en: "Choose the first line of one block" },
    { zh: "再点它的最后一行（只有一行就再点一次）", en: "Now its last line (the same one again if it is alone)" },
    { zh: "点出另一个电路块的第一行", en: "Choose the first line of the other block" },
    { zh: "再点它的最后一行", en: "Now its last line" },
    { zh: "两块都选好了；再点一行就重新开始", en: "Both blocks are chosen; choosing a line begins anew" },
  ],
  choices: { zh: "各个梯形图", en: "The ladders" },
  ladder: { zh: "梯形图 {}", en: "Ladder {}" },
};

/** Draws one line that can be the end of a block. */
function blockLine(form, text, at) {
  const { lang, readOnly, task } = form.api;
  const block = blockOf(form.ends, at);
  const asked = task.row === at;
  const said = [`${at} ${text}`, block && say(PICK_WORDS.block, lang).replace("{}", block), asked && say(PICK_WORDS.join, lang)];
  const line = h("button", {
    type: "button", className: "plc-join-line", disabled: readOnly, dataset: { key: `b${at}`, at },
    "aria-label": said.filter(Boolean).join(", "), "aria-pressed": String(block > 0),
    onclick: () => form.api.put(blockText(withEnd(form.ends, at)), `b${at}`),
  }, h("span", { className: "plc-line-number" }, at), h("code", {}, text),
  h("span", { className: "plc-join-name" }, block > 0 && say(PICK_WORDS.block, lang).replace("{}", block), asked && say(PICK_WORDS.join, lang)));
  const same = (other) => block > 0 && blockOf(form.ends, other) === block;
  const edges = block > 0 && [!same(at - 1) && "plc-join-first", !same(at + 1) && "plc-join-last"];
  const names = ["plc-join-row", block && `plc-join-${block}`, asked && "plc-join-asked", ...(edges || [])];
  return h("li", { className: names.filter(Boolean).join(" ") }, line);
}

/** Goes up and down through the lines with the arrow keys. */
function blockKey(form, event) {
  const line = event.target.closest?.(".plc-join-line");
  const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
  if (!line || !by || event.altKey) return;
  const lines = [...form.node.querySelectorAll(".plc-join-line")];
  lines[lines.indexOf(line) + by]?.focus();
  event.preventDefault();
}

/**
 * Makes the form in which the two blocks of a join are picked.
 * @param {object} api  {task, lang, readOnly, put(text, key)}
 */
export function makeBlocks(api) {
  const list = h("ol", { className: "plc-joins" });
  const next = h("p", { className: "plc-editor-keys", role: "status" });
  const node = h("div", { className: "plc-joins-box" }, next, list);
  const form = { api, node, ends: [] };
  node.addEventListener("keydown", (event) => blockKey(form, event));
  const draw = (text) => {
    form.ends = blockEnds(text, api.task.rows.length);
    next.textContent = api.readOnly ? "" : say(PICK_WORDS.next[form.ends.length], api.lang);
    list.setAttribute("aria-label", say(PICK_WORDS.lines, api.lang));
    list.replaceChildren(...api.task.rows.map((row, at) => blockLine(form, row, at + 1)));
  };
  return { node, draw };
}

let choiceGroups = 0;

/** Draws one of the ladders as a card with its letter. */
function choiceCard(form, drawing, at) {
  const { lang, readOnly } = form.api;
  const input = h("input", {
    type: "radio", name: form.name, value: choiceLetter(at), disabled: readOnly, dataset: { key: `r${at}` },
    onchange: () => form.api.put(choiceLetter(at), `r${at}`),
  });
  const svg = drawingOf(say(drawing, lang));
  const name = say(PICK_WORDS.ladder, lang).replace("{}", choiceLetter(at));
  svg?.setAttribute("role", "img");
  svg?.setAttribute("aria-label", name);
  const scroll = h("span", { className: "plc-scroll" }, svg);
  return h("label", { className: "plc-choice-card" }, h("span", { className: "plc-choice-head" }, input, h("strong", {}, name)), scroll);
}

/**
 * Makes the form in which one of several ladders is picked.
 * @param {object} api  {task, lang, readOnly, put(text, key)}
 */
export function makeChoice(api) {
  const node = h("div", { className: "plc-choice-cards", role: "radiogroup" });
  const form = { api, name: `plc-choice-${(choiceGroups += 1)}` };
  let drawn = "";
  const draw = (text) => {
    const chosen = choiceOf(text, api.task.choices.length);
    node.setAttribute("aria-label", say(PICK_WORDS.choices, api.lang));
    if (drawn !== api.lang) node.replaceChildren(...api.task.choices.map((one, at) => choiceCard(form, one, at)));
    drawn = api.lang;
    [...node.querySelectorAll("input")].forEach((input, at) => (input.checked = at === chosen));
  };
  return { node, draw };
}
