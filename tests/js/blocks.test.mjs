// Holds what the browser knows of function blocks to what a block does: bits shift, words fall, a pointer moves, nothing else does.

import assert from "node:assert/strict";
import test from "node:test";
import {
  buildOf, carryBeads, countSlots, countWords, describeBlock, moveBetween, pinState, pinsAt, placedSlots, queueRooms, spotOf, wordOf,
} from "../../plcteach/figure/static/block-shape.js";
import { facesAt } from "../../plcteach/figure/static/film.js";

const title = { zh: "块", en: "block" };
/** A shift register from its bits as written, the highest first; `lost` at the "high" or "low" end. */
function shift(word, lost = "") {
  const bits = [...word].reverse().map((bit, at) => [String(at), bit, ""]);
  const gone = [["", "1", "gone"]];
  return { address: "%SBR0", kind: "shift", title, slots: [...(lost === "low" ? gone : []), ...bits, ...(lost === "high" ? gone : [])] };
}
/** A queue of eight places from its words, the bottom first. */
function queue(words, way = "fifo", gone = "") {
  const slots = Array.from({ length: 8 }, (_, at) => [String(at), words[at] ?? "", ""]);
  if (gone) slots[words.length] = [String(words.length), gone, "gone"];
  return { address: "%R0", kind: "queue", title, way, inputs: [["I", "0"], [".I", "45"]], outputs: [["E", "0"], [".O", "20"]], slots };
}
/** Carries beads through faces and gives them after each. */
function carried(...faces) {
  let made = 0;
  let now = { beads: [], leaving: [] };
  return faces.map((face, at) => (now = carryBeads(now.beads, faces[at - 1], face, () => `b${(made += 1)}`)));
}
const ids = ({ beads }) => Object.fromEntries(beads.map(({ id, slot }) => [slot.place, id]));

test("a film without blocks has no faces, with them each step keeps what it does not change", () => {
  assert.deepEqual(facesAt({ steps: [{}] }, 0), []);
  const face = (address) => ({ address, kind: "timer", title, inputs: [["IN", "0"]], note: title });
  const film = {
    faces: [face("T37"), face("T38")],
    steps: [{}, { faces: { T37: { inputs: [["IN", "1"]], note: null } } }, {}, { faces: { T37: { inputs: [["IN", "0"]] } } }],
  };
  assert.equal(facesAt(film, 3)[0].inputs[0][1], "0");
  assert.equal(facesAt(film, 1)[0].inputs[0][1], "1");
  assert.ok(!("note" in facesAt(film, 1)[0]) && !("note" in facesAt(film, 3)[0]));
  assert.equal(facesAt(film, 2), facesAt(film, 1));
  assert.equal(facesAt(film, 3)[1], film.faces[1]);
  assert.deepEqual(facesAt(film, 0), film.faces);
});

test("scrubbing over a long film touches each step once", () => {
  let read = 0;
  const steps = Array.from({ length: 2000 }, (_, at) => ({
    get faces() {
      read += 1;
      return { C1: { outputs: [["D", String(at)]] } };
    },
  }));
  const film = { faces: [{ address: "C1", kind: "counter", title }], steps };
  for (const index of [1999, 0, 1000, 1999, 3]) assert.equal(facesAt(film, index)[0].outputs[0][1], String(index));
  assert.equal(read, 2000);
});

test("bits shift up or down where one is lost, and back when the step is played backwards", () => {
  const [before, up] = [shift("0101"), shift("1010", "high")];
  assert.equal(moveBetween(before, up), 1);
  assert.equal(moveBetween(up, before), -1);
  const down = shift("0010", "low");
  assert.equal(moveBetween(before, down), -1);
  assert.equal(moveBetween(down, before), 1);
  assert.equal(moveBetween(shift("0000"), shift("0000", "high")), 1);
});

test("without a lost bit one changed bit is written, more that fit a shift are shifted", () => {
  assert.equal(moveBetween(shift("0000"), shift("0001")), 0);
  assert.equal(moveBetween(shift("0001"), shift("0010")), 1);
  assert.equal(moveBetween(shift("0010"), shift("0001")), -1);
  assert.equal(moveBetween(shift("0110"), shift("0000")), 0);
  assert.equal(moveBetween(shift("0011"), shift("1011")), 0);
});

test("a shifted bit stays the same bead one place on; the lost one stands outside and then goes", () => {
  const [one, two, three] = carried(shift("0101"), shift("1010", "high"), shift("1010"));
  for (const place of [1, 2, 3, 4]) assert.equal(ids(two)[place], ids(one)[place - 1]);
  const born = two.beads.find(({ from }) => from !== null);
  assert.deepEqual([born.slot.place, born.from], [0, -1]);
  assert.deepEqual(two.leaving, []);
  assert.deepEqual(three.leaving, [{ id: ids(two)[4], to: 4 }]);
  assert.equal(placedSlots(shift("0101", "low"))[0].place, -1);
  assert.equal(countSlots(shift("0101", "low")), 4);
});

