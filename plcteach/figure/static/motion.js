// Knows where each cell of a Film stands and how cells move between two neighbouring steps; numbers only, no DOM.

import { cellsAt } from "./film.js";

/**
 * Places are counted in column pitches (x) and cell rows (y), so that the style sheet alone decides on sizes.
 * @typedef {{x: number, register?: number, first: number, levels: number, end: number, more: number}} ColumnPlace
 * @typedef {{width: number, height: number, foot: number, register: boolean, columns: ColumnPlace[]}} Layout
 * @typedef {{x: number, y: number, alpha: number, turn: number, offset: number}} Frame
 * @typedef {{key: string, kind: string, cell: import("./film.js").Cell,
 *   old?: import("./film.js").Cell, stays: boolean, frames: Frame[]}} Track
 */

/** Heights in rows: a caption above, the gap below a register, the foot with the mark of the bottom. */
const CAPTION_ROWS = 0.75;
const GAP_ROWS = 0.25;
const FOOT_ROWS = 0.75;
const BESIDE_PITCH = 0.3;

/**
 * Where the columns stand: stacks side by side; a column that is nothing but a register stands above their middle.
 * aligned: beside other families, so that a register stands as high as another's level 1, and level 1 below it as its level 2.
 */
export function layoutOf(film, { aligned = false } = {}) {
  const register = film.columns.some((column) => column.register);
  const joined = aligned && film.columns.some((column) => column.register && levelCount(column));
  const below = CAPTION_ROWS + 1 + (joined ? 0 : GAP_ROWS + CAPTION_ROWS);
  const first = register ? below : CAPTION_ROWS;
  const stacks = film.columns.filter((column) => levelCount(column) > 0).length;
  let next = 0;
  const columns = film.columns.map((column) => {
    const levels = levelCount(column);
    return {
      x: levels ? next++ : Math.max(0, stacks - 1) / 2,
      register: column.register ? CAPTION_ROWS : undefined,
      first,
      levels,
      end: levels ? first + levels : CAPTION_ROWS + 1,
      more: Math.max(0, column.depth - column.drawn),
    };
  });
  const end = Math.max(...columns.map((column) => column.end));
  return { width: Math.max(1, stacks), height: end + FOOT_ROWS, foot: FOOT_ROWS, register, joined, columns };
}

/** How many levels of a column are drawn below its register. */
function levelCount(column) {
  return column.drawn - (column.register ? 1 : 0);
}

/** The place of a position; -1 is just above the top, and all below the last drawn level is just below it. */
export function placeOf(layout, column, position) {
  const { x, register, first, end } = layout.columns[column];
  const top = register ?? first;
  if (position < 0) return { x, y: top - 1 };
  if (register === undefined) return { x, y: Math.min(first + position, end) };
  return { x, y: position === 0 ? register : Math.min(first + position - 1, end) };
}

/** One key frame of a cell. */
function keyFrame(place, offset, alpha = 1, turn = 0) {
  return { x: place.x, y: place.y, alpha, turn, offset };
}

/**
 * How every cell moves from one step to a neighbour, or null when the two are not neighbours.
 * Stepping back is the same motion run backwards. @returns {Track[]|null}
 */
export function tracksBetween(film, layout, from, to) {
  if (to === from + 1) return tracksInto(film, layout, to);
  if (to === from - 1) return tracksInto(film, layout, from).map(backwardTrack);
  return null;
}

/** The motion of one step forward: first cells that go, then cells that stay, then cells that are new. */
function tracksInto(film, layout, index) {
  const step = film.steps[index];
  const before = cellsByKey(cellsAt(film, index - 1));
  const after = cellsByKey(cellsAt(film, index));
  const scene = { step, layout, before, after, children: childrenOf(step) };
  const going = [...before.values()].filter((cell) => !after.has(cell.key));
  const staying = [...after.values()].filter((cell) => before.has(cell.key));
  const coming = [...after.values()].filter((cell) => !before.has(cell.key));
  return [
    ...going.map((cell) => goingTrack(scene, cell)),
    ...staying.flatMap((cell) => stayingTracks(scene, cell)),
    ...coming.map((cell) => comingTrack(scene, cell)),
  ];
}

/** Cells under their keys. */
function cellsByKey(cells) {
  return new Map(cells.map((cell) => [cell.key, cell]));
}

