// Knows how to draw the stack of one step and to move its cells to the next; not what any instruction means.

import { h, say } from "./ui.js";
import { cellsAt, describeCell, describePicture, levelOf, levelWords, shortenText, tagsOf } from "./film.js";
import { layoutOf, placeOf, tracksBetween } from "./motion.js";

const STACK_WORDS = {
  top: { zh: "栈顶", en: "top" },
  bottom: { zh: "栈底", en: "bottom" },
  more: { zh: "… 共 {} 层", en: "… of {}" },
};
const EASE = "cubic-bezier(.35, 0, .2, 1)";
const LONGEST_FORMULA = 240;

/**
 * A face is the drawn side of one cell.
 * @typedef {{node: HTMLElement, value: HTMLElement, name: HTMLElement, formula: HTMLElement, tag: HTMLElement,
 *   worn: string}} Face
 */

/** An empty stack picture; `view.node` goes into the page. */
export function makeStackView() {
  const backdrop = h("div", { className: "plc-backdrop" });
  const layer = h("div", { className: "plc-layer" });
  const next = h("div", { className: "plc-future", hidden: true });
  const stage = h("div", { className: "plc-stage", role: "img" }, backdrop, layer, next);
  const legend = h("p", { className: "plc-legend", hidden: true });
  const node = h("div", { className: "plc-stack" }, stage, legend);
  return {
    node, stage, backdrop, layer, next, legend,
    film: null, layout: null, lang: "zh", wanted: { formulas: false, names: false },
    faces: new Map(), running: [],
  };
}

/** Takes another film: forgets all cells; `translateStack` draws the empty columns. `options`: see `layoutOf`. */
export function buildStack(view, film, options) {
  settle(view);
  Object.assign(view, { film, layout: layoutOf(film, options) });
  for (const face of view.faces.values()) face.node.remove();
  view.faces.clear();
  const { width, height, foot } = view.layout;
  view.stage.classList.toggle("plc-several", width > 1);
  view.node.style.setProperty("--plc-columns", width);
  view.node.style.setProperty("--plc-rows", height);
  view.node.style.setProperty("--plc-foot", foot);
}

/** Draws captions, level labels, slots and the words for the letters on cells in one language. */
export function translateStack(view, lang) {
  view.lang = lang;
  for (const face of view.faces.values()) face.worn = "";
  view.backdrop.replaceChildren(...view.film.columns.flatMap((_, at) => columnBackdrop(view, at)));
  const tags = tagsOf(view.film, lang);
  view.legend.hidden = !tags.length;
  view.legend.replaceChildren(...tags.flatMap(([tag, word], at) => [at ? " · " : "", h("b", {}, tag), ` ${word}`]));
}

/** Chooses whether cells show formulas and names, and whether room is kept for questions. */
export function setWanted(view, { formulas, names, asking }) {
  view.wanted = { formulas, names };
  view.stage.classList.toggle("plc-with-formulas", formulas);
  view.stage.classList.toggle("plc-with-names", names);
  view.stage.classList.toggle("plc-asking", asking);
}

/** Something of the backdrop at a place, as wide as a column with its labels. */
function placedAt({ x, y }, className, ...children) {
  return h("div", { className: `plc-placed ${className}`, style: { transform: shift(x, y) } }, ...children);
}

/** The quiet parts of one column: caption, slots with their labels, and the mark of the bottom. */
function columnBackdrop(view, at) {
  const { film, layout, lang } = view;
  const column = film.columns[at];
  const place = layout.columns[at];
  const parts = [];
  if (column.register) {
    parts.push(captionOf(place.x, place.register, "", say(column.register, lang)));
    parts.push(placedAt({ x: place.x, y: place.register }, "plc-row plc-row-register", emptySlot()));
  }
  if (!place.levels) return parts;
  if (!layout.joined) parts.push(captionOf(place.x, place.first, say(STACK_WORDS.top, lang), say(column.title, lang)));
  for (let level = 0; level < place.levels; level += 1) {
    const at = { x: place.x, y: place.first + level };
    parts.push(placedAt(at, "plc-row", levelLabel(level + 1, lang), emptySlot()));
  }
  return [...parts, footOf(column, place, lang)];
}