test("in a FIFO the oldest word leaves at the bottom and the others fall; a new one comes in on top", () => {
  const [one, two, three] = carried(queue(["80", "50", "-7"]), queue(["50", "-7"]), queue(["50", "-7", "9"]));
  assert.deepEqual(two.leaving, [{ id: ids(one)[0], to: -1 }]);
  assert.deepEqual([ids(two)[0], ids(two)[1]], [ids(one)[1], ids(one)[2]]);
  assert.equal(three.leaving.length, 0);
  assert.deepEqual(three.beads.filter(({ from }) => from !== null).map(({ slot, from }) => [slot.value, slot.place, from]), [["9", 2, 3]]);
  const [, back] = carried(queue(["50", "-7"]), queue(["80", "50", "-7"]));
  assert.deepEqual(back.beads.filter(({ from }) => from !== null).map(({ slot, from }) => [slot.value, from]), [["80", -1]]);
});

test("equal words in a FIFO still come in on top and leave at the bottom", () => {
  assert.equal(moveBetween(queue(["5", "5"]), queue(["5", "5", "5"])), 0);
  assert.equal(moveBetween(queue(["5", "5", "5"]), queue(["5", "5"])), -1);
});

test("in a LIFO no word moves: only the top one changes its look", () => {
  const [one, two] = carried(queue(["80", "50", "-7"], "lifo"), queue(["80", "50"], "lifo", "-7"));
  assert.deepEqual(ids(two), ids(one));
  assert.equal(two.leaving.length, 0);
  assert.equal(countWords(queue(["80", "50"], "lifo", "-7")), 2);
});

test("steps are known by their numbers", () => {
  const steps = (first) => ({ address: "%SC0", kind: "steps", title, slots: [["…", "", ""], ...[0, 1, 2].map((at) => [String(first + at), at === 1 ? "1" : "0", at === 1 ? "active" : ""]), ["…", "", ""]] });
  const [one, two] = carried(steps(4), steps(5));
  assert.equal(ids(two)[1], ids(one)[2]);
  assert.deepEqual(two.leaving.map(({ id }) => id), ["4"]);
  assert.equal(describeBlock(steps(4), "en"), "block %SC0: step 5");
});

test("bits stand in rows of sixteen with the lowest at the right, words with the lowest at the bottom", () => {
  assert.deepEqual(spotOf("shift", 0, 16), { x: 15, y: 0 });
  assert.deepEqual(spotOf("shift", 16, 16), { x: -1, y: 0 });
  assert.deepEqual(spotOf("shift", -1, 16), { x: 16, y: 0 });
  assert.deepEqual([spotOf("shift", 0, 20), spotOf("shift", 16, 20)], [{ x: 15, y: 1 }, { x: 15, y: 0 }]);
  assert.deepEqual(spotOf("queue", 0, 8), { x: 0, y: 7 });
});

test("a queue is drawn as high as its words ever stand in the film, and one place more", () => {
  const steps = [{}, { faces: { "%R0": { slots: queue(["1", "2", "3", "4", "5"]).slots } } }, { faces: { T37: {} } }];
  assert.deepEqual(queueRooms({ faces: [queue(["1"])], steps }), { "%R0": 6 });
  assert.deepEqual(queueRooms({ faces: [queue([])], steps: [{}] }), { "%R0": 4 });
  assert.deepEqual(queueRooms(null), {});
});

test("values alone do not rebuild a block; other pins, rows or room do", () => {
  assert.equal(buildOf(shift("0101")), buildOf(shift("1010", "high")));
  assert.notEqual(buildOf(shift("0101")), buildOf(shift("01010")));
  assert.notEqual(buildOf(queue(["1"]), 4), buildOf(queue(["1"]), 5));
  assert.equal(buildOf(queue(["1"]), 4), buildOf(queue([]), 4));
});

test("a queue's words are no pins, and pins have one of five looks", () => {
  assert.deepEqual(pinsAt(queue([]), "inputs"), [["I", "0"]]);
  assert.equal(wordOf(queue([]), ".O"), "20");
  assert.deepEqual(["1", "0", "x", "", "300"].map(pinState), ["one", "zero", "unknown", "open", "number"]);
});

test("each kind says its state in words, in both languages", () => {
  const timer = {
    address: "%TM0", kind: "timer", title: { zh: "定时器", en: "timer" }, inputs: [["IN", "1"], ["R", ""]], outputs: [["Q", "0"]],
    gauge: { value: 32, preset: 50, most: 9999, bar: [0, 0.5], mark: 0.8, time: { zh: "已计3.2 s", en: "3.2 s of 5 s" } },
  };
  assert.equal(describeBlock(timer, "en"), "timer %TM0: IN=1, Q=0; current 32, preset 50 (3.2 s of 5 s)");
  assert.equal(describeBlock({ ...timer, gauge: { preset: 50, bar: [0, 1] } }, "zh"), "定时器 %TM0：IN=1, Q=0；当前值 x, 预设值 50");
  const drum = { address: "%DR1", kind: "drum", title, grid: { columns: ["%Q0.1", "%Q0.2"], rows: ["11", "00"], active: 0 } };
  assert.equal(describeBlock(drum, "zh"), "块 %DR1：第0步, 接通%Q0.1、%Q0.2");
  assert.match(describeBlock({ ...drum, grid: { ...drum.grid, active: 1 } }, "en"), /step 1, on: nothing/u);
  assert.match(describeBlock({ ...drum, grid: { ...drum.grid, active: -1 } }, "en"), /unknown/u);
  assert.match(describeBlock(shift("0101", "high"), "en"), /the highest first: 0101$/u);
  assert.match(describeBlock(queue(["80", "50"]), "en"), /2 words, from the bottom up: 80 50$/u);
});
