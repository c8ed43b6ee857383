// Holds the pure readers of a Film to what the sample films show; run with `node --test tests/js/`.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import * as film from "../../plcteach/figure/static/film.js";

const FILMS = JSON.parse(readFileSync(new URL("sample-film.json", import.meta.url)));
const { s7200, fx, neza, gutta } = FILMS;
const stepAfter = (one, text, nth = 1) => {
  const lines = one.lines.map((line, at) => [line.text, at]).filter(([words]) => words === text);
  return film.stepOfLine(one, lines[nth - 1][1]);
};

test("a film is read from JSON text or from an object, and nothing is no film", () => {
  assert.equal(film.readFilm(JSON.stringify(fx)).steps.length, fx.steps.length);
  assert.equal(film.readFilm(fx), fx);
  for (const nothing of ["", null, undefined, { steps: [] }]) assert.equal(film.readFilm(nothing), null);
});

test("an index is kept within the film", () => {
  const last = fx.steps.length - 1;
  assert.deepEqual([-4, 3.4, 999, "2", NaN, undefined].map((i) => film.clampIndex(fx, i)), [0, 3, last, 2, 0, 0]);
});

test("each sample keeps its own promises: unique keys, known parents, places within the columns", () => {
  for (const [name, one] of Object.entries(FILMS)) {
    one.steps.forEach((step, at) => {
      const keys = step.cells.map(([key]) => key);
      const before = at ? one.steps[at - 1].cells.map(([key]) => key) : [];
      assert.equal(new Set(keys).size, keys.length, `${name} ${at}: keys are unique`);
      for (const parent of Object.values(step.from ?? {}).flat()) assert.ok(before.includes(parent), `${name} ${at}: ${parent}`);
      for (const gone of Object.keys(step.leave ?? {})) assert.ok(before.includes(gone) && !keys.includes(gone));
      for (const [, column, position] of step.cells) assert.ok(position < one.columns[column].drawn);
      assert.ok(step.say.zh && step.say.en);
    });
  }
});

test("a cell has its formula, name and marks by name", () => {
  const old = stepAfter(s7200, "OLD");
  const top = film.topAt(s7200, old);
  assert.equal(top.value, "1");
  assert.equal(top.formula, "I0.0·I0.1+I0.2·/I0.3");
  assert.equal(top.name, "S2");
  const left = film.cellsAt(s7200, stepAfter(s7200, "LD I1.0")).find((cell) => cell.foreign);
  assert.deepEqual([left.spent, left.position], [true, 1]);
  const saved = film.cellsAt(fx, stepAfter(fx, "LD X1")).find((cell) => cell.position === 1);
  assert.equal(saved.tag, "L");
  assert.equal(film.cellOf({ texts: [] }, ["k", 0, 0, "x", -1, -1]).formula, "");
});

test("the bit that is written keeps its colour in that step and looks used in the next", () => {
  const top = (one, index) => film.cellsAt(one, index).find((cell) => cell.column === 0 && cell.position === 0);
  const seen = [];
  for (const one of Object.values(FILMS)) {
    one.steps.forEach((step, out) => {
      if (!step.write?.length || !film.topAt(one, out).spent) return;
      assert.equal(top(one, out).spent, false);
      const later = one.steps[out + 1]?.write?.length ? null : one.steps[out + 1]?.cells.find(([key]) => key === top(one, out).key);
      if (later) seen.push(film.cellsAt(one, out + 1).find((cell) => cell.key === later[0]).spent);
    });
  }
  assert.ok(seen.length > 0 && seen.every(Boolean));
});

test("the letters on cells are explained where a film shows them, and only there", () => {
  assert.deepEqual(film.tagsOf(fx, "en"), [["B", "branch point"], ["L", "block"]]);
  assert.deepEqual(film.tagsOf(fx, "zh").map(([, word]) => word), ["分支点", "电路块"]);
  assert.deepEqual(film.tagsOf(s7200, "en"), []);
});

test("only a step that writes the top asks a question", () => {
  const asks = (one, text, nth) => film.writesTop(one, stepAfter(one, text, nth));
  for (const text of ["LD I0.0", "A I0.1", "OLD", "ALD", "LPS", "LRD", "LPP"]) assert.ok(asks(s7200, text), text);
  assert.equal(asks(s7200, "= Q0.0"), false);
  assert.equal(asks(fx, "MPS"), false);
  assert.ok(asks(fx, "ANB"));
  assert.ok(asks(neza, ")"));
  assert.equal(asks(neza, "MPS"), false);
  assert.equal(asks(gutta, "LPS"), false);
  assert.ok(asks(gutta, "NOT"));
  assert.equal(film.writesTop(s7200, 0), false);
  assert.equal(film.writesTop(s7200, 999), false);
});

