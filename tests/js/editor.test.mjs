// Knows that the editor's thinking holds: columns, rows, tab stops, one change at a time, patience with input methods.
import assert from "node:assert/strict";
import { mock, test } from "node:test";
import {
  changeBetween, countProblems, createTeller, drawnRow, markedRange, placeProblems, plainLines, severityOf,
  spacesToDrop, spacesToStop, utf16Column,
} from "../../plcteach/figure/static/problems.js";

const problem = (row, more = {}) => ({ code: "STK001", severity: "error", row, start: 0, stop: 2, text: { zh: "栈", en: "stack" }, ...more });

test("columns in code points become UTF-16 columns", () => {
  const line = "LD 😀I0.0 启动";
  assert.equal(utf16Column(line, 3), 3);
  assert.equal(utf16Column(line, 4), 5);
  assert.equal(line.slice(...markedRange(line, 4, 8)), "I0.0");
  assert.equal(line.slice(...markedRange(line, 9, 11)), "启动");
  assert.equal(utf16Column(line, 99), line.length);
});

test("a marked stretch stays inside its line and never runs backwards", () => {
  assert.deepEqual(markedRange("LD", -3, 99), [0, 2]);
  assert.deepEqual(markedRange("LD", 2, 1), [2, 2]);
  assert.deepEqual(markedRange("", 4, 6), [0, 0]);
  assert.deepEqual(markedRange("LD", undefined, undefined), [0, 0]);
});

test("every diagnostic has a row to stand on", () => {
  assert.equal(drawnRow(0, 5), 0);
  assert.equal(drawnRow(9, 5), 5);
  assert.equal(drawnRow(-1, 5), 0);
  assert.equal(drawnRow(undefined, 5), 0);
  assert.equal(drawnRow(1, 0), 1);
});

test("rows come in order, the gravest first, then from left to right", () => {
  const list = [problem(3, { severity: "info" }), problem(3, { start: 5 }), problem(3, { start: 1 }), problem(0)];
  const rows = [...placeProblems(list, 4)];
  assert.deepEqual(rows.map(([row]) => row), [0, 3]);
  assert.deepEqual(rows[1][1].problems.map(({ severity, start }) => [severity, start]), [["error", 1], ["error", 5], ["info", 0]]);
});

test("a note about another row goes there, any other stays", () => {
  const notes = [{ text: { en: "here" } }, { text: { en: "there" }, row: 1, start: 0, stop: 2 }, { text: { en: "same" }, row: 4 }];
  const rows = placeProblems([problem(4, { notes })], 4);
  assert.deepEqual(rows.get(4).problems[0].near.map(({ text }) => text.en), ["here", "same"]);
  assert.deepEqual(rows.get(1).remarks.map(({ text, code }) => [text.en, code]), [["there", "STK001"]]);
});

test("a severity from a later version counts as information", () => {
  assert.equal(severityOf({ severity: "hint" }), "info");
  assert.deepEqual(countProblems([problem(1), problem(2, { severity: "hint" })]), { error: 1, warning: 0, info: 1 });
});

test("text comes in with line feeds only, full-width characters as typed", () => {
  assert.equal(plainLines("LD I0.0\r\nＡ　I0.1\r= Q0.0"), "LD I0.0\nＡ　I0.1\n= Q0.0");
  assert.equal(plainLines(undefined), "");
});

test("one text becomes another by one change, the same text by none", () => {
  assert.equal(changeBetween("LD I0.0", "LD I0.0"), null);
  for (const [before, after] of [["LD I0.0", "LDN I0.0"], ["", "LD"], ["LD", ""], ["aaa", "aa"], ["aa", "aaa"], ["LD X\nA Y", "LD Z\nA Y"]]) {
    const { from, to, insert } = changeBetween(before, after);
    assert.equal(before.slice(0, from) + insert + before.slice(to), after);
  }
  assert.deepEqual(changeBetween("LD I0.0", "LDN I0.0"), { from: 2, to: 2, insert: "N" });
});

test("Tab goes to the next stop of four, Shift-Tab back", () => {
  assert.deepEqual([0, 1, 2, 3, 4, 5].map((column) => spacesToStop(column)), [4, 3, 2, 1, 4, 3]);
  assert.equal(spacesToDrop("LD  "), 2);
  assert.equal(spacesToDrop("LD      "), 4);
  assert.equal(spacesToDrop("LDN  "), 1);
  assert.equal(spacesToDrop("LD"), 0);
  assert.equal(spacesToDrop(""), 0);
});

test("many touches are told once, and never while an input method composes", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  let told = 0;
  let composing = true;
  const teller = createTeller({ tell: () => { told += 1; }, busy: () => composing });
  teller.touch();
  mock.timers.tick(200);
  teller.touch();
  mock.timers.tick(240);
  assert.equal(told, 0);
  mock.timers.tick(1000);
  assert.equal(told, 0, "still composing");
  composing = false;
  mock.timers.tick(250);
  assert.equal(told, 1);
  teller.touch();
  teller.flush();
  teller.flush();
  assert.equal(told, 2);
  teller.touch();
  teller.stop();
  mock.timers.tick(1000);
  assert.equal(told, 2);
  assert.equal(teller.pending(), false);
  mock.timers.reset();
});