/** The quiet outline of an unused level. */
function emptySlot() {
  return h("span", { className: "plc-slot" });
}

/** A caption stands on the row below it. */
function captionOf(x, y, mark, title) {
  return placedAt(
    { x, y }, "plc-caption-row",
    h("span", { className: "plc-label" }, mark), h("span", { className: "plc-column-title" }, title),
  );
}

/** The mark of the bottom, or how many levels there are in all. */
function footOf(column, place, lang) {
  const bottom = place.more ? "" : say(STACK_WORDS.bottom, lang);
  const levels = levelOf(column, column.depth - 1);
  const hint = place.more ? say(STACK_WORDS.more, lang).replace("{}", levels) : "";
  return placedAt(
    { x: place.x, y: place.end }, "plc-foot-row",
    h("span", { className: "plc-label" }, bottom), h("span", { className: "plc-hint" }, hint),
  );
}

/** 第3层 or level 3; on narrow figures the style sheet leaves only the number. */
function levelLabel(level, lang) {
  const [before, after] = levelWords(lang);
  const word = (text) => text && h("span", { className: "plc-word" }, text);
  return h("span", { className: "plc-label" }, word(before), String(level), word(after));
}

/** A translation counted in columns and rows. */
function shift(x, y) {
  return `translate(calc(var(--plc-pitch) * ${round(x)}), calc(var(--plc-row) * ${round(y)}))`;
}

/** Three decimals are enough for a place. */
function round(number) {
  return Math.round(number * 1000) / 1000;
}

/** Shows a step; from a neighbouring one the cells move there in `ms` milliseconds, from afar they just stand there. */
export function showStack(view, index, from, ms) {
  const { film, layout } = view;
  const tracks = ms > 0 ? tracksBetween(film, layout, from, index) : null;
  const now = tracks ? whereabouts(view) : new Map();
  settle(view);
  const ghosts = tracks ? tracks.filter((track) => !track.stays).map((track) => [track, ghostOf(view, track)]) : [];
  const cells = cellsAt(film, index);
  dropFaces(view, new Set(cells.map((cell) => cell.key)));
  for (const cell of cells) standFace(view, cell);
  view.stage.setAttribute("aria-label", describePicture(film, index, view.lang, view.wanted));
  if (!tracks) return;
  for (const track of tracks) {
    if (track.stays) animateFace(view, view.faces.get(track.key).node, track, ms, now.get(track.key));
  }
  for (const [track, node] of ghosts) animateFace(view, node, track, ms, now.get(track.key));
}

/** Where cells are on the screen while they move, so that the next motion can set out from there. */
function whereabouts(view) {
  const now = new Map();
  for (const { key, node, turns } of view.running) {
    if (turns) continue;
    const { transform, opacity } = getComputedStyle(node);
    now.set(key, { transform, opacity });
  }
  return now;
}

/** Ends all motion at once: every cell stands in its place, those that leave are gone. */
export function settle(view) {
  for (const { animation, node, ghost } of view.running) {
    animation.cancel();
    if (ghost) node.remove();
  }
  view.running = [];
}

/** Takes away the cells that the step does not have. */
function dropFaces(view, keys) {
  for (const [key, face] of view.faces) {
    if (keys.has(key)) continue;
    face.node.remove();
    view.faces.delete(key);
  }
}

/** A cell that is only seen during the motion: one that leaves, or the old face of one that flips. */
function ghostOf(view, track) {
  const face = makeFace();
  dressFace(face, track.cell, view.lang);
  face.node.classList.add("plc-ghost");
  view.layer.append(face.node);
  return face.node;
}

