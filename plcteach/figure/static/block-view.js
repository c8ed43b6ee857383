// Knows how to draw function blocks beside the stack and to change them in place, so that what moves is seen moving.

import { h, prefersReducedMotion, say } from "./ui.js";
import { BITS_IN_A_ROW, blockWord, buildOf, carryBeads, countSlots, countWords, describeBlock, pinState, pinsAt, placedSlots, spotOf, wordOf } from "./block-shape.js";

const BLOCK_MS = 480;
const STEPS_IN_A_ROW = 9;

/**
 * Puts a list of blocks into `root`, hidden while there are none.
 * @param {HTMLElement} root
 * @returns {{show: (faces: object[], lang: string, how?: {animate?: boolean, ms?: number,
 *   rooms?: Object<string, number>}) => void, destroy: () => void}}
 */
export function mountBlocks(root, lang) {
  const blocks = { root, lang, views: new Map(), made: 0, timer: null };
  root.classList.add("plc-blocks");
  root.setAttribute("role", "group");
  showBlocks(blocks, [], lang, {});
  return {
    show: (faces, wanted, how = {}) => showBlocks(blocks, faces, wanted, how),
    destroy: () => {
      sweepBlocks(blocks);
      root.replaceChildren();
    },
  };
}

/** Shows the faces: a block that is built alike keeps its nodes and only changes its values. */
function showBlocks(blocks, faces, lang, { animate = false, ms = BLOCK_MS, rooms = {} }) {
  const { root, views } = blocks;
  const moves = animate && !prefersReducedMotion();
  sweepBlocks(blocks);
  root.hidden = !faces.length;
  root.setAttribute("aria-label", blockWord("blocks", lang));
  root.style.setProperty("--plc-block-ms", moves ? `${Math.round(ms)}ms` : "0ms");
  const changed = [];
  for (const face of faces) {
    const view = viewOfBlock(blocks, face, rooms[face.address]);
    if (view.face === face && view.lang === lang) continue;
    if (view.face) changed.push(view);
    dressBlock(blocks, view, face, lang, moves);
  }
  const wanted = new Set(faces.map((face) => face.address));
  for (const [address, view] of views) {
    if (wanted.has(address)) continue;
    view.node.remove();
    views.delete(address);
  }
  if (moves) blocks.timer = setTimeout(() => sweepBlocks(blocks), ms + 60);
  if (overflows(root)) root.tabIndex = 0;
  else root.removeAttribute("tabindex");
  if (blocks.lang === lang) bringIntoView(root, changed.map((view) => view.node));
  blocks.lang = lang;
}

/** Takes away what was only seen while it left. */
function sweepBlocks(blocks) {
  clearTimeout(blocks.timer);
  for (const node of blocks.root.querySelectorAll(".plc-bead-leaving")) node.remove();
}

/** The view of a block, built anew where it must be. */
function viewOfBlock(blocks, face, room) {
  const known = blocks.views.get(face.address);
  const build = known?.face === face ? known.build : buildOf(face, room);
  if (known?.build === build) return known;
  const view = { build, face: null, lang: "", beads: [], faces: new Map(), ...buildBlock(face, room) };
  if (known) known.node.replaceWith(view.node);
  else blocks.root.append(view.node);
  blocks.views.set(face.address, view);
  return view;
}

/** Whether the panel has more than it can show; then it can be reached and scrolled with the keyboard too. */
function overflows(root) {
  return root.scrollHeight > root.clientHeight + 1;
}

/** Scrolls the panel, never the page, to the first block that has changed, if none of them can be seen. */
function bringIntoView(root, nodes) {
  if (!nodes.length || !overflows(root)) return;
  const seen = (node) => node.offsetTop < root.scrollTop + root.clientHeight - 40 && node.offsetTop + node.offsetHeight > root.scrollTop + 40;
  if (!nodes.some(seen)) root.scrollTop = nodes[0].offsetTop - 10;
}

/** The nodes of a block without its values. */
function buildBlock(face, room) {
  const title = h("span", { className: "plc-block-title" });
  const head = h("div", { className: "plc-block-head" }, h("b", { className: "plc-code" }, face.address), title);
  const sides = { inputs: buildPins(face, "inputs"), outputs: buildPins(face, "outputs") };
  const note = h("p", { className: "plc-block-note" });
  const gauge = face.gauge && buildGauge();
  const drum = face.grid && buildDrum(face.grid);
  const row = face.slots && buildRow(face, room);
  const inside = h("div", { className: "plc-block-inside" }, gauge?.node, drum?.node, row?.node);
  const frame = h(
    "div", { className: "plc-block-grid" }, h("div", { className: "plc-block-frame" }), head,
    sides.inputs.wires, sides.inputs.names, inside, sides.outputs.names, sides.outputs.wires,
  );
  const node = h("div", { className: `plc-block plc-block-${face.kind}`, role: "img" }, frame, note);
  return { node, title, sides, note, gauge, drum, row };
}

