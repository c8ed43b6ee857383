// Holds the arithmetic of the live bench to hand-worked cases; run with `node --test tests/js/`.

import assert from "node:assert/strict";
import test from "node:test";
import { tapeWords } from "../../plcteach/figure/static/live-replay.js";
import { bitPath, freshNews, gridStep, stretches, takeBatch, timeWords, trimTracks, valueAt } from "../../plcteach/figure/static/live-shape.js";

test("a batch changes what it names and leaves the rest; faces one by one, the chart behind what was there", () => {
  const first = takeBatch(freshNews(), { bits: { Q: "0" }, faces: { T37: { value: 1 }, T38: {} }, chart: { Q: [[0, "0"]] }, scan: 3, now: 30 });
  const second = takeBatch(first, { bits: { Q: "1" }, faces: { T37: { value: 2 } }, chart: { Q: [[40, "1"]] }, scan: 4, now: 40 });
  assert.deepEqual(second.bits, { Q: "1" });
  assert.deepEqual(second.faces, { T37: { value: 2 }, T38: {} });
  assert.deepEqual(second.tracks, { Q: [[0, "0"], [40, "1"]] });
  assert.equal(second.scan, 4);
  assert.deepEqual(takeBatch(second, { anew: true, chart: { Q: [[0, "0"]] } }).tracks, { Q: [[0, "0"]] });
});

test("a row has its last value at a moment, and stretches within a window", () => {
  const row = [[0, "0"], [20, "1"], [50, "0"]];
  assert.deepEqual([-1, 0, 19, 20, 99].map((ms) => valueAt(row, ms)), ["", "0", "0", "1", "0"]);
  assert.equal(valueAt(undefined, 5), "");
  assert.deepEqual(stretches(row, 10, 40), [[10, 20, "0"], [20, 40, "1"]]);
  assert.deepEqual(stretches(row, 60, 80), [[60, 80, "0"]]);
  assert.deepEqual(stretches([], 0, 10), []);
});

test("the line of a bit is high for 1, low for 0, and empty where nothing has run yet", () => {
  const place = { start: 0, stop: 100, x: 10, width: 100, top: 5, height: 10 };
  assert.equal(bitPath([[0, "0"], [40, "1"]], place), "M10,15L50,15L50,5L110,5");
  assert.equal(bitPath([[0, "1"]], { ...place, until: 50 }), "M10,5L60,5");
  assert.equal(bitPath([[0, "x"]], { ...place, until: 50 }), "M10,10L60,10");
});

test("old changes go, but the last value before the window stays", () => {
  const tracks = { Q: [[0, "0"], [10, "1"], [20, "0"], [90, "1"]] };
  trimTracks(tracks, 50);
  assert.deepEqual(tracks.Q, [[20, "0"], [90, "1"]]);
});

test("grid lines stand at round numbers, about six in a window", () => {
  assert.deepEqual([500, 1000, 5000, 60000, 300000].map((span) => gridStep(span)), [100, 200, 1000, 10000, 50000]);
  assert.equal(timeWords(1230), "1.23 s");
});

test("the strip says how long a recording is, that it is over, and whether the outputs were as recorded", () => {
  const tape = { end: 12340, over: false, tells: true, same: true };
  assert.match(tapeWords(tape, "en"), /12\.34 s/);
  assert.match(tapeWords({ ...tape, over: true }, "en"), /as recorded/);
  assert.equal(tapeWords({ ...tape, over: true, tells: false }, "en"), "The recording is over.");
  for (const over of [false, true]) assert.match(tapeWords({ ...tape, over, same: false }, "zh"), /不同/);
});
