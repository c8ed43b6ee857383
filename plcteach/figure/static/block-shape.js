// Knows where the parts of a function block stand, which of its bits and words have moved, and how to say it; no DOM.

import { say } from "./ui.js";

/**
 * @typedef {import("./ui.js").Text} Text
 * @typedef {{value?: number, preset?: number, most: number, bar: [number, number], mark?: number, unit?: Text, time?: Text,
 *   beyond?: boolean}} Gauge
 * @typedef {{address: string, kind: "timer"|"counter"|"drum"|"shift"|"steps"|"queue", title: Text,
 *   inputs?: [string, string][], outputs?: [string, string][], gauge?: Gauge, slots?: [string, string, string][],
 *   grid?: {columns: string[], rows: string[], active: number}, way?: "left"|"right"|"fifo"|"lifo", note?: Text}} BlockFace
 * @typedef {{place: number, label: string, value: string, mark: string}} Slot  a slot at its place, 0 the lowest
 * @typedef {{id: string, slot: Slot, from: number|null}} Bead  a bit or word that keeps its id while it moves
 */

const BLOCK_WORDS = {
  current: { zh: "当前值", en: "current" },
  preset: { zh: "预设值", en: "preset" },
  step: { zh: "步", en: "step" },
  stepUnknown: { zh: "现在是哪一步未知", en: "the active step is unknown" },
  atStep: { zh: "第{}步", en: "step {}" },
  on: { zh: "接通{}", en: "on: {}" },
  nothing: { zh: "无", en: "nothing" },
  words: { zh: "存有{n}个字，自底向上：{w}", en: "{n} words, from the bottom up: {w}" },
  bits: { zh: "各位（高位在左）：{}", en: "bits, the highest first: {}" },
  more: { zh: "… 共 {} 个字", en: "… of {} words" },
  pointer: { zh: "指针", en: "pointer" },
  blocks: { zh: "功能块", en: "Function blocks" },
};
export const BITS_IN_A_ROW = 16;
const FEWEST_PLACES = 4;
const GAP_LABEL = "…";

/** A word of the blocks in one language. */
export function blockWord(name, lang) {
  return say(BLOCK_WORDS[name], lang);
}

/** The pins at one side of the box; a queue's two words stand beside its pile instead. */
export function pinsAt(face, side) {
  return (face[side] ?? []).filter(([name]) => !(face.kind === "queue" && name.startsWith(".")));
}

/** The value of a queue's word `.I` or `.O`, or undefined where it has none. */
export function wordOf(face, name) {
  return [...(face.inputs ?? []), ...(face.outputs ?? [])].find(([own]) => own === name)?.[1];
}

/** What kind of value a pin has. */
export function pinState(value) {
  return { 1: "one", 0: "zero", x: "unknown", "": "open" }[value] ?? "number";
}

/** All that decides how a block is built, `room` among it; while it stays the same, only values are changed. */
export function buildOf(face, room) {
  const names = (side) => (face[side] ?? []).map(([name]) => name);
  const slots = face.kind === "steps" ? Boolean(face.slots) : face.slots && countSlots(face);
  const grid = face.grid && [face.grid.columns, face.grid.rows];
  return JSON.stringify([room, face.kind, names("inputs"), names("outputs"), Boolean(face.gauge), slots, grid, face.way]);
}

/** The slots with their places; a bit that was lost stands just outside, at the end where it fell out. @returns {Slot[]} */
export function placedSlots(face) {
  const slots = face.slots ?? [];
  const outside = face.kind === "shift" && slots[0]?.[2] === "gone" ? 1 : 0;
  return slots.map(([label, value, mark = ""], at) => ({ place: at - outside, label, value, mark }));
}

/** How many bits, steps or words a row or pile has, without one that was lost. */
export function countSlots(face) {
  const slots = face.slots ?? [];
  return face.kind === "shift" ? slots.filter(([, , mark]) => mark !== "gone").length : slots.length;
}

