// Holds the motion between two steps to what a lecturer draws: push, pop, copy, merge, loss, x entering, flips.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { cellsAt, stepOfLine } from "../../plcteach/figure/static/film.js";
import { layoutOf, placeOf, tracksBetween } from "../../plcteach/figure/static/motion.js";

const FILMS = JSON.parse(readFileSync(new URL("sample-film.json", import.meta.url)));
const { s7200, fx, neza, gutta } = FILMS;

/** The tracks of the step that executes the nth line with this text, and its first and last frames. */
function motionOf(film, text, nth = 1) {
  const line = film.lines.map((one, at) => [one.text, at]).filter(([words]) => words === text)[nth - 1][1];
  const index = stepOfLine(film, line);
  const layout = layoutOf(film);
  return { index, layout, tracks: tracksBetween(film, layout, index - 1, index) };
}
const first = (track) => track.frames[0];
const last = (track) => track.frames.at(-1);
const kinds = (tracks) => tracks.map((track) => track.kind).sort();

test("columns stand side by side, a register above its column", () => {
  const one = layoutOf(s7200);
  assert.deepEqual([one.width, one.columns[0].levels, one.columns[0].register], [1, 9, undefined]);
  const register = layoutOf(fx);
  assert.equal(register.columns[0].levels, 11);
  assert.ok(register.columns[0].register + 1 < register.columns[0].first);
  const two = layoutOf(gutta);
  assert.deepEqual(two.columns.map((column) => [column.x, column.levels, column.more]), [[0, 4, 28], [1, 4, 28]]);
});

test("a column that is only a register stands above the middle of the stacks", () => {
  const layout = layoutOf(neza);
  assert.equal(layout.width, 2);
  assert.deepEqual(layout.columns.map((column) => column.x), [0.5, 0, 1]);
  assert.ok(placeOf(layout, 0, 0).y < placeOf(layout, 1, 0).y);
});

test("positions outside a column lie one row above its top and one below its end", () => {
  const layout = layoutOf(s7200);
  const { first: top, end } = layout.columns[0];
  assert.equal(placeOf(layout, 0, -1).y, top - 1);
  assert.equal(placeOf(layout, 0, 8).y, end - 1);
  assert.deepEqual([placeOf(layout, 0, 9).y, placeOf(layout, 0, 30).y], [end, end]);
});

test("only neighbours are animated", () => {
  const layout = layoutOf(s7200);
  assert.equal(tracksBetween(s7200, layout, 2, 4), null);
  assert.equal(tracksBetween(s7200, layout, 3, 3), null);
  assert.equal(tracksBetween(s7200, layout, 9, 0), null);
});

test("a push slides eight cells down, loses the ninth at the bottom, and a new one comes from beside", () => {
  const { layout, tracks } = motionOf(s7200, "LD I0.0");
  const stays = tracks.filter((track) => track.kind === "stay");
  assert.equal(stays.length, 8);
  for (const track of stays) assert.equal(last(track).y - first(track).y, 1);
  const [lost] = tracks.filter((track) => track.kind === "leave-bottom");
  assert.deepEqual([lost.stays, last(lost).y, last(lost).alpha], [false, layout.columns[0].end, 0]);
  const [born] = tracks.filter((track) => track.kind === "enter-load");
  assert.ok(first(born).x < last(born).x && first(born).y === last(born).y);
});

test("a merge has two parents that flow to where the new cell appears, and x enters from below", () => {
  const { layout, tracks } = motionOf(s7200, "OLD");
  const parents = tracks.filter((track) => track.kind === "leave-merge");
  const [child] = tracks.filter((track) => track.kind === "merge");
  assert.equal(parents.length, 2);
  assert.deepEqual(parents.map((track) => first(track).y).sort(), [placeOf(layout, 0, 0).y, placeOf(layout, 0, 1).y]);
  for (const parent of parents) assert.deepEqual([last(parent).y, last(parent).alpha], [last(child).y, 0]);
  assert.deepEqual([first(child).alpha, last(child).alpha], [0, 1]);
  const [x] = tracks.filter((track) => track.kind === "enter-bottom");
  assert.deepEqual([x.cell.value, first(x).y, last(x).y], ["x", layout.columns[0].end, placeOf(layout, 0, 8).y]);
});