/** The pins of one side: names inside the box, wires with their values outside. */
function buildPins(face, side) {
  const pins = pinsAt(face, side).map(([name]) => {
    const value = h("span", { className: "plc-pin-value" });
    return { value, wire: h("div", { className: "plc-pin" }, value), name: h("div", { className: "plc-pin-name" }, name) };
  });
  return {
    pins,
    wires: h("div", { className: `plc-pin-wires plc-pin-${side}` }, pins.map((pin) => pin.wire)),
    names: h("div", { className: `plc-pin-names plc-pin-${side}` }, pins.map((pin) => pin.name)),
  };
}

/** A bar with a mark for the preset, and words below. */
function buildGauge() {
  const part = (name) => h("span", { className: `plc-gauge-${name}` });
  const parts = { fill: part("fill"), mark: part("mark"), number: part("number"), value: part("value"), preset: part("preset"), unit: part("unit"), time: part("time") };
  const bar = h("div", { className: "plc-gauge-bar" }, parts.fill, parts.mark);
  const scale = h("div", { className: "plc-gauge-scale" }, h("span", {}, "0"), parts.number);
  const words = h("div", { className: "plc-gauge-words" }, parts.value, parts.preset, parts.unit, parts.time);
  return { ...parts, bar, node: h("div", { className: "plc-gauge" }, bar, scale, words) };
}

/** A drum's steps and control bits; the active step is a frame that moves over the rows. */
function buildDrum({ columns, rows }) {
  const active = h("div", { className: "plc-drum-active" });
  const corner = h("span", { className: "plc-drum-corner" });
  const heads = columns.map((name) => h("span", { className: "plc-drum-name" }, h("span", {}, name || "–")));
  const cells = rows.map((bits, step) => [
    h("span", { className: "plc-drum-step" }, String(step)),
    ...[...bits].map((bit) => h("span", { className: `plc-drum-cell${bit === "1" ? " plc-drum-peg" : ""}` })),
  ]);
  const style = { "--plc-drum-columns": columns.length, "--plc-drum-rows": rows.length };
  const body = h("div", { className: "plc-drum-body" }, active, cells);
  return { corner, active, body, node: h("div", { className: "plc-drum", style }, h("div", { className: "plc-drum-heads" }, corner, heads), body) };
}

/** The place for bits, steps or words. */
function buildRow(face, room) {
  const count = Math.min(countSlots(face), room ?? Infinity);
  const layer = h("div", { className: "plc-beads" });
  const across = face.kind === "steps" && count > STEPS_IN_A_ROW ? STEPS_IN_A_ROW + 2 : Math.min(count, BITS_IN_A_ROW);
  const style = { "--plc-across": across, "--plc-down": Math.ceil(count / BITS_IN_A_ROW), "--plc-count": count };
  if (face.kind === "shift") layer.append(...placedSlots(face).filter(({ mark }) => mark !== "gone").map((slot) => bitLabel(face, slot, count)));
  const aside = face.kind === "queue" ? buildPile(face, layer, count) : {};
  const more = count < countSlots(face) && h("div", { className: "plc-pile-more" });
  return { layer, count, more, ...aside, node: h("div", { className: `plc-row-of-${face.kind}`, style }, more, layer) };
}

/** The number of a bit, above its place. */
function bitLabel(face, { place, label }, count) {
  return placeBead(h("span", { className: "plc-bead-label" }, h("small", {}, label)), spotOf(face.kind, place, count));
}

/** The empty places of a pile with their numbers, the words beside it, and the pointer of one that gives back its top. */
function buildPile(face, layer, count) {
  const slot = (label, place) => placeBead(h("span", { className: "plc-pile-slot" }, label), spotOf("queue", place, count));
  layer.append(...placedSlots(face).slice(0, count).map(({ label, place }) => slot(label, place)));
  const aside = (name, on) => on && h("span", { className: `plc-pile-${name}` });
  const parts = {
    into: aside("into", wordOf(face, ".I") !== undefined),
    out: aside("out", wordOf(face, ".O") !== undefined),
    pointer: aside("pointer", face.way === "lifo"),
  };
  layer.append(...Object.values(parts).filter(Boolean));
  return parts;
}

/** Puts something at a spot, counted in columns and rows. */
function placeBead(node, { x, y }) {
  node.style.transform = `translate(calc(var(--plc-bead-wide) * ${x}), calc(var(--plc-bead-high) * ${y}))`;
  return node;
}

/** Gives a block its values and words. */
function dressBlock(blocks, view, face, lang, moves) {
  view.title.textContent = say(face.title, lang);
  view.node.setAttribute("aria-label", describeBlock(face, lang));
  for (const side of ["inputs", "outputs"]) dressPins(view.sides[side].pins, pinsAt(face, side));
  if (view.gauge) dressGauge(view.gauge, face.gauge, lang);
  if (view.drum) dressDrum(view.drum, face.grid, lang);
  if (view.row) {
    dressBeads(blocks, view, face, moves);
    if (face.kind === "queue") dressPile(view.row, face, lang);
  }
  view.note.textContent = say(face.note, lang);
  view.note.hidden = !face.note;
  Object.assign(view, { face, lang });
}

