// Holds the parts of the player that need no page: words, keys, preferences, questions, and names that must not clash.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import test from "node:test";
import { freshScore, isQuestion, isRight, scoreWords, verdictWords } from "../../plcteach/figure/static/ask.js";
import { actOfKey } from "../../plcteach/figure/static/comfort.js";
import { guardKeys, isPageKey, prefersReducedMotion, recall, remember, say } from "../../plcteach/figure/static/ui.js";

const { s7200, fx } = JSON.parse(readFileSync(new URL("sample-film.json", import.meta.url)));
const STATIC = new URL("../../plcteach/figure/static/", import.meta.url);

test("a text is said in the language wanted, or in the other one", () => {
  assert.equal(say({ zh: "栈", en: "stack" }, "zh"), "栈");
  assert.equal(say({ en: "stack" }, "zh"), "stack");
  assert.equal(say({ zh: "栈" }, "en"), "栈");
  assert.equal(say("LD", "en"), "LD");
  assert.deepEqual([say(undefined, "en"), say(null, "zh"), say({}, "zh")], ["", "", ""]);
});

test("the page keeps Tab, Escape and chords; the figure keeps the rest", () => {
  const stopped = [];
  const root = new EventTarget();
  const undo = guardKeys(root);
  const press = (key, chord = {}) => {
    const event = Object.assign(new Event("keydown"), { key, ...chord });
    event.stopPropagation = () => stopped.push(key);
    root.dispatchEvent(event);
  };
  ["b", "ArrowRight", " ", "Tab", "Escape"].forEach((key) => press(key));
  press("s", { ctrlKey: true });
  press("c", { metaKey: true });
  press("f", { altKey: true });
  assert.deepEqual(stopped, ["b", "ArrowRight", " "]);
  undo();
  press("b");
  assert.equal(stopped.length, 3);
  assert.equal(isPageKey({ key: "Tab" }), true);
});

test("preferences survive a closed storage and come back from an open one", () => {
  delete globalThis.localStorage;
  remember("speed", 2);
  assert.equal(recall("speed", 1), 1);
  const kept = new Map();
  globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, value) => kept.set(key, value) };
  remember("speed", 2);
  assert.equal(recall("speed", 1), 2);
  assert.deepEqual([...kept.keys()], ["plc-speed"]);
  kept.set("plc-speed", "{broken");
  assert.equal(recall("speed", 1), 1);
  delete globalThis.localStorage;
});

test("without a page nobody has asked for less motion", () => {
  assert.equal(prefersReducedMotion(), false);
});

test("keys step and play, but leave a focused control what it needs itself", () => {
  const act = (key, tag = "DIV", asked = false, repeat = false) => actOfKey({ key, repeat }, tag, asked)?.[0] ?? null;
  assert.deepEqual(["ArrowRight", "ArrowLeft", "Home", "End", " ", "b"].map((key) => act(key)), ["next", "prev", "first", "last", "play", null]);
  assert.deepEqual([act(" ", "BUTTON"), act("Enter", "BUTTON"), act("ArrowRight", "BUTTON")], [null, null, "next"]);
  assert.deepEqual([act("ArrowRight", "INPUT"), act("Home", "INPUT"), act(" ", "INPUT")], [null, null, "play"]);
  assert.equal(act("ArrowRight", "SELECT"), null);
  assert.equal(act("1"), null);
});

test("with a question open, 0, 1 and x answer, Enter and the right arrow show; holding the arrow down does not", () => {
  assert.deepEqual(["0", "1", "x", "X"].map((key) => actOfKey({ key }, "DIV", true)), [["guess", "0"], ["guess", "1"], ["guess", "x"], ["guess", "x"]]);
  assert.deepEqual(actOfKey({ key: "Enter" }, "DIV", true), ["show"]);
  assert.deepEqual(actOfKey({ key: "ArrowRight" }, "DIV", true), ["next"]);
  assert.deepEqual(actOfKey({ key: "ArrowRight", repeat: true }, "DIV", true), ["wait"]);
  assert.equal(actOfKey({ key: "1" }, "SELECT", true), null);
});

test("a guess is judged, said kindly, and counted", () => {
  const old = s7200.lines.findIndex((line) => line.text === "OLD") + 1;
  assert.ok(isQuestion(s7200, old));
  assert.deepEqual(["0", "1", "x"].map((value) => isRight(s7200, old, value)), [false, true, false]);
  assert.equal(verdictWords(s7200, old, true, "en"), "Right.");
  assert.equal(verdictWords(s7200, old, false, "zh"), "还没对：第1层是 1。");
  assert.match(verdictWords(fx, 1, false, "en"), /the result register is 1/);
  const score = freshScore();
  score.set(3, true).set(4, false).set(4, true).set(5, false);
  assert.equal(scoreWords(score, "en"), "2 of 3 right");
});

/** The modules of the browser side; each render-*.js ends a script of its own and may share its name with the others. */
const modules = readdirSync(STATIC).filter((name) => name.endsWith(".js"));

/** The names that a module declares at its top level. */
function topNames(text) {
  return [...text.matchAll(/^(?:export )?(?:async )?(?:function\*?|const|let|var|class) ([\w$]+)/gm)].map((match) => match[1]);
}

test("no name is declared at the top of two modules, since Python makes one script of them", () => {
  const owners = new Map();
  for (const file of modules.filter((name) => !name.startsWith("render-"))) {
    for (const name of topNames(readFileSync(new URL(file, STATIC), "utf8"))) owners.set(name, [...(owners.get(name) ?? []), file]);
  }
  assert.deepEqual([...owners].filter(([, files]) => files.length > 1), []);
});

test("modules can be joined: one-line imports from beside, no default, nothing dynamic, nothing fetched", () => {
  for (const file of modules) {
    const text = readFileSync(new URL(file, STATIC), "utf8").replace(/\/\*\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]/g, ""));
    for (const [line] of text.matchAll(/^import .*$/gm)) assert.match(line, /^import .* from "\.\/[\w./-]+\.js";$/, file);
    assert.doesNotMatch(text, /^export default|^await |\bimport\(|\bfetch\(|\beval\(|\.innerHTML\b|\binsertAdjacentHTML\b/m, file);
    assert.ok(text.split("\n").length <= 301, `${file} has more than 300 lines`);
  }
});