/** Puts a cell of the step into its place, new or not. */
function standFace(view, cell) {
  let face = view.faces.get(cell.key);
  if (!face) {
    face = makeFace();
    view.faces.set(cell.key, face);
    view.layer.append(face.node);
  }
  dressFace(face, cell, view.lang);
  const { x, y } = placeOf(view.layout, cell.column, cell.position);
  face.node.style.transform = shift(x, y);
}

/** An undressed cell. @returns {Face} */
function makeFace() {
  const part = (name) => h("span", { className: `plc-${name}` });
  const face = { value: part("value"), name: part("name"), formula: part("formula"), tag: part("tag"), worn: "" };
  return { ...face, node: h("div", { className: "plc-cell" }, face.tag, face.value, face.name, face.formula) };
}

/** Gives a cell its value, words and marks, if they are not the ones it wears. */
function dressFace(face, cell, lang) {
  const clothes = [cell.value, cell.name, cell.spent, cell.foreign, cell.unused, cell.tag, lang, cell.formula].join("\n");
  if (face.worn === clothes) return;
  face.worn = clothes;
  const kind = { 0: "zero", 1: "one" }[cell.value] ?? "unknown";
  const marks = [["plc-spent", cell.spent], ["plc-foreign", cell.foreign], ["plc-tagged", cell.tag], ["plc-unused", cell.unused]];
  face.node.className = `plc-cell plc-${kind}`;
  for (const [mark, on] of marks) face.node.classList.toggle(mark, Boolean(on));
  face.node.title = describeCell(cell, lang, { formulas: true, names: true });
  face.value.textContent = cell.value;
  face.name.textContent = cell.name;
  face.formula.textContent = shortenText(cell.formula, LONGEST_FORMULA);
  face.tag.textContent = cell.tag;
}

/** Moves one cell along its track with a single animation. */
function animateFace(view, node, track, ms, now) {
  const turns = track.frames.some((one) => one.turn !== 0);
  const fades = now || track.frames.some((one) => one.alpha !== 1);
  if (!now && !turns && !fades && isStill(track.frames)) return;
  const frames = track.frames.map(({ x, y, alpha, turn, offset }) => ({
    offset,
    transform: shift(x, y) + (turns ? ` perspective(20em) rotateX(${turn}deg)` : ""),
    ...(fades ? { opacity: alpha } : {}),
  }));
  if (now && !turns) Object.assign(frames[0], now);
  const ghost = !track.stays;
  const animation = node.animate(frames, { duration: ms, easing: EASE, fill: ghost ? "both" : "none" });
  node.classList.toggle("plc-moving", true);
  const entry = { key: track.key, node, ghost, turns, animation };
  view.running.push(entry);
  animation.onfinish = () => finish(view, entry);
}

/** Whether nothing moves. */
function isStill(frames) {
  return frames.every((one) => one.x === frames[0].x && one.y === frames[0].y);
}

/** Puts a motion away when it is over. */
function finish(view, entry) {
  view.running = view.running.filter((other) => other !== entry);
  entry.node.classList.remove("plc-moving");
  if (entry.ghost) entry.node.remove();
}

/** Shows a column beside the first one for the picture to come, with "?" for its top; or hides it again. */
export function showNext(view, caption) {
  view.next.hidden = caption === null;
  if (caption === null) return;
  const place = view.layout.columns[0];
  const top = place.register ?? place.first;
  const levels = Array.from({ length: place.levels }, (_, level) => place.first + level);
  const asked = h("div", { className: "plc-cell plc-asked" }, h("span", { className: "plc-value" }, "?"));
  asked.style.transform = shift(0, top);
  view.next.replaceChildren(
    placedAt({ x: 0, y: top }, "plc-caption-row", h("span", { className: "plc-column-title plc-code" }, caption)),
    ...levels.map((y) => placedAt({ x: 0, y }, "plc-row", emptySlot())),
    asked,
  );
}
