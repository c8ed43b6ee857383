// Knows the live bench: it asks the kernel for the next scans, sends what was pressed, and shows the answer; no request, no run.

import { guardKeys, h, recall, remember, say } from "./ui.js";
import { buildLadder, makeLadderView } from "./ladder-view.js";
import { mountBlocks } from "./block-view.js";
import { mountPlayer } from "./player.js";
import { buildLiveChart, makeLiveChart } from "./live-chart.js";
import { buildInputs, buildShows, listenToNumbers, makeInputs, makeShows } from "./live-io.js";
import { buildStatusList, makeStatusList } from "./live-list.js";
import { drawPlant, makePlantView } from "./plant-view.js";
import { levelChoice, liveWord, showFrozen, showRunning, writeBar } from "./live-bar.js";
import { showMoment } from "./live-moment.js";
import { makeTape, saveTimeline, writeTape } from "./live-replay.js";
import { MOST_MS, freshNews, takeBatch, trimTracks } from "./live-shape.js";

const FOLDS = ["plant", "ladder", "list", "blocks", "chart"];
const HISTORY_MS = 600000;
const LATE_MS = 3000;
const IN_FLIGHT = 2;
const IN_HASTE = 4;

/**
 * Puts a live bench into `root`. `send(message)` reaches the kernel, which answers through `take(message)`.
 * @param {HTMLElement} root
 * @param {{cast: object, send: (message: object) => void, lang: "zh"|"en", size?: number, onLang?: Function}} options
 */
export function mountLive(root, { cast, send, lang, size = 1, compact = false }) {
  const bench = makeBench(cast, send, lang);
  bench.figure.style.setProperty("--plc-size", String(size));
  root.classList.add("plc-root");
  root.append(bench.figure);
  const unguard = guardKeys(bench.figure);
  const unlisten = listenToNumbers(bench.inputs, bench.figure, bench.stage);
  bench.figure.classList.toggle("plc-compact", compact);
  writeBench(bench);
  ask(bench, { type: "look" });
  return {
    take: (message) => takeAnswer(bench, message),
    cast: (next) => (Object.assign(bench, { cast: next, news: freshNews() }), writeBench(bench), ask(bench, { type: "look", anew: true })),
    lang: (next) => (Object.assign(bench, { lang: next }), writeBench(bench), showMoment(bench)),
    destroy: () => {
      halt(bench);
      clearTimeout(bench.patience);
      bench.player?.destroy();
      bench.blocks.destroy();
      unguard();
      unlisten();
      bench.figure.remove();
    },
  };
}

/** The parts of a bench and what it knows. */
function makeBench(cast, send, lang) {
  const bench = {
    cast, send, lang, news: freshNews(), running: false, asked: 0, answered: 0, last: 0, debt: 0, at: null, queue: [],
    pace: recall("live-pace", 1), levels: recall("live-levels", 1), folds: recall("live-folds", {}), frame: 0, player: null, patience: null,
  };
  bench.inputs = makeInputs((address, value) => press(bench, address, value), (address) => press(bench, address, null));
  bench.lamps = makeShows("lamps");
  bench.words = makeShows("words");
  bench.rungs = makeLadderView(() => {}, () => {});
  bench.list = makeStatusList();
  bench.shelf = h("div", {});
  bench.blocks = mountBlocks(bench.shelf, lang);
  bench.chart = makeLiveChart((ms) => lookAt(bench, ms));
  bench.plant = makePlantView((symbol, down) => press(bench, `@${symbol}`, down ? 1 : 0), (symbol, how) => ask(bench, { type: "wire", symbol, how }));
  bench.tape = makeTape(() => takeOver(bench));
  bench.bar = h("div", { className: "plc-transport" });
  bench.note = h("p", { className: "plc-live-note", role: "status" });
  bench.faults = h("div", { className: "plc-live-faults", role: "alert" });
  bench.stage = h("div", { className: "plc-live-stage", hidden: true });
  bench.panels = {};
  bench.body = h("div", { className: "plc-live-body" });
  bench.figure = h("div", { className: "plc-player plc-livebench", role: "group", tabindex: -1 },
    bench.bar, bench.tape.node, bench.note, bench.faults, h("div", { className: "plc-live-io" }, bench.inputs.node, bench.lamps.node, bench.words.node), bench.stage, bench.body);
  return bench;
}