/**
 * How many places of each queue are worth drawing in a film: those that hold a word at some time, and one more.
 * @returns {Object<string, number>} by the queue's address
 */
export function queueRooms(film) {
  const rooms = {};
  const widen = (address, slots) => {
    const used = slots.reduce((most, [, value], at) => (value ? at + 1 : most), 0);
    rooms[address] = Math.max(rooms[address] ?? FEWEST_PLACES, Math.min(slots.length, used + 1));
  };
  const queues = (film?.faces ?? []).filter((face) => face.kind === "queue");
  for (const { address, slots } of queues) {
    widen(address, slots ?? []);
    for (const step of film.steps) if (step.faces?.[address]?.slots) widen(address, step.faces[address].slots);
  }
  return rooms;
}

/** How many words a queue holds. */
export function countWords(face) {
  return (face.slots ?? []).filter(([, value, mark]) => value && mark !== "gone").length;
}

/** Where the place of a slot lies, in columns from the left and rows from the top. */
export function spotOf(kind, place, count) {
  if (kind === "queue") return { x: 0, y: count - 1 - place };
  if (kind === "steps") return { x: place, y: 0 };
  const rows = Math.max(1, Math.ceil(count / BITS_IN_A_ROW));
  const row = Math.max(0, Math.min(rows - 1, Math.floor(place / BITS_IN_A_ROW)));
  return { x: Math.min(count, BITS_IN_A_ROW) - 1 - (place - row * BITS_IN_A_ROW), y: rows - 1 - row };
}

/** By how many places all bits or words have moved from one face of a block to the next: 1 up, -1 down, 0 not at all. */
export function moveBetween(before, after) {
  if (before.kind === "shift") return bitsMoved(before, after);
  return before.kind === "queue" && after.way !== "lifo" ? wordsMoved(before, after) : 0;
}

/** A shift register has moved if its bits fit and either a bit is shown as lost or more than one has changed. */
function bitsMoved(before, after) {
  const bits = (face) => placedSlots(face).filter(({ mark }) => mark !== "gone").map(({ value }) => value);
  const [old, now] = [bits(before), bits(after)];
  if (old.length !== now.length || !old.length) return 0;
  const up = old.every((bit, at) => at === old.length - 1 || now[at + 1] === bit);
  const down = now.every((bit, at) => at === now.length - 1 || old[at + 1] === bit);
  const [lostNow, lostThen] = [lostAt(after), lostAt(before)];
  if (up && lostNow > 0) return 1;
  if (down && lostNow < 0) return -1;
  if (down && lostThen > 0 && !lostNow) return -1;
  if (up && lostThen < 0 && !lostNow) return 1;
  if (up === down || old.filter((bit, at) => now[at] !== bit).length < 2) return 0;
  return up ? 1 : -1;
}

/** At which end a bit is shown as lost: 1 above the highest, -1 below the lowest, 0 at none. */
function lostAt(face) {
  const lost = placedSlots(face).find(({ mark }) => mark === "gone");
  return lost ? (lost.place < 0 ? -1 : 1) : 0;
}

/** The words of a pile move down when the lowest is taken out, and up again when that is played backwards. */
function wordsMoved(before, after) {
  const kept = (face) => (face.slots ?? []).filter(([, value, mark]) => value && mark !== "gone").map(([, value]) => value);
  const [old, now] = [kept(before), kept(after)];
  if (now.length === old.length - 1) return now.every((word, at) => word === old[at + 1]) ? -1 : 0;
  const grown = now.length === old.length + 1 && old.every((word, at) => word === now[at + 1]);
  return grown && !old.every((word, at) => word === now[at]) ? 1 : 0;
}

/** The slots that are drawn as beads: of a queue only those that hold a word. */
function shownSlots(face) {
  return placedSlots(face).filter(({ value }) => face.kind !== "queue" || value);
}