/** Sets the values at the wires. */
function dressPins(parts, pins) {
  parts.forEach((part, at) => {
    const value = pins[at][1];
    part.value.textContent = value;
    part.wire.className = `plc-pin plc-pin-${pinState(value)}`;
  });
}

/** Sets the bar and its words. */
function dressGauge(parts, gauge, lang) {
  const [first, last] = gauge.bar;
  const percent = (part) => `${Math.round(part * 1e4) / 100}%`;
  Object.assign(parts.fill.style, { left: percent(first), width: percent(last - first) });
  parts.bar.classList.toggle("plc-gauge-unknown", gauge.value === undefined);
  parts.bar.classList.toggle("plc-gauge-beyond", Boolean(gauge.beyond));
  parts.mark.hidden = parts.number.hidden = gauge.mark === undefined;
  parts.mark.style.left = parts.number.style.left = percent(gauge.mark ?? 0);
  parts.number.textContent = String(gauge.preset ?? "");
  parts.value.replaceChildren(`${blockWord("current", lang)} `, h("b", {}, String(gauge.value ?? "x")));
  parts.preset.textContent = `${blockWord("preset", lang)} ${gauge.preset ?? "x"}`;
  parts.unit.textContent = say(gauge.unit, lang);
  parts.time.textContent = say(gauge.time, lang);
}

/** Moves the frame of the active step. */
function dressDrum(parts, { rows, active }, lang) {
  parts.corner.textContent = blockWord("step", lang);
  parts.active.hidden = !rows[active];
  parts.active.style.transform = `translateY(${Math.max(0, active) * 100}%)`;
  const steps = parts.body.querySelectorAll(".plc-drum-step");
  steps.forEach((node, step) => node.classList.toggle("plc-drum-now", step === active));
}

/** Moves bits, steps or words to where they are now; new ones come in from outside, old ones go out. */
function dressBeads(blocks, view, face, moves) {
  const { row, faces } = view;
  const { beads, leaving } = carryBeads(view.beads, view.face, face, () => `b${(blocks.made += 1)}`);
  for (const { id, to } of leaving) {
    const node = faces.get(id);
    faces.delete(id);
    if (!moves) node.remove();
    else {
      node.classList.add("plc-bead-leaving");
      placeBead(node, spotOf(face.kind, to, row.count));
    }
  }
  const born = beads.filter(({ from }) => from !== null);
  for (const { id, slot, from } of born) {
    const node = h("span", { className: "plc-bead plc-bead-born" });
    faces.set(id, node);
    dressBead(node, slot, face.kind);
    row.layer.append(placeBead(node, spotOf(face.kind, from, row.count)));
  }
  if (moves && born.length) void row.layer.offsetWidth; // so that they set out from there
  for (const { id, slot } of beads) {
    const node = faces.get(id);
    dressBead(node, slot, face.kind);
    placeBead(node, spotOf(face.kind, slot.place, row.count));
  }
  view.beads = beads;
}

/** Gives one bit or word its value and its marks. */
function dressBead(node, { label, value, mark }, kind) {
  const gap = kind === "steps" && value === "" && label === "…";
  const state = pinState(value);
  node.className = `plc-bead plc-bead-${state}${mark ? ` plc-bead-${mark}` : ""}${gap ? " plc-bead-gap" : ""}`;
  if (kind === "steps") node.replaceChildren(h("small", {}, gap ? "\u00a0" : label), h("span", {}, gap ? "…" : value));
  else node.replaceChildren(h("span", {}, value));
}

/** Moves the words beside a pile and its pointer to the height of their words. */
function dressPile(parts, face, lang) {
  const count = countWords(face);
  if (parts.more) parts.more.textContent = blockWord("more", lang).replace("{}", countSlots(face));
  const at = (node, place) => placeBead(node, { x: 0, y: spotOf("queue", Math.max(0, Math.min(parts.count - 1, place)), parts.count).y });
  for (const [node, name, place] of [[parts.into, ".I", count], [parts.out, ".O", face.way === "lifo" ? count - 1 : 0]]) {
    if (!node) continue;
    at(node, place).replaceChildren(h("span", { className: "plc-pile-word" }, `${name} ${wordOf(face, name)}`));
  }
  parts.into?.classList.toggle("plc-pile-shut", count >= parts.count);
  parts.out?.classList.toggle("plc-pile-shut", !count);
  if (!parts.pointer) return;
  parts.pointer.textContent = blockWord("pointer", lang);
  parts.pointer.hidden = !count;
  at(parts.pointer, count - 1);
}