test("a question does not betray that the value changes, and the start of a scan asks nothing", () => {
  const cells = (formula) => [["k", 0, 0, "1", formula, -1]];
  const steps = [{ line: -1, cells: cells(0) }, { line: 0, cells: cells(1) }, { line: 1, cells: cells(1) }, { line: -1, cells: cells(0) }];
  const one = { columns: s7200.columns, texts: ["I0.0", "I0.0·I0.1"], lines: [{ text: "A I0.1" }, { text: "= Q0.0" }], steps };
  assert.deepEqual([1, 2, 3].map((at) => film.writesTop(one, at)), [true, false, false]);
});

test("an emptied first column asks nothing", () => {
  const one = { columns: s7200.columns, texts: [], lines: [], steps: [{ cells: [["k", 0, 0, "1", -1, -1]] }, { cells: [] }] };
  assert.equal(film.writesTop(one, 1), false);
});

test("a line leads to its first step, in the scan on screen if it comes there", () => {
  assert.equal(film.stepOfLine(s7200, 0), 1);
  assert.equal(film.stepOfLine(s7200, 999), -1);
  const steps = [[-1, 0], [0, 0], [1, 0], [-1, 1], [0, 1]].map(([line, scan]) => ({ line, scan, cells: [] }));
  const scans = { lines: [{ text: "a" }, { text: "b" }], steps };
  assert.equal(film.stepOfLine(scans, 0, 0), 1);
  assert.equal(film.stepOfLine(scans, 0, 3), 4);
  assert.equal(film.stepOfLine(scans, 1, 4), 2);
  assert.equal(film.scanCount(scans), 2);
  assert.equal(film.scanCount(s7200), 1);
});

test("instructions are set in two columns", () => {
  assert.deepEqual(film.splitLine("LD  I0.0"), { head: "LD", rest: "I0.0" });
  assert.deepEqual(film.splitLine("OLD"), { head: "OLD", rest: "" });
  assert.deepEqual(film.splitLine("TON T37, 100 "), { head: "TON", rest: "T37, 100" });
  assert.deepEqual([s7200, fx, neza].map(film.headWidth), [3, 3, 4]);
  assert.equal(film.headWidth({ lines: [{ text: "[%MW0:=%MW1+%MW2]" }] }), 8);
  assert.equal(film.headWidth({ lines: [] }), 3);
});

test("what is read and written stands on chips", () => {
  assert.deepEqual(film.chipsAt(s7200, 1).map((chip) => chip.text), ["I0.0 = 1"]);
  const out = film.chipsAt(s7200, stepAfter(s7200, "= Q0.0"));
  assert.deepEqual(out, [{ kind: "write", address: "Q0.0", value: "1", text: "Q0.0 := 1" }]);
  assert.deepEqual(film.chipsAt(s7200, 0), []);
});

test("positions are called as the books call them", () => {
  const [stack] = s7200.columns;
  const [register] = fx.columns;
  assert.equal(film.positionName(stack, 0, "zh"), "第1层");
  assert.equal(film.positionName(stack, 8, "en"), "level 9");
  assert.equal(film.positionName(register, 0, "zh"), "运算结果寄存器");
  assert.equal(film.positionName(register, 1, "en"), "level 1");
});

test("a cell is put into words as far as they are wanted", () => {
  const cell = film.topAt(s7200, stepAfter(s7200, "OLD"));
  assert.equal(film.describeCell(cell, "en"), "1");
  assert.equal(film.describeCell(cell, "en", { names: true }), "S2 = 1");
  assert.equal(film.describeCell(cell, "en", { formulas: true }), "1 = I0.0·I0.1+I0.2·/I0.3");
  assert.equal(film.describeCell({ ...cell, spent: true, foreign: true, tag: "B" }, "zh"), "1 (分支点, 已用过, 别的网络留下的)");
  const long = film.describeCell({ ...cell, formula: "I0.0·".repeat(5000) }, "en", { formulas: true });
  assert.ok(long.length < 200 && long.endsWith("…"));
});

test("a long text is cut between characters, not within one", () => {
  assert.equal(film.shortenText("abc", 3), "abc");
  assert.equal(film.shortenText("abcd", 3), "ab…");
  assert.equal(film.shortenText("😀😀😀😀", 3), "😀😀…");
});

test("the picture is read from top to bottom", () => {
  const words = film.describePicture(s7200, stepAfter(s7200, "OLD"), "en");
  assert.ok(words.startsWith("Step 5 of 29, after OLD. logic stack, from top to bottom: level 1 1; level 2 x;"), words);
  assert.ok(film.describePicture(gutta, 0, "zh").endsWith("辅助栈，从栈顶到栈底：空"));
  assert.ok(film.describeStep(fx, 0, "zh").endsWith("程序开始之前"));
  const dollars = { ...fx, lines: [{ text: "LD $&" }], steps: [fx.steps[0], { ...fx.steps[1], line: 0 }] };
  assert.equal(film.describeStep(dollars, 1, "en"), "Step 1 of 1, after LD $&");
});
