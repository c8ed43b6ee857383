// Knows the switches and lamps of a live bench: buttons that are on while they are held, latches, lamps and words.

import { h, keepPointer, say } from "./ui.js";

const IO_WORDS = {
  inputs: { zh: "输入", en: "Inputs" },
  lamps: { zh: "输出与标志", en: "Outputs and flags" },
  words: { zh: "字", en: "Words" },
  push: { zh: "{}：按住为1（数字键 {n}）", en: "{}: 1 while held (key {n})" },
  latch: { zh: "{}：保持为1", en: "{}: keep at 1" },
  forced: { zh: "强制", en: "forced" },
  free: { zh: "{}：取消强制", en: "{}: no longer forced" },
};
const KEYS = 9;

/**
 * The inputs of a bench. `onSet(address, value)` sets one, `onFree(address)` gives it back to the plant.
 */
export function makeInputs(onSet, onFree) {
  const title = h("span", { className: "plc-io-title" });
  const list = h("div", { className: "plc-live-inputs" });
  const node = h("div", { className: "plc-io", role: "group" }, title, list);
  return { node, title, list, parts: new Map(), onSet, onFree, pressed: new Set() };
}

/** Draws one push-button and one latch for each input. */
export function buildInputs(view, inputs, lang) {
  view.title.textContent = say(IO_WORDS.inputs, lang);
  view.node.setAttribute("aria-label", say(IO_WORDS.inputs, lang));
  view.node.hidden = !inputs.length;
  view.parts.clear();
  view.list.replaceChildren(...inputs.map((input, at) => inputPart(view, input, at, lang)));
}

/** One input: a button that is on while it is held, a latch beside it, and the way back to the plant. */
function inputPart(view, { address, name }, at, lang) {
  const number = at < KEYS ? String(at + 1) : "–";
  const label = (key) => say(IO_WORDS[key], lang).replace("{}", name ? `${address} ${name}` : address).replace("{n}", number);
  const value = h("span", { className: "plc-live-value" });
  const push = h("button", { type: "button", className: "plc-live-push", "aria-label": label("push"), title: label("push"), "aria-pressed": false },
    value, h("span", { className: "plc-address" }, address), name && h("span", { className: "plc-live-name-of" }, name));
  const latch = h("button", { type: "button", className: "plc-live-latch", role: "switch", "aria-label": label("latch"), title: label("latch"), "aria-checked": false },
    h("span", { className: "plc-switch-track", "aria-hidden": "true" }, h("span", { className: "plc-switch-knob" })));
  const free = h("button", { type: "button", className: "plc-live-free", title: label("free"), "aria-label": label("free"), hidden: true }, say(IO_WORDS.forced, lang));
  const part = { push, latch, free, value, latched: false };
  view.parts.set(address, part);
  listenToPush(view, address, part);
  latch.addEventListener("click", () => setLatch(view, address, part, !part.latched));
  free.addEventListener("click", () => (setLatch(view, address, part, false), view.onFree(address)));
  return h("div", { className: "plc-live-input" }, push, latch, free);
}

/** A push-button is on from pressing to letting go, with the pointer, Space or Enter. */
function listenToPush(view, address, part) {
  const down = (event) => {
    if (event.repeat) return;
    event.preventDefault();
    part.push.focus({ preventScroll: true });
    holdInput(view, address, true);
  };
  const up = () => holdInput(view, address, false);
  part.push.addEventListener("pointerdown", (event) => (keepPointer(part.push, event), down(event)));
  for (const name of ["pointerup", "pointercancel", "blur"]) part.push.addEventListener(name, up);
  part.push.addEventListener("keydown", (event) => [" ", "Enter"].includes(event.key) && down(event));
  part.push.addEventListener("keyup", (event) => [" ", "Enter"].includes(event.key) && up());
}

/** Holds an input or lets it go; a latched one stays on. */
function holdInput(view, address, on) {
  const part = view.parts.get(address);
  if (!part || view.pressed.has(address) === on || (on && part.push.disabled)) return;
  if (on) view.pressed.add(address);
  else view.pressed.delete(address);
  part.push.setAttribute("aria-pressed", String(on));
  if (!part.latched) view.onSet(address, on ? 1 : 0);
}

/** Latches an input at 1, or releases it. */
function setLatch(view, address, part, on) {
  part.latched = on;
  part.latch.setAttribute("aria-checked", String(on));
  if (!view.pressed.has(address)) view.onSet(address, on ? 1 : 0);
}

/** Lets the switches stand as the kernel holds them; while a recording runs, nobody can press them. */
export function syncLatches(view, held, taped) {
  for (const [address, part] of view.parts) {
    part.latched = !taped && held.includes(address);
    part.latch.setAttribute("aria-checked", String(part.latched));
    for (const one of [part.push, part.latch, part.free]) one.disabled = taped;
  }
}

/** The address of the input that a number key holds. */
function inputOfKey(view, key) {
  return /^[1-9]$/u.test(key) ? [...view.parts.keys()][Number(key) - 1] : undefined;
}

/** The number keys hold the first nine inputs, but not while the focus is in `stage`, where the player has them. Returns the undo. */
export function listenToNumbers(view, figure, stage) {
  const hold = (on) => (event) => {
    if (event.repeat || event.target.closest("input, select, textarea") || stage.contains(event.target)) return;
    const address = inputOfKey(view, event.key);
    if (address) holdInput(view, address, on);
  };
  const [down, up] = [hold(true), hold(false)];
  figure.addEventListener("keydown", down);
  figure.addEventListener("keyup", up);
  return () => {
    figure.removeEventListener("keydown", down);
    figure.removeEventListener("keyup", up);
  };
}

/** Shows the values that the program sees, and which are forced. */
export function showInputs(view, bits, forced) {
  for (const [address, part] of view.parts) {
    const value = bits[address] ?? "0";
    if (part.value.textContent !== value) {
      part.value.textContent = value;
      part.push.dataset.value = value;
    }
    part.free.hidden = !forced.includes(address);
  }
}

/** Lamps or words, in a row under a title. */
export function makeShows(kind) {
  const title = h("span", { className: "plc-io-title" });
  const list = h("ul", { className: "plc-io-list" });
  return { node: h("div", { className: `plc-io plc-live-${kind}` }, title, list), title, list, kind, parts: new Map() };
}

/** Draws one lamp or one number for each address. */
export function buildShows(view, things, lang) {
  const words = say(IO_WORDS[view.kind], lang);
  view.title.textContent = words;
  view.list.setAttribute("aria-label", words);
  view.node.hidden = !things.length;
  view.parts.clear();
  view.list.replaceChildren(...things.map(({ address, name }) => {
    const value = h("span", { className: view.kind === "words" ? "plc-live-digits" : "plc-lamp-bulb" });
    view.parts.set(address, value);
    return h("li", { className: "plc-lamp" }, h("span", { className: "plc-address" }, address), value, name && h("span", { className: "plc-live-name-of" }, name));
  }));
}

/** Shows values. */
export function showShows(view, values) {
  for (const [address, node] of view.parts) {
    const value = String(values[address] ?? "0");
    if (node.textContent === value) continue;
    node.textContent = value;
    node.dataset.value = value;
  }
}
