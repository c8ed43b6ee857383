// Knows how to show a plant beside its program: a drawing whose parts light up, move and turn, as Python says; no motion of its own.

import { h, keepPointer, say, svgEl } from "./ui.js";

const PLANT_WORDS = {
  wiring: { zh: "按钮和行程开关怎样接", en: "How buttons and limit switches are connected" },
  NO: { zh: "常开触点", en: "normally open contact" },
  NC: { zh: "常闭触点", en: "normally closed contact" },
  both: { zh: "两个方向都动作", en: "acts both ways" },
  up: { zh: "只在前进时动作", en: "acts only going forward" },
  down: { zh: "只在退回时动作", en: "acts only coming back" },
};

/**
 * An empty plant. `onPress(symbol, down)` is called when a button in the drawing is pressed or let go, `onWire(symbol, wired)`
 * when one is wired otherwise.
 */
export function makePlantView(onPress, onWire) {
  const node = h("div", { className: "plc-plant" });
  return { node, parts: new Map(), lit: new Set(), onPress, onWire, items: null };
}

/** Draws a plant once in a language: {svg, title, story, hands, wires}. */
export function drawPlant(view, plant, lang) {
  const parsed = new DOMParser().parseFromString(say(plant.svg, lang), "image/svg+xml").documentElement;
  const picture = document.importNode(parsed, true);
  picture.classList.add("plc-plant-picture");
  picture.setAttribute("role", "group");
  picture.setAttribute("aria-label", say(plant.title, lang));
  view.parts.clear();
  for (const part of picture.querySelectorAll("[data-part]")) {
    const known = view.parts.get(part.dataset.part) ?? [];
    known.push(part);
    view.parts.set(part.dataset.part, known);
    const symbol = bareName(part.dataset.part);
    if (plant.hands[symbol]) listenToHand(view, part, symbol, plant.hands[symbol], lang);
  }
  view.items = svgEl("g", { className: "plc-plant-items" });
  picture.append(view.items);
  view.node.replaceChildren(h("p", { className: "plc-plant-story" }, say(plant.story, lang)), picture, wiring(view, plant, lang));
}

/** A part's name without the sign that says when it is seen. */
function bareName(part) {
  return part.replace(/[+-]$/u, "");
}

/** What is drawn of a button is pressed like one, with the pointer or with Space; a switch stays where it is turned to. */
function listenToHand(view, part, symbol, hand, lang) {
  part.classList.add("plc-plant-hand");
  for (const [name, value] of [["role", "button"], ["tabindex", 0], ["aria-label", `${symbol} ${say(hand, lang)}`]]) part.setAttribute(name, value);
  const down = () => view.onPress(symbol, hand.springs || !view.lit.has(symbol));
  const up = () => hand.springs && view.onPress(symbol, false);
  part.addEventListener("pointerdown", (event) => (keepPointer(part, event), down()));
  for (const name of ["pointerup", "pointercancel"]) part.addEventListener(name, up);
  const isPress = (event) => [" ", "Enter"].includes(event.key) && !event.repeat;
  part.addEventListener("keydown", (event) => isPress(event) && (event.preventDefault(), down()));
  part.addEventListener("keyup", (event) => isPress(event) && up());
}

/** How each button is wired and which way a limit switch acts, to be chosen: a normally closed contact gives 1 at rest. */
function wiring(view, plant, lang) {
  const choice = (ways) => ([symbol, now, what]) => h("label", {}, `${symbol} ${say(what, lang)} `, h(
    "select", { onchange: (event) => view.onWire(symbol, event.target.value) },
    ways.map((one) => h("option", { value: one, selected: one === now }, say(PLANT_WORDS[one], lang))),
  ));
  return h("details", { className: "plc-plant-wiring" }, h("summary", {}, say(PLANT_WORDS.wiring, lang)),
    plant.wires.map(choice(["NO", "NC"])), plant.ways.map(choice(["both", "up", "down"])));
}

/** Shows a state of the plant: what is on, what has moved or turned, the things that travel, and words. */
export function showPlant(view, { on = [], move = {}, turn = {}, items = [], text = {} }, lang) {
  const lit = new Set(on);
  view.lit = lit;
  for (const [part, groups] of view.parts) {
    const name = bareName(part);
    const seen = part.endsWith("+") ? lit.has(name) : !(part.endsWith("-") && lit.has(name)) && !part.startsWith("item:");
    const [x, y] = move[name] ?? [0, 0];
    const angle = turn[part] ?? turn[name] ?? 0;
    for (const group of groups) {
      group.style.display = seen ? "" : "none";
      group.style.transform = x || y || angle ? `translate(${x}px, ${y}px) rotate(${angle}deg)` : "";
      const words = text[name] && group.querySelector("text");
      if (words) words.textContent = say(text[name], lang);
    }
  }
  view.items?.replaceChildren(...items.flatMap(([kind, x, y]) => (view.parts.get(`item:${kind}`) ?? []).map((pattern) => {
    const item = pattern.cloneNode(true);
    item.removeAttribute("data-part");
    item.style.display = "";
    item.style.transform = `translate(${x}px, ${y}px)`;
    return item;
  })));
}