/** Writes every word in the bench's language. */
function writeBench(bench) {
  const { cast, lang, figure } = bench;
  figure.lang = lang === "zh" ? "zh-CN" : "en";
  figure.setAttribute("aria-label", liveWord("bench", lang));
  writeBar(bench, actsOfBench(bench));
  writeTape(bench.tape, lang);
  bench.tape.shown = undefined;
  buildInputs(bench.inputs, cast.inputs, lang);
  buildShows(bench.lamps, cast.lamps, lang);
  buildShows(bench.words, cast.words, lang);
  buildLadder(bench.rungs, cast, lang, { shown: true, formulas: false });
  buildStatusList(bench.list, cast, lang, bench.levels);
  buildLiveChart(bench.chart, cast.rows, lang);
  if (cast.plant) drawPlant(bench.plant, cast.plant, lang);
  writePanels(bench);
}

/** The panels that can be folded away: only those that have something to show. */
function writePanels(bench) {
  const { cast, lang } = bench;
  const inside = { plant: cast.plant && bench.plant.node, ladder: cast.ladder?.rungs.length && bench.rungs.node, list: bench.list.node, blocks: bench.shelf, chart: bench.chart.node };
  bench.panels = {};
  const panels = FOLDS.filter((name) => inside[name]).map((name) => {
    const panel = h("details", { className: `plc-live-panel plc-live-${name}`, open: bench.folds[name] !== false },
      h("summary", {}, liveWord(name, lang)), inside[name]);
    panel.addEventListener("toggle", () => {
      bench.folds[name] = panel.open;
      remember("live-folds", bench.folds);
      if (panel.open) showMoment(bench);
    });
    bench.panels[name] = panel;
    return panel;
  });
  bench.body.replaceChildren(...panels);
  if (bench.panels.list) bench.panels.list.querySelector("summary").after(levelChoice(bench, () => {
    buildStatusList(bench.list, bench.cast, bench.lang, bench.levels);
    showMoment(bench);
  }));
}

/** What each control does. */
function actsOfBench(bench) {
  return {
    run: () => (bench.running ? halt(bench) : start(bench)),
    scan: () => oneScan(bench),
    freeze: () => freeze(bench),
    past: (scan) => lookBack(bench, scan),
    restart: () => begin(bench, "cold"),
    warm: () => begin(bench, "warm"),
    save: () => ask(bench, { type: "timeline" }),
    replay: () => replay(bench, {}),
    load: (text) => replay(bench, { text }),
  };
}

// the talk with the kernel

/** Asks for something; the note says so when no answer comes. */
function ask(bench, message) {
  bench.asked += 1;
  clearTimeout(bench.patience);
  bench.patience = setTimeout(() => (bench.note.textContent = liveWord("late", bench.lang)), LATE_MS);
  const events = bench.queue.splice(0);
  try {
    bench.send({ ...message, id: bench.asked, ...(events.length ? { events } : {}) });
  } catch {
    // the connection is closed: the note after three seconds says so
  }
}

/** Takes an answer; they come in the order of the requests. */
function takeAnswer(bench, message) {
  bench.answered = Math.max(bench.answered, message.id ?? 0);
  if (message.type === "film") return showFilmOf(bench, message.film);
  if (message.type === "timeline") return saveTimeline(message.text, message.name);
  if (message.type === "refused") return refuse(bench, message.says);
  if (message.type !== "batch") return;
  clearTimeout(bench.patience);
  bench.note.textContent = "";
  bench.news = takeBatch(bench.news, message);
  trimTracks(bench.news.tracks, bench.news.end - HISTORY_MS);
  if (bench.running && message.tape?.over) halt(bench);
  showMoment(bench);
  if (message.anew && message.tape) start(bench);
}

