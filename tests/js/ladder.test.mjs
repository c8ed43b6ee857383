// Holds the pure readers of a film's ladder to a small hand-made film; run with `node --test tests/js/`.

import assert from "node:assert/strict";
import test from "node:test";
import { builtAt, executedAt, linesOfPart, litAt, netOf, wiresBuilt } from "../../plcteach/figure/static/ladder-shape.js";

/** LD a, LD b, OLD, = q in two scans: two contacts in parallel and a coil. */
function hand() {
  return {
    ladder: {
      rungs: [{ lines: [[0], [1, 2], [3]], nets: { 1: [0, 1] }, joints: { "1-0": 2 } }],
      growth: [{ added: ["s0-0"] }, { added: ["s0-1"] }, { blocks: [["s0-0"], ["s0-1"]] }, { added: ["s0-2"] }],
    },
    steps: [
      { line: -1 },
      { line: 0, power: [["n0-0", 1], ["n0-1", 1], ["s0-0", 1]] }, { line: 1 }, { line: 2 }, { line: 3, power: [["s0-2", 1]] },
      { line: -1, power: [["n0-1", 0], ["s0-0", 0], ["s0-2", 0]] }, { line: 0 },
    ],
  };
}

test("the ladder grows sign by sign and begins anew with each scan", () => {
  const film = hand();
  const seen = film.steps.map((_, at) => [...builtAt(film, at)]);
  assert.deepEqual(seen, [
    [], ["s0-0"], ["s0-0", "s0-1"], ["s0-0", "s0-1"], ["s0-0", "s0-1", "s0-2"], [], ["s0-0"],
  ]);
  assert.deepEqual([...builtAt(hand(), 6)], ["s0-0"], "the last step alone gives the same");
});

test("power comes and goes by what each step says", () => {
  const film = hand();
  const on = (at) => [...litAt(film, at)].sort();
  assert.deepEqual(on(0), []);
  assert.deepEqual(on(3), ["n0-0", "n0-1", "s0-0"]);
  assert.deepEqual(on(4), ["n0-0", "n0-1", "s0-0", "s0-2"]);
  assert.deepEqual(on(6), ["n0-0"]);
});

test("a wire is there once one of the signs on its left is, the rail always, a joint once its join has been executed", () => {
  const film = hand();
  const at = (index) => [...wiresBuilt(film, builtAt(film, index), executedAt(film, index))].sort();
  const rail = ["j0-0-0", "j0-0-1", "n0-0"];
  assert.deepEqual(at(0), rail);
  assert.deepEqual(at(2), rail);
  assert.deepEqual(at(3), [...rail, "j0-1-0", "j0-1-1", "n0-1"].sort());
  assert.deepEqual(at(6), rail, "the next scan begins anew");
  assert.equal(netOf("j0-1-0"), "n0-1");
  assert.equal(netOf("n0-1"), "n0-1");
});

test("a sign names the lines that made it, its own first", () => {
  assert.deepEqual(linesOfPart(hand(), "s0-1"), [1, 2]);
  assert.deepEqual(linesOfPart(hand(), "s0-9"), []);
});
