// Knows how lines are put in order: dragged with the pointer or moved with keys, the ones that are not used in a tray.

import { button, h, say } from "./ui.js";
import { movedEntry, orderedLines, orderText, placeAmong } from "./desk-answer.js";

const ROWS_WORDS = {
  answer: { zh: "你的程序", en: "Your program" },
  tray: { zh: "备用的行（有的用不上）", en: "Lines to choose from (some do not belong)" },
  keys: {
    zh: "拖动各行；或用键盘：Enter 取用，Alt+↑/↓ 移动，Delete 放回",
    en: "Drag the lines; or with keys: Enter takes one, Alt+↑/↓ moves it, Delete puts it back",
  },
  empty: { zh: "把第一行拖到这里", en: "Drag the first line here" },
  none: { zh: "全部用上了", en: "All are in use" },
  up: { zh: "上移（Alt+↑）", en: "Up (Alt+↑)" },
  down: { zh: "下移（Alt+↓）", en: "Down (Alt+↓)" },
  back: { zh: "放回（Delete）", en: "Put back (Delete)" },
  line: { zh: "第 {} 行：", en: "Line {}: " },
};
const DRAG_BEGINS = 5;

/** Draws one line; in the answer it has buttons to move it, in the tray a press takes it. */
function rowItem(form, { text, at }, place) {
  const { lang, readOnly } = form.api;
  const used = place >= 0;
  const name = `${used ? say(ROWS_WORDS.line, lang).replace("{}", place + 1) : ""}${text}`;
  const line = h("button", {
    type: "button", className: "plc-line-text", "aria-label": name, disabled: readOnly, dataset: { key: used ? `u${place}` : `t${at}` },
    onclick: () => used || takeLine(form, at),
  }, text);
  const tools = used && !readOnly && [["up", "▲", () => shiftLine(form, place, -1)], ["down", "▼", () => shiftLine(form, place, 1)],
    ["back", "✕", () => putBack(form, place)]].map(([word, sign, onclick]) => {
    const node = button({ label: say(ROWS_WORDS[word], lang), onclick, className: "plc-line-tool" });
    node.replaceChildren(h("span", { "aria-hidden": "true" }, sign));
    node.setAttribute("aria-label", `${say(ROWS_WORDS[word], lang)} ${text}`);
    node.setAttribute("tabindex", "-1");
    return node;
  });
  const node = h("li", { className: "plc-line-row", dataset: { place, at } },
    used && h("span", { className: "plc-line-number", "aria-hidden": "true" }, place + 1), line, tools);
  if (!readOnly) listenToDrag(form, node);
  return node;
}

/** Takes a line from the tray to a place in the answer, its end where none is said. */
function takeLine(form, at, place = form.now.used.length) {
  const line = { text: form.api.task.rows[at], at };
  form.change(movedEntry([...form.now.used, line], form.now.used.length, place), `u${Math.min(place, form.now.used.length)}`);
}

/** Moves a line of the answer up or down. */
function shiftLine(form, place, by) {
  const to = Math.min(Math.max(0, place + by), form.now.used.length - 1);
  form.change(movedEntry(form.now.used, place, to), `u${to}`);
}

/** Puts a line of the answer back into the tray. */
function putBack(form, place) {
  const left = form.now.used.filter((_, at) => at !== place);
  form.change(left, left.length ? `u${Math.min(place, left.length - 1)}` : `t${form.now.used[place].at}`);
}

/** Says where a drag would put its line now: a place in the answer, or -1 for the tray. */
function dropPlace(form, event, node) {
  const tray = form.tray.getBoundingClientRect();
  const inside = event.clientX >= tray.left && event.clientX <= tray.right && event.clientY >= tray.top && event.clientY <= tray.bottom;
  if (inside) return -1;
  const others = [...form.list.querySelectorAll(".plc-line-row")].filter((one) => one !== node);
  return placeAmong(others.map((one) => one.getBoundingClientRect()).map(({ top, height }) => top + height / 2), event.clientY);
}

/** Shows where a line would fall. */
function markDrop(form, node, place) {
  for (const one of form.node.querySelectorAll(".plc-drop, .plc-drop-end")) one.classList.remove("plc-drop", "plc-drop-end");
  form.tray.classList.toggle("plc-drop-tray", place < 0);
  if (place < 0) return;
  const others = [...form.list.querySelectorAll(".plc-line-row")].filter((one) => one !== node);
  if (others[place]) others[place].classList.add("plc-drop");
  else form.list.classList.add("plc-drop-end");
}

