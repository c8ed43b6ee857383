// Knows how to show a plant beside its program: a drawing whose parts light up, move and turn, as Python says; no motion of its own.

import { h, say, svgEl } from "./ui.js";

/** An empty plant. `onPress(symbol, down)` is called when a button in the drawing is pressed or let go. */
export function makePlantView(onPress) {
  const node = h("div", { className: "plc-plant" });
  return { node, parts: new Map(), onPress, items: null };
}

/** Draws a plant once: {svg, title}. */
export function drawPlant(view, plant, lang) {
  const parsed = new DOMParser().parseFromString(plant.svg, "image/svg+xml").documentElement;
  const picture = document.importNode(parsed, true);
  picture.setAttribute("class", "plc-rung plc-plant-picture");
  picture.setAttribute("aria-label", say(plant.title, lang));
  view.parts.clear();
  for (const part of picture.querySelectorAll("[data-part]")) {
    const known = view.parts.get(part.dataset.part) ?? [];
    known.push(part);
    view.parts.set(part.dataset.part, known);
  }
  view.items = svgEl("g", { className: "plc-plant-items" });
  picture.append(view.items);
  view.node.replaceChildren(picture);
}

/** Shows a state of the plant: what is on, what has moved or turned, the things that travel, and words. */
export function showPlant(view, { on = [], move = {}, turn = {}, items = [], text = {} }, lang) {
  const lit = new Set(on);
  for (const [part, groups] of view.parts) {
    const [x, y] = move[part] ?? [0, 0];
    const angle = turn[part] ?? 0;
    for (const group of groups) {
      group.classList.toggle("plc-lit", lit.has(part));
      group.style.transform = x || y || angle ? `translate(${x}px, ${y}px) rotate(${angle}deg)` : "";
      const words = text[part] && group.querySelector("text");
      if (words) words.textContent = say(text[part], lang);
    }
  }
  view.items?.replaceChildren(...items.map(([kind, x, y]) => (
    svgEl("rect", { className: `plc-plant-item plc-plant-${kind}`, x: x - 9, y: y - 14, width: 18, height: 14, rx: 2 })
  )));
}