/** Says why a recording cannot be replayed. */
function refuse(bench, says) {
  clearTimeout(bench.patience);
  bench.note.textContent = says.map((one) => say(one, bench.lang)).join(" ");
}

/** Runs on: with each frame of the page one request, and never more than a few without an answer. */
function tick(bench, now) {
  if (!bench.running) return;
  bench.frame = requestAnimationFrame((later) => tick(bench, later));
  pull(bench, now, IN_FLIGHT);
}

/** Asks for the scans whose time has come, unless too many requests wait for an answer. */
function pull(bench, now, most) {
  if (bench.asked - bench.answered >= most) return;
  bench.debt = Math.min(MOST_MS, bench.debt + Math.max(0, now - bench.last) * bench.pace);
  bench.last = Math.max(now, bench.last);
  const scans = Math.floor(bench.debt / bench.cast.ms);
  if (!scans && !bench.queue.length) return;
  bench.debt -= scans * bench.cast.ms;
  ask(bench, { type: "run", scans });
}

/** Starts to run, from the present. */
function start(bench) {
  thaw(bench);
  Object.assign(bench, { running: true, at: null, answered: bench.asked, last: performance.now(), debt: 0 });
  showRunning(bench);
  bench.frame = requestAnimationFrame((now) => tick(bench, now));
}

/** Stops running. */
function halt(bench) {
  bench.running = false;
  cancelAnimationFrame(bench.frame);
  if (bench.parts) showRunning(bench);
}

/** Runs one scan. */
function oneScan(bench) {
  halt(bench);
  thaw(bench);
  bench.at = null;
  ask(bench, { type: "run", scans: 1 });
}

/** Starts anew, cold or warm. */
function begin(bench, how) {
  thaw(bench);
  bench.at = null;
  bench.news.tracks = {};
  ask(bench, { type: "start", how });
}

/** Runs a recording from power-on: what was done here, or the text of a file. */
function replay(bench, what) {
  halt(bench);
  thaw(bench);
  bench.at = null;
  ask(bench, { type: "replay", ...what });
}

/** Ends the recording that runs; the hand goes on from here. */
function takeOver(bench) {
  bench.at = null;
  ask(bench, { type: "hand" });
  bench.parts.run.focus();
}

/** Sets an input for the scans to come: it is told at once, without waiting for the next frame. */
function press(bench, address, value) {
  bench.queue.push([address, value]);
  if (bench.running) pull(bench, performance.now(), IN_HASTE);
  else ask(bench, { type: "run", scans: 0 });
}

/** Looks at an earlier scan. */
function lookBack(bench, scan) {
  halt(bench);
  bench.at = scan >= bench.news.scans - 1 ? null : scan;
  if (bench.player) return ask(bench, { type: "film", at: scan });
  ask(bench, { type: "look", at: scan });
}

/** Looks at the scan of a moment. */
function lookAt(bench, ms) {
  const scan = Math.round(ms / bench.cast.ms);
  lookBack(bench, Math.max(bench.news.first, Math.min(bench.news.scans - 1, scan)));
}

/** Freezes the scan on screen, to step through it on the moving stack. */
function freeze(bench) {
  if (bench.player) return start(bench);
  halt(bench);
  ask(bench, { type: "film", at: bench.at ?? bench.news.scans - 1 });
}

/** Shows a frozen scan in the player. */
function showFilmOf(bench, film) {
  clearTimeout(bench.patience);
  bench.stage.hidden = false;
  bench.figure.classList.add("plc-live-frozen");
  if (bench.player) bench.player.load(film);
  else bench.player = mountPlayer(bench.stage, { film, lang: bench.lang, index: 0, compact: true });
  showFrozen(bench, true);
  bench.stage.querySelector(".plc-player")?.focus({ preventScroll: true });
}

/** Lets the frozen scan go. */
function thaw(bench) {
  if (!bench.player) return;
  bench.player.destroy();
  bench.player = null;
  bench.stage.hidden = true;
  bench.figure.classList.remove("plc-live-frozen");
  showFrozen(bench, false);
}
