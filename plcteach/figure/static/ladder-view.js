// Knows how to show a ladder beside its list: which signs are drawn already, which carry power, and which belong to a line.

import { h, say, svgEl } from "./ui.js";
import { builtAt, executedAt, linesOfPart, litAt, netOf, wiresBuilt } from "./ladder-shape.js";

const LADDER_WORDS = {
  ladder: { zh: "梯形图", en: "Ladder diagram" },
  lines: { zh: "{part}：第 {} 行", en: "{part}: line {}" },
};
const MARGIN = 4;
const SIDE = 24;

/**
 * An empty ladder. `onLine(line)` is called when a sign is chosen, `onPoint(lines)` while one is pointed at (none: []).
 */
export function makeLadderView(onLine, onPoint) {
  const scroller = h("div", { className: "plc-rungs" });
  const notes = h("div", { className: "plc-rung-notes", hidden: true });
  const node = h("section", { className: "plc-ladder-view", hidden: true }, scroller, notes);
  const view = { node, scroller, notes, film: null, parts: new Map(), rungs: [], line: -1, pointed: null, index: -1, onLine, onPoint };
  const partOf = (target) => target.closest?.("[data-part^=s]")?.dataset.part;
  scroller.addEventListener("pointerover", (event) => pointPart(view, partOf(event.target)));
  scroller.addEventListener("pointerleave", () => pointPart(view, undefined));
  scroller.addEventListener("focusin", (event) => pointPart(view, partOf(event.target)));
  scroller.addEventListener("focusout", () => pointPart(view, undefined));
  scroller.addEventListener("click", (event) => choosePart(view, partOf(event.target)));
  scroller.addEventListener("keydown", (event) => walkParts(view, event));
  return view;
}

/** Draws the rungs of a film, once; `shown`: whether the reader wants them, `formulas`: with each output's formula. */
export function buildLadder(view, film, lang, { shown, formulas }) {
  Object.assign(view, { film, parts: new Map(), rungs: [], line: -1, pointed: null, index: -1 });
  const ladder = film?.ladder;
  view.node.hidden = !ladder || !shown;
  if (!ladder) return view.scroller.replaceChildren();
  view.node.setAttribute("aria-label", [say(LADDER_WORDS.ladder, lang), say(film.title, lang)].filter(Boolean).join(": "));
  view.scroller.replaceChildren(...ladder.rungs.map((rung, at) => rungBlock(view, rung, at, formulas)));
  view.notes.hidden = !ladder.notes.length;
  view.notes.replaceChildren(...ladder.notes.map((note) => h("p", {}, say(note, lang))));
  nameParts(view, lang);
}

/** One rung: its title, its picture and, where wanted, the formulas of its outputs. */
function rungBlock(view, rung, at, formulas) {
  const parsed = new DOMParser().parseFromString(rung.svg, "image/svg+xml").documentElement;
  const picture = document.importNode(parsed, true);
  picture.setAttribute("class", "plc-rung");
  picture.style.setProperty("--plc-wide", picture.getAttribute("width"));
  const marks = svgEl("g", { className: "plc-rung-marks", "aria-hidden": "true" });
  picture.prepend(marks);
  for (const part of picture.querySelectorAll("[data-part]")) {
    const known = view.parts.get(part.dataset.part);
    if (known) known.push(part);
    else view.parts.set(part.dataset.part, [part]);
  }
  view.rungs.push({ picture, marks });
  const said = formulas && rung.formulas.map(([word, text]) => h("div", {}, h("b", {}, word), ` = ${text}`));
  return h("div", { className: "plc-rung-block", dataset: { rung: at } },
    h("span", { className: "plc-rung-number", "aria-hidden": "true" }, String(at + 1)),
    h("div", { className: "plc-rung-body" }, rung.title && h("div", { className: "plc-rung-title" }, rung.title), picture,
      said && h("div", { className: "plc-rung-formulas" }, said)));
}

/** Makes every sign one that can be pointed at with the keys too, and says to which lines it belongs. */
function nameParts(view, lang) {
  let first = true;
  for (const [part, groups] of view.parts) {
    if (!part.startsWith("s")) continue;
    const numbers = linesOfPart(view.film, part).map((line) => view.film.lines[line]?.number ?? view.film.lines[line]?.row ?? line + 1);
    const words = groups[0].textContent.trim() || "NOT";
    const label = say(LADDER_WORDS.lines, lang).replace("{part}", words).replace("{}", numbers.join(", "));
    for (const [name, value] of [["role", "button"], ["aria-label", label], ["tabindex", first ? 0 : -1]]) groups[0].setAttribute(name, value);
    first = false;
  }
}

