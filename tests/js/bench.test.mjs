// Knows that bench and desk keep their promises: stale answers dropped, nothing typed lost, the verdict laid out.
import assert from "node:assert/strict";
import { mock, test } from "node:test";
import {
  draftKey, draftToOffer, marksText, nextSize, paragraphs, placeInNext, readTrait, rowOfStep, sameAddresses,
  stepOfRow, switchRows, valueText, verdictGroups,
} from "../../plcteach/figure/static/worksheet.js";
import { openSession } from "../../plcteach/figure/static/panel.js";
import { fakeModel } from "./fake-model.mjs";

const film = (rows, scans = 1) => ({
  lines: rows.map((row) => ({ row })),
  steps: Array.from({ length: scans }, (_, scan) => [-1, ...rows.keys()].map((line) => ({ line, scan }))).flat(),
});

test("traits are read whether they are missing, text or broken", () => {
  const model = fakeModel({ inputs: '{"I0.0": 1}', film: "", report: undefined, task: "{", size: 1.5 });
  assert.deepEqual(readTrait(model, "inputs", {}), { "I0.0": 1 });
  assert.equal(readTrait(model, "film", null), null);
  assert.equal(readTrait(model, "report", null), null);
  assert.deepEqual(readTrait(model, "task", {}), {});
  assert.equal(readTrait(model, "size", 1), 1.5);
});

test("a value is 0, 1 or x, whichever way it was sent", () => {
  assert.deepEqual([0, 1, "0", "1", true, false, "x", null, undefined].map(valueText), ["0", "1", "0", "1", "1", "0", "x", "x", "x"]);
});

test("what was switched here counts before the kernel has answered", () => {
  const rows = switchRows([{ address: "I0.0", value: 0 }, { address: "I0.1", value: "1" }, { address: "I0.2", value: "x" }], { "I0.0": 1 });
  assert.deepEqual(rows.map(({ value }) => value), ["1", "1", "0"]);
  assert.ok(sameAddresses(rows, [{ address: "I0.0" }, { address: "I0.1" }, { address: "I0.2" }]));
  assert.ok(!sameAddresses(rows, [{ address: "I0.1" }, { address: "I0.0" }, { address: "I0.2" }]));
});

test("steps and rows find each other, in the scan that is shown", () => {
  const two = film([1, 2, 4], 2);
  assert.equal(rowOfStep(two, 0), 0);
  assert.equal(rowOfStep(two, 3), 4);
  assert.equal(rowOfStep(null, 3), 0);
  assert.equal(stepOfRow(two, 2, 1), 2);
  assert.equal(stepOfRow(two, 2, 5), 6);
  assert.equal(stepOfRow(two, 3, 0), -1);
  assert.equal(stepOfRow(null, 3, 0), -1);
});

test("the next film stands on the same row, or at the start of a new scan", () => {
  assert.equal(placeInNext(film([1, 2, 3]), 2, film([1, 2, 3, 4])), 2);
  assert.equal(placeInNext(film([1, 2, 3]), 3, film([2, 3])), 2);
  assert.equal(placeInNext(film([1, 2]), 2, film([1, 2], 2)), 3);
  assert.equal(placeInNext(film([1, 2, 3]), 3, film([1])), 1);
  assert.equal(placeInNext(null, 2, film([1, 2])), 2);
  assert.equal(placeInNext(film([1]), 1, { lines: [], steps: [] }), 0);
});

test("a draft is offered only when it holds something else", () => {
  assert.equal(draftToOffer(null, "LD"), null);
  assert.equal(draftToOffer({ text: "LD" }, "LD"), null);
  assert.equal(draftToOffer({ text: " \n" }, "LD"), null);
  assert.equal(draftToOffer({ at: 3 }, "LD"), null);
  assert.equal(draftToOffer({ text: "LDN", at: 3 }, "LD").text, "LDN");
  assert.notEqual(draftKey("a.stl"), draftKey("b.stl"));
});

