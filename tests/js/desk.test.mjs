// Knows that every form of an answer writes the text that Python judges, and reads it back as it was.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  blockEnds, blockOf, blockText, cellAfterKey, choiceLetter, choiceOf, gridCells, gridText, makeHistory, marksOfVerdict,
  movedEntry, nextSign, orderedLines, orderText, placeAmong, signOfKey, withCell, withEnd,
} from "../../plcteach/figure/static/desk-answer.js";
import { keptWords } from "../../plcteach/figure/static/desk-parts.js";
import { filledText } from "../../plcteach/figure/static/quiz.js";

const OFFERED = ["= Q0.0", "LD I0.0", "A I0.1", "LD I0.0"];

test("lines are found among those offered, each as often as it is offered", () => {
  const { used, tray } = orderedLines("ld  i0.0\n\nLD I0.0\nLD I0.0\nOLD\n", OFFERED);
  assert.deepEqual(used, [{ text: "LD I0.0", at: 1 }, { text: "LD I0.0", at: 3 }, { text: "LD I0.0", at: -1 }, { text: "OLD", at: -1 }]);
  assert.deepEqual(tray, [0, 2]);
  assert.deepEqual(orderedLines("", OFFERED), { used: [], tray: [0, 1, 2, 3] });
});

test("lines in order are written one a row, and read back the same", () => {
  const { used } = orderedLines("LD I0.0\nA I0.1\n= Q0.0\n", OFFERED);
  assert.equal(orderText(used), "LD I0.0\nA I0.1\n= Q0.0\n");
  assert.equal(orderText(movedEntry(used, 2, 0)), "= Q0.0\nLD I0.0\nA I0.1\n");
  assert.equal(orderText([]), "");
});

test("an entry moves to any place and no further than the ends", () => {
  assert.deepEqual([[0, 2], [2, 0], [1, 1], [0, 9], [2, -5]].map(([from, to]) => movedEntry(["a", "b", "c"], from, to).join("")), ["bca", "cab", "abc", "bca", "cab"]);
  assert.deepEqual([[0, 5], [10, 5], [25, 5], [99, 5]].map(([y]) => placeAmong([5, 15, 30], y)), [0, 1, 2, 3]);
});

const PREDICT = { kind: "predict", rows: ["LD I0.0", "A I0.1"], columns: ["1", "2", "3"] };
const CHART = { kind: "chart", rows: ["Q0.0", "Q0.1"], columns: ["1", "2", "3", "4", "5", "6", "7"] };

test("a prediction is a row of signs for each instruction", () => {
  const cells = gridCells("1 . .\n0 X\n", PREDICT);
  assert.deepEqual(cells, [["1", ".", "."], ["0", "x", "."]]);
  assert.equal(gridText(cells, PREDICT), "1 . .\n0 x .\n");
  assert.deepEqual(gridCells("", PREDICT), [[".", ".", "."], [".", ".", "."]]);
  assert.deepEqual(gridCells("10?\n<b>1", PREDICT), [["1", "0", "."], [".", ".", "."]]);
});

test("a chart's rows begin with their address, in any order, with either way of writing 0 and 1", () => {
  const cells = gridCells("q0.1: ##__1 01\nQ0.0 0 1 1\n", CHART);
  assert.deepEqual(cells.map((row) => row.join("")), ["011....", "1100101"]);
  assert.equal(gridText(cells, CHART), "Q0.0 011.. ..\nQ0.1 11001 01\n");
  assert.deepEqual(gridCells(gridText(cells, CHART), CHART), cells);
});

test("a cell goes through its signs with every press, and keys write or move", () => {
  assert.deepEqual([".", "0", "1", "x"].map((sign) => nextSign("predict", sign)), ["0", "1", "x", "."]);
  assert.deepEqual([".", "1", "0", "x"].map((sign) => nextSign("chart", sign)), ["1", "0", ".", "."]);
  assert.deepEqual(["0", "X", "Delete", "5", "ArrowUp"].map((key) => signOfKey(key, "predict")), ["0", "x", ".", null, null]);
  assert.equal(signOfKey("x", "chart"), null);
  assert.deepEqual(cellAfterKey("ArrowRight", 0, 2, 2, 3), [0, 2]);
  assert.deepEqual(cellAfterKey("ArrowDown", 0, 1, 2, 3), [1, 1]);
  assert.deepEqual(cellAfterKey("Home", 1, 2, 2, 3), [1, 0]);
  assert.equal(cellAfterKey("a", 0, 0, 2, 3), null);
  assert.deepEqual(withCell([["0", "1"]], 0, 1, "x"), [["0", "x"]]);
});

test("a verdict marks every row of a grid, unless the answer could not be read", () => {
  assert.deepEqual(marksOfVerdict({ status: "different", wrong: [[1, 0]] }, 3), { rows: ["right", "wrong", "right"], cells: [[1, 0]] });
  assert.deepEqual(marksOfVerdict({ status: "error" }, 3), {});
  assert.deepEqual(marksOfVerdict({ status: "equal", wrong: [] }, 2), { rows: ["right", "right"], cells: [] });
  assert.deepEqual(marksOfVerdict({ status: "different", wrong: [] }, 2), {}, "of a hidden task no row is called right");
});

test("two blocks are four ends, chosen one after the other in any direction", () => {
  assert.deepEqual([[], [3], [3, 1], [3, 1, 4], [3, 1, 4, 4]].map(blockText), ["", "3", "1-3", "1-3 4", "1-3 4-4"]);
  assert.deepEqual(blockEnds("1-3, 4 - 4", 6), [1, 3, 4, 4]);
  assert.deepEqual(blockEnds("0-99 2", 6), [2]);
  assert.deepEqual([1, 2, 3, 4, 5].map((at) => blockOf([3, 1, 4], at)), [1, 1, 1, 2, 0]);
  assert.deepEqual(withEnd([1, 2, 3, 4], 5), [5]);
});

test("a choice is a letter, or its number", () => {
  assert.deepEqual(["A", " b\n", "3", "4", "AB", "", "0"].map((text) => choiceOf(text, 3)), [0, 1, 2, -1, -1, -1, -1]);
  assert.equal(choiceLetter(2), "C");
});

test("what was there comes back step by step, the last first", () => {
  const history = makeHistory(2);
  ["a", "b", "c"].forEach(history.keep);
  assert.deepEqual([history.back(), history.back(), history.some(), history.back()], ["c", "b", false, undefined]);
});

test("what is kept is said in a few words of either language", () => {
  assert.deepEqual(keptWords({ attempts: 0, best: null }, 4, "en"), ["not checked yet"]);
  assert.deepEqual(keptWords({ attempts: 3, best: 2.5, hints: 1, model: true }, 4, "en"), ["checked 3×", "best mark 2.5 / 4", "hints used: 1", "answer seen"]);
  assert.deepEqual(keptWords({ attempts: 1, best: null, hints: 0 }, 4, "zh"), ["检查 1 次"]);
  assert.equal(filledText({ zh: "{before}/{all}", en: "{value} {}" }, "en", { value: 3 }), "3 3");
});