/** Shows a step: what this scan has executed so far, where power is, and what its line has drawn or joined. */
export function showLadder(view, index) {
  const { film } = view;
  if (!film?.ladder || view.node.hidden) return;
  const built = builtAt(film, index);
  const wires = wiresBuilt(film, built, executedAt(film, index));
  paintParts(view, (part) => (part.startsWith("s") ? built.has(part) : wires.has(part)), litAt(film, index));
  Object.assign(view, { line: film.steps[index].line, index });
  markLadder(view, view.line);
  keepInSight(view);
}

/** Shows which parts are there and which carry power; a wire that is not there carries none. */
function paintParts(view, isThere, lit) {
  for (const [part, groups] of view.parts) {
    const there = isThere(part);
    const on = there && lit.has(netOf(part));
    for (const group of groups) {
      group.classList.toggle("plc-unbuilt", !there);
      group.classList.toggle("plc-lit", on);
    }
  }
}

/** Shows a whole ladder with its power, as it runs: nothing is being built, no line is marked. */
export function lightLadder(view, lit) {
  if (view.node.hidden) return;
  paintParts(view, () => true, lit);
}

/** Points at a line of the list: its signs are marked instead of those of the step; null: at none. */
export function pointLadder(view, line) {
  if (!view.film?.ladder || view.node.hidden) return;
  markLadder(view, line ?? view.line);
}

/** Marks what a line has drawn, what the top then stands for, and the two blocks of a join. */
function markLadder(view, line) {
  const told = view.film.ladder.growth[line] ?? {};
  for (const { marks } of view.rungs) marks.replaceChildren();
  mark(view, told.top ?? [], "plc-mark-top");
  (told.blocks ?? []).forEach((block, at) => mark(view, block, `plc-mark-block plc-mark-block-${at + 1}`));
  mark(view, told.added ?? [], "plc-mark-new");
}

/** Draws a frame around some signs, one in each rung that they stand in. */
function mark(view, parts, className) {
  const frames = new Map();
  for (const part of parts) {
    const rung = Number(part.slice(1).split("-")[0]);
    for (const group of view.parts.get(part) ?? []) frames.set(rung, joined(frames.get(rung), group.getBBox()));
  }
  for (const [rung, box] of frames) {
    view.rungs[rung].marks.append(svgEl("rect", {
      className, rx: 4, x: box.left - MARGIN, y: box.top - MARGIN,
      width: box.right - box.left + 2 * MARGIN, height: box.bottom - box.top + 2 * MARGIN,
    }));
  }
}

/** The smallest frame around a frame and a box. */
function joined(frame, { x, y, width, height }) {
  const box = { left: x, top: y, right: x + width, bottom: y + height };
  if (!frame) return box;
  return {
    left: Math.min(frame.left, box.left), top: Math.min(frame.top, box.top),
    right: Math.max(frame.right, box.right), bottom: Math.max(frame.bottom, box.bottom),
  };
}

/** Scrolls the rungs (never the page) so that what the line has drawn can be seen. */
function keepInSight(view) {
  const { scroller, film, line } = view;
  const told = film.ladder.growth[line];
  const part = told?.added?.at(-1) ?? told?.top?.at(-1);
  const group = view.parts.get(part)?.[0];
  if (!group) return;
  const [frame, sign] = [scroller.getBoundingClientRect(), group.getBoundingClientRect()];
  const block = group.closest(".plc-rung-block").getBoundingClientRect();
  const tall = block.height <= frame.height ? block : sign;
  scroller.scrollTop += outside(tall.top - frame.top, tall.bottom - frame.bottom);
  scroller.scrollLeft += outside(sign.left - frame.left - SIDE, sign.right - frame.right + SIDE);
}

/** How far to scroll so that neither the near nor the far side lies outside. */
function outside(near, far) {
  return near < 0 ? near : Math.max(0, far);
}

/** Points at a sign: the host marks its lines. */
function pointPart(view, part) {
  if (part === view.pointed) return;
  for (const group of view.parts.get(view.pointed) ?? []) group.classList.remove("plc-pointed");
  for (const group of view.parts.get(part) ?? []) group.classList.add("plc-pointed");
  view.pointed = part;
  view.onPoint(part ? linesOfPart(view.film, part) : []);
}

/** Goes to the line that has drawn a sign. */
function choosePart(view, part) {
  const [line] = part ? linesOfPart(view.film, part) : [];
  if (line !== undefined) view.onLine(line);
}

/** Left and right walk from sign to sign; Enter or Space goes to its line. */
function walkParts(view, event) {
  const here = event.target.closest?.("[data-part^=s]");
  if (!here) return;
  const signs = [...view.parts].filter(([part]) => part.startsWith("s")).map(([, groups]) => groups[0]);
  const way = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
  if (way) {
    const next = signs[Math.max(0, Math.min(signs.length - 1, signs.indexOf(here) + way))];
    here.setAttribute("tabindex", -1);
    next.setAttribute("tabindex", 0);
    next.focus();
  } else if (event.key === "Enter" || event.key === " ") choosePart(view, here.dataset.part);
  else return;
  event.preventDefault();
  event.stopPropagation();
}