test("type sizes go up and down and end", () => {
  assert.equal(nextSize(1, 1), 1.15);
  assert.equal(nextSize(1, -1), 1);
  assert.equal(nextSize(2.5, 1), 2.5);
  assert.equal(nextSize(1.4, -1), 1.3);
  assert.equal(nextSize(undefined, 1), 1.15);
});

test("marks are written as people write them", () => {
  assert.deepEqual([3.0, 2.5, 4 / 3, 0, undefined].map(marksText), ["3", "2.5", "1.33", "0", "0"]);
});

test("a verdict becomes one row of a truth table; only what came can differ", () => {
  const rows = [
    { address: "Q0.0", kind: "got", value: "0", differs: true }, { address: "I0.0", kind: "input", value: 1 },
    { address: "Q0.0", kind: "expected", value: "1", differs: true },
  ];
  assert.deepEqual(verdictGroups(rows).map(({ kind, cells }) => [kind, cells.map(({ value, differs }) => [value, differs])]),
    [["input", [["1", false]]], ["expected", [["1", false]]], ["got", [["0", true]]]]);
  assert.deepEqual(verdictGroups([]), []);
});

test("a task falls into paragraphs", () => {
  assert.deepEqual(paragraphs("one\ntwo\n\n three\n\n\n"), ["one\ntwo", "three"]);
});

/** A session on a fake model, with what it told. */
function listen(model) {
  const heard = { reports: [], late: [] };
  const session = openSession(model, { onReport: (report) => heard.reports.push(report), onWaiting: (late) => heard.late.push(late) });
  return { session, heard };
}

test("an answer to an older change is dropped", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const model = fakeModel({ serial: 0, source: "", report: "" });
  const { session, heard } = listen(model);
  session.tell({ source: "L" });
  session.tell({ source: "LD" });
  assert.deepEqual(model.saved, [{ source: "L", serial: 1 }, { source: "LD", serial: 2 }]);
  model.fromPython({ report: JSON.stringify({ source: 1 }) });
  assert.equal(heard.reports.length, 0);
  model.fromPython({ report: JSON.stringify({ source: 2, ok: true }) });
  assert.equal(heard.reports.length, 1);
  session.close();
  assert.equal(model.listening(), 0);
  mock.timers.reset();
});

test("a film that comes after its report is heard too", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const model = fakeModel({ serial: 0, film: "", report: "" });
  const { session, heard } = listen(model);
  session.tell({ source: "LD" });
  model.fromPython({ film: "{}" });
  model.fromPython({ report: JSON.stringify({ source: 1 }) });
  model.fromPython({ film: '{"steps":[]}' });
  assert.equal(heard.reports.length, 2);
  session.close();
  mock.timers.reset();
});

test("a kernel that does not answer for three seconds is mentioned, one that is gone stops nobody", () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  const model = fakeModel({ serial: 0, report: "" });
  const { session, heard } = listen(model);
  model.save_changes = () => { throw new Error("comm closed"); };
  session.tell({ source: "LD" });
  mock.timers.tick(2900);
  assert.deepEqual(heard.late, []);
  mock.timers.tick(200);
  assert.deepEqual(heard.late, [true]);
  assert.equal(model.get("source"), "LD");
  model.fromPython({ report: JSON.stringify({ source: 1 }) });
  assert.deepEqual(heard.late, [true, false]);
  session.close();
  mock.timers.reset();
});

test("what is typed but not yet sent goes before a message", () => {
  const model = fakeModel({ serial: 0, source: "" });
  const order = [];
  const session = openSession(model, { onReport: () => {}, onWaiting: () => {}, beforeTelling: () => order.push("flush") });
  model.send = (message) => order.push(message.type);
  session.send({ type: "check" });
  session.close();
  assert.deepEqual(order, ["flush", "check"]);
});