test("a copy is born from its source", () => {
  const { layout, tracks } = motionOf(s7200, "LRD");
  const [copy] = tracks.filter((track) => track.kind === "copy");
  assert.equal(first(copy).y, placeOf(layout, 0, 1).y);
  assert.equal(last(copy).y, placeOf(layout, 0, 0).y);
  assert.equal(first(copy).alpha, 1);
});

test("a copy may cross from one column to another", () => {
  const [copy] = motionOf(gutta, "LPS").tracks.filter((track) => track.kind === "copy");
  assert.deepEqual([first(copy).x, last(copy).x], [0, 1]);
  const [saved] = motionOf(neza, "AND( %I0.1").tracks.filter((track) => track.kind === "stay");
  assert.deepEqual([first(saved).x, last(saved).x], [0.5, 0]);
});

test("a pop leaves over the top while the others rise", () => {
  const { layout, tracks } = motionOf(s7200, "LPP");
  const [popped] = tracks.filter((track) => track.kind === "leave-top");
  assert.deepEqual([last(popped).y, last(popped).alpha], [placeOf(layout, 0, -1).y, 0]);
  for (const track of tracks.filter((one) => one.kind === "stay")) assert.equal(last(track).y - first(track).y, -1);
});

test("a value changed in place flips: the old face turns away, then the new one turns up", () => {
  const { tracks } = motionOf(s7200, "A I0.1");
  const [old] = tracks.filter((track) => track.kind === "oldface");
  const [now] = tracks.filter((track) => track.kind === "newface");
  assert.deepEqual([old.cell.value, now.cell.value, old.key === now.key], ["1", "0", true]);
  assert.deepEqual([first(old).turn, last(old).turn, first(now).turn, last(now).turn], [0, 90, -90, 0]);
  assert.deepEqual([old.stays, now.stays], [false, true]);
});

test("an output moves nothing", () => {
  for (const { frames } of motionOf(s7200, "= Q0.0").tracks) assert.deepEqual(frames[0].y, frames.at(-1).y);
  assert.deepEqual(new Set(kinds(motionOf(s7200, "= Q0.0").tracks)), new Set(["stay"]));
});

test("in every film, the tracks of a step end exactly at the cells of that step", () => {
  for (const film of Object.values(FILMS)) {
    const layout = layoutOf(film);
    for (let to = 1; to < film.steps.length; to += 1) {
      for (const [from, into] of [[to - 1, to], [to, to - 1]]) {
        const tracks = tracksBetween(film, layout, from, into);
        const wanted = cellsAt(film, into).map((cell) => [cell.key, cell.value, placeOf(layout, cell.column, cell.position)]);
        const ended = tracks.filter((track) => track.stays).map((track) => [track.key, track.cell.value, { x: last(track).x, y: last(track).y }]);
        assert.deepEqual(ended.sort(), wanted.sort());
        const offsets = tracks.map((track) => track.frames.map((frame) => frame.offset));
        for (const one of offsets) assert.deepEqual([one[0], one.at(-1), one], [0, 1, [...one].sort((a, b) => a - b)]);
      }
    }
  }
});

test("stepping back is the same motion backwards", () => {
  const { index, layout, tracks } = motionOf(s7200, "OLD");
  const back = tracksBetween(s7200, layout, index, index - 1);
  assert.deepEqual(kinds(back), kinds(tracks));
  for (const track of back) {
    const forth = tracks.find((other) => other.key === track.key && other.kind === track.kind);
    assert.deepEqual([first(track).y, last(track).y], [last(forth).y, first(forth).y]);
    if (track.kind !== "stay") assert.notEqual(track.stays, forth.stays);
  }
});

test("a film that does not say where a cell comes from or goes to fades it in place", () => {
  const columns = [{ id: "main", title: {}, depth: 2, drawn: 2 }];
  const film = { columns, texts: [], lines: [], steps: [{ cells: [["a", 0, 0, "1", -1, -1]] }, { cells: [["b", 0, 0, "0", -1, -1]] }] };
  const tracks = tracksBetween(film, layoutOf(film), 0, 1);
  assert.deepEqual(kinds(tracks), ["enter-none", "leave-none"]);
  for (const track of tracks) assert.equal(first(track).y, last(track).y);
});