/** Which new cell each old cell went into. */
function childrenOf(step) {
  const children = new Map();
  for (const [child, parents] of Object.entries(step.from ?? {})) {
    for (const parent of parents) children.set(parent, child);
  }
  return children;
}

/** Where a cell stands. */
function placeOfCell({ layout }, cell) {
  return placeOf(layout, cell.column, cell.position);
}

/** A cell that is there before and after: it slides; a value changed in place flips, the old face first. */
function stayingTracks(scene, cell) {
  const old = scene.before.get(cell.key);
  const [from, to] = [placeOfCell(scene, old), placeOfCell(scene, cell)];
  if (old.value === cell.value && !scene.step.changed?.includes(cell.key)) {
    return [{ key: cell.key, kind: "stay", cell, old, stays: true, frames: [keyFrame(from, 0), keyFrame(to, 1)] }];
  }
  const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  const oldFace = [keyFrame(from, 0), keyFrame(middle, 0.5, 1, 90), keyFrame(to, 0.5, 0, 90), keyFrame(to, 1, 0, 90)];
  const hidden = [keyFrame(from, 0, 0, -90), keyFrame(middle, 0.5, 0, -90)];
  const newFace = [...hidden, keyFrame(middle, 0.5, 1, -90), keyFrame(to, 1)];
  return [
    { key: cell.key, kind: "oldface", cell: old, old: cell, stays: false, frames: oldFace },
    { key: cell.key, kind: "newface", cell, old, stays: true, frames: newFace },
  ];
}

/** A cell that is new: born from its source, merged from its parents, or entered from outside. */
function comingTrack(scene, cell) {
  const to = placeOfCell(scene, cell);
  const parents = (scene.step.from?.[cell.key] ?? []).map((key) => scene.before.get(key)).filter(Boolean);
  const track = { key: cell.key, cell, stays: true };
  if (parents.length > 1) {
    return { ...track, kind: "merge", frames: [keyFrame(to, 0, 0), keyFrame(to, 0.55, 0), keyFrame(to, 1)] };
  }
  if (parents.length === 1) {
    return { ...track, kind: "copy", frames: [keyFrame(placeOfCell(scene, parents[0]), 0), keyFrame(to, 1)] };
  }
  const way = scene.step.enter?.[cell.key] ?? "none";
  const from = keyFrame(entrancePlace(scene, cell, way), 0, way === "bottom" ? 1 : 0);
  return { ...track, kind: `enter-${way}`, frames: [from, keyFrame(to, 1)] };
}

/** Where a cell from outside sets out: above the top, below the bottom, or beside its place. */
function entrancePlace({ layout }, cell, way) {
  const place = placeOf(layout, cell.column, cell.position);
  if (way === "top") return placeOf(layout, cell.column, -1);
  if (way === "bottom") return { x: place.x, y: layout.columns[cell.column].end };
  return way === "load" ? { x: place.x - BESIDE_PITCH, y: place.y } : place;
}

/** A cell that goes: lost at the bottom, popped off the top, or flowing into another. */
function goingTrack(scene, cell) {
  const from = placeOfCell(scene, cell);
  const way = scene.step.leave?.[cell.key] ?? "none";
  const track = { key: cell.key, kind: `leave-${way}`, cell, stays: false };
  const child = scene.after.get(scene.children.get(cell.key));
  if (way === "merge" && child) {
    const to = placeOfCell(scene, child);
    return { ...track, frames: [keyFrame(from, 0), keyFrame(to, 0.7), keyFrame(to, 1, 0)] };
  }
  return { ...track, frames: [keyFrame(from, 0), keyFrame(exitPlace(scene, cell, way), 1, 0)] };
}

/** Where a cell that leaves the picture ends. */
function exitPlace({ layout }, cell, way) {
  const place = placeOf(layout, cell.column, cell.position);
  if (way === "bottom") return { x: place.x, y: layout.columns[cell.column].end };
  return way === "top" ? placeOf(layout, cell.column, -1) : place;
}

/** The same motion backwards: what came goes, what went comes back. */
function backwardTrack(track) {
  const frames = track.frames.map((one) => ({ ...one, offset: 1 - one.offset })).reverse();
  if (track.kind === "stay") return { ...track, cell: track.old, old: track.cell, frames };
  return { ...track, stays: !track.stays, frames };
}