/** Lets go of a line where it is. */
function dropLine(form, node, place) {
  const [from, at] = [Number(node.dataset.place), Number(node.dataset.at)];
  if (from < 0) return place < 0 ? form.api.redraw() : takeLine(form, at, place);
  if (place < 0) return putBack(form, from);
  return place === from ? form.api.redraw() : form.change(movedEntry(form.now.used, from, place), `u${place}`);
}

/** Moves a dragged line with the pointer, and shows where it would fall. */
function followPointer(form, node, drag, event) {
  const [dx, dy] = [event.clientX - drag.from[0], event.clientY - drag.from[1]];
  if (!drag.on && Math.hypot(dx, dy) < DRAG_BEGINS) return;
  Object.assign(drag, { on: true, place: dropPlace(form, event, node) });
  node.classList.add("plc-dragged");
  node.style.translate = `${dx}px ${dy}px`;
  markDrop(form, node, drag.place);
}

/** Lets a line be dragged, wherever the pointer goes; a press that does not move stays a press. */
function listenToDrag(form, node) {
  node.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.target.closest(".plc-line-tool")) return;
    const drag = { from: [event.clientX, event.clientY], on: false, place: 0 };
    const listening = new AbortController();
    const listen = (name, act) => globalThis.addEventListener(name, act, { signal: listening.signal });
    const stop = (act) => {
      listening.abort();
      form.tray.classList.remove("plc-drop-tray");
      if (drag.on) act();
    };
    listen("pointermove", (move) => followPointer(form, node, drag, move));
    listen("pointerup", () => stop(() => dropLine(form, node, drag.place)));
    listen("pointercancel", () => stop(() => form.api.redraw()));
  });
}

/** Acts on a key pressed on a line; the notebook around hears nothing of Alt with an arrow. */
function rowKey(form, event) {
  const line = event.target.closest?.(".plc-line-text");
  if (!line || form.api.readOnly) return;
  const place = Number(line.closest(".plc-line-row").dataset.place);
  const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
  if (by && event.altKey && place >= 0) shiftLine(form, place, by);
  else if (by) focusBeside(form, line, by);
  else if (["Delete", "Backspace"].includes(event.key) && place >= 0) putBack(form, place);
  else return;
  event.preventDefault();
  event.stopPropagation();
}

/** Goes to the line above or below, from the answer on into the tray. */
function focusBeside(form, line, by) {
  const lines = [...form.node.querySelectorAll(".plc-line-text")];
  lines[lines.indexOf(line) + by]?.focus();
}

/**
 * Makes the form in which lines are put in order.
 * @param {object} api  {task, lang, readOnly, put(text, key), redraw()}
 */
export function makeRows(api) {
  const title = h("p", { className: "plc-rows-title" });
  const list = h("ol", { className: "plc-rows" });
  const trayTitle = h("p", { className: "plc-rows-title" });
  const tray = h("ul", { className: "plc-rows plc-tray" });
  const keys = h("p", { className: "plc-editor-keys" });
  const node = h("div", { className: "plc-order" }, h("div", {}, title, list), h("div", {}, trayTitle, tray), keys);
  const form = { api, node, list, tray, now: { used: [], tray: [] } };
  form.change = (used, key) => api.put(orderText(used), key);
  node.addEventListener("keydown", (event) => rowKey(form, event));
  const draw = (text) => {
    const { lang, task } = api;
    form.now = orderedLines(text, task.rows);
    title.textContent = say(ROWS_WORDS.answer, lang);
    trayTitle.textContent = say(ROWS_WORDS.tray, lang);
    keys.textContent = api.readOnly ? "" : say(ROWS_WORDS.keys, lang);
    const empty = (word) => h("li", { className: "plc-line-none" }, say(ROWS_WORDS[word], lang));
    list.replaceChildren(...(form.now.used.length ? form.now.used.map((one, at) => rowItem(form, one, at)) : [empty("empty")]));
    tray.replaceChildren(...(form.now.tray.length ? form.now.tray.map((at) => rowItem(form, { text: task.rows[at], at }, -1)) : [empty("none")]));
    list.classList.remove("plc-drop-end");
    trayTitle.hidden = tray.hidden = api.readOnly;
  };
  return { node, draw };
}