/**
 * The beads of a face, each the same one as before where it only moved.
 * @param {Bead[]} old the beads of the face before  @param {() => string} fresh gives an unused id
 * @returns {{beads: Bead[], leaving: {id: string, to: number}[]}} `from`: where a new bead sets out, null for one that stays
 */
export function carryBeads(old, before, after, fresh) {
  if (after.kind === "steps") return carrySteps(old, after);
  const move = before ? moveBetween(before, after) : 0;
  const waiting = new Map(old.map((bead) => [bead.slot.place + move, bead]));
  const beads = shownSlots(after).map((slot) => {
    const kept = waiting.get(slot.place);
    waiting.delete(slot.place);
    return kept ? { id: kept.id, slot, from: null } : { id: fresh(), slot, from: entranceOf(after, slot, move) };
  });
  return { beads, leaving: [...waiting].map(([to, bead]) => ({ id: bead.id, to })) };
}

/** Where a new bead sets out: outside the end from which all move, above its place in a pile, else just there. */
function entranceOf(face, slot, move) {
  if (move) return slot.place - move;
  return face.kind === "queue" ? slot.place + 1 : slot.place;
}

/** Steps are known by their numbers: the row slides under the active one. */
function carrySteps(old, face) {
  const known = new Set(old.map((bead) => bead.id));
  const beads = placedSlots(face).map((slot) => {
    const id = slot.label === GAP_LABEL ? `${GAP_LABEL}${slot.place}` : slot.label;
    return { id, slot, from: known.has(id) ? null : slot.place };
  });
  const now = new Set(beads.map((bead) => bead.id));
  return { beads, leaving: old.filter(({ id }) => !now.has(id)).map(({ id, slot }) => ({ id, to: slot.place })) };
}

/** What a block shows, in one sentence. */
export function describeBlock(face, lang) {
  const pins = [...(face.inputs ?? []), ...(face.outputs ?? [])].filter(([, value]) => value !== "");
  const parts = [pins.map(([name, value]) => `${name}=${value}`).join(", ")];
  if (face.gauge) parts.push(gaugeWords(face.gauge, lang));
  if (face.slots?.length) parts.push(slotWords(face, lang));
  if (face.grid) parts.push(gridWords(face.grid, lang));
  const head = [say(face.title, lang), face.address].filter(Boolean).join(" ");
  const [colon, semicolon] = lang === "zh" ? ["：", "；"] : [": ", "; "];
  return [head, parts.filter(Boolean).join(semicolon)].filter(Boolean).join(colon);
}

/** Current and preset value, and the time that they stand for. */
function gaugeWords({ value, preset, time }, lang) {
  const numbers = `${blockWord("current", lang)} ${value ?? "x"}, ${blockWord("preset", lang)} ${preset ?? "x"}`;
  return time ? `${numbers} (${say(time, lang)})` : numbers;
}

/** A row of bits, the active step, or the words of a pile. */
function slotWords(face, lang) {
  const slots = placedSlots(face).filter(({ mark }) => mark !== "gone");
  if (face.kind === "steps") {
    return blockWord("atStep", lang).replace("{}", slots.find(({ value }) => value === "1")?.label ?? "x");
  }
  if (face.kind === "queue") {
    const kept = slots.filter(({ value }) => value).map(({ value }) => value);
    return blockWord("words", lang).replace("{n}", kept.length).replace("{w}", kept.join(" "));
  }
  return blockWord("bits", lang).replace("{}", slots.map(({ value }) => value || "-").reverse().join(""));
}

/** The active step of a drum and what it switches on. */
function gridWords({ columns, rows, active }, lang) {
  if (!rows[active]) return blockWord("stepUnknown", lang);
  const on = columns.filter((name, at) => name && rows[active][at] === "1").join(lang === "zh" ? "、" : ", ");
  const step = blockWord("atStep", lang).replace("{}", active);
  return `${step}, ${blockWord("on", lang).replace("{}", on || blockWord("nothing", lang))}`;
}
