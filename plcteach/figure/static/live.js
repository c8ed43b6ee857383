// Knows the live bench: it asks the kernel for the next scans, sends what was pressed, and shows the answer; no request, no run.

import { button, guardKeys, h, icon, recall, remember, say } from "./ui.js";
import { buildLadder, lightLadder, makeLadderView } from "./ladder-view.js";
import { mountBlocks } from "./block-view.js";
import { mountPlayer } from "./player.js";
import { buildLiveChart, drawLiveChart, makeLiveChart } from "./live-chart.js";
import { buildInputs, buildShows, holdInput, inputOfKey, makeInputs, makeShows, showInputs, showShows } from "./live-io.js";
import { buildStatusList, makeStatusList, showStatusList } from "./live-list.js";
import { drawPlant, makePlantView, showPlant } from "./plant-view.js";
import { MOST_MS, PACES, freshNews, takeBatch, timeWords, trimTracks } from "./live-shape.js";

const LIVE_WORDS = {
  bench: { zh: "实时工作台", en: "Live bench" },
  run: { zh: "运行", en: "Run" },
  pause: { zh: "暂停", en: "Pause" },
  scan: { zh: "扫描一次", en: "One scan" },
  freeze: { zh: "逐条执行", en: "Instruction by instruction" },
  thaw: { zh: "放开，继续运行", en: "Let go" },
  restart: { zh: "冷启动", en: "Cold start" },
  warm: { zh: "热启动", en: "Warm start" },
  save: { zh: "保存时序", en: "Save the timeline" },
  pace: { zh: "快慢", en: "Pace" },
  past: { zh: "回看", en: "Look back" },
  time: { zh: "{}，第 {n} 次扫描", en: "{}, scan {n}" },
  levels: { zh: "堆栈列数", en: "Stack columns" },
  ladder: { zh: "梯形图", en: "Ladder" },
  list: { zh: "指令表", en: "List" },
  blocks: { zh: "功能块", en: "Blocks" },
  chart: { zh: "时序图", en: "Chart" },
  plant: { zh: "设备", en: "Plant" },
  late: { zh: "内核还没有回答……", en: "The kernel has not answered yet …" },
};
const FOLDS = ["plant", "ladder", "list", "blocks", "chart"];
const HISTORY_MS = 600000;
const LATE_MS = 3000;

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
  const unlisten = listenToNumbers(bench);
  bench.figure.classList.toggle("plc-compact", compact);
  writeBench(bench);
  ask(bench, { type: "look" });
  return {
    take: (message) => takeAnswer(bench, message),
    cast: (next) => (Object.assign(bench, { cast: next, news: freshNews() }), writeBench(bench), ask(bench, { type: "look", anew: true })),
    lang: (next) => (Object.assign(bench, { lang: next }), writeBench(bench), redraw(bench)),
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
    cast, send, lang, news: freshNews(), running: false, waiting: false, asked: 0, last: 0, debt: 0, at: null, queue: [],
    pace: recall("live-pace", 1), levels: recall("live-levels", 1), folds: recall("live-folds", {}), frame: 0, player: null, patience: null,
  };
  bench.inputs = makeInputs((address, value) => press(bench, address, value), (address) => free(bench, address));
  bench.lamps = makeShows("lamps");
  bench.words = makeShows("words");
  bench.rungs = makeLadderView(() => {}, () => {});
  bench.list = makeStatusList();
  bench.shelf = h("div", {});
  bench.blocks = mountBlocks(bench.shelf, lang);
  bench.chart = makeLiveChart((ms) => lookAt(bench, ms));
  bench.plant = makePlantView((symbol, down) => pressSymbol(bench, symbol, down));
  bench.bar = h("div", { className: "plc-transport" });
  bench.note = h("p", { className: "plc-live-note", role: "status" });
  bench.faults = h("div", { className: "plc-live-faults", role: "alert" });
  bench.stage = h("div", { className: "plc-live-stage", hidden: true });
  bench.panels = {};
  bench.body = h("div", { className: "plc-live-body" });
  bench.figure = h("div", { className: "plc-player plc-live", role: "group", tabindex: -1 },
    bench.bar, bench.note, bench.faults, h("div", { className: "plc-live-io" }, bench.inputs.node, bench.lamps.node, bench.words.node), bench.stage, bench.body);
  return bench;
}

/** Writes every word in the bench's language. */
function writeBench(bench) {
  const { cast, lang, figure } = bench;
  figure.lang = lang === "zh" ? "zh-CN" : "en";
  figure.setAttribute("aria-label", say(LIVE_WORDS.bench, lang));
  writeBar(bench);
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
      h("summary", {}, say(LIVE_WORDS[name], lang)), inside[name]);
    panel.addEventListener("toggle", () => {
      bench.folds[name] = panel.open;
      remember("live-folds", bench.folds);
      if (panel.open) redraw(bench);
    });
    bench.panels[name] = panel;
    return panel;
  });
  bench.body.replaceChildren(...panels);
  if (bench.panels.list) bench.panels.list.querySelector("summary").append(levelChoice(bench));
}

/** How many levels of the stack stand beside the list. */
function levelChoice(bench) {
  const label = say(LIVE_WORDS.levels, bench.lang);
  const options = [0, 1, 2, 3, 4].map((count) => h("option", { value: count, selected: count === bench.levels }, String(count)));
  const choose = (event) => {
    bench.levels = Number(event.target.value);
    remember("live-levels", bench.levels);
    buildStatusList(bench.list, bench.cast, bench.lang, bench.levels);
    redraw(bench);
  };
  return h("label", { className: "plc-live-levels" }, ` ${label} `, h("select", { "aria-label": label, onchange: choose }, options));
}

/** The bar: run, one scan, one instruction, pace, starts, the past, the time. */
function writeBar(bench) {
  const { lang } = bench;
  const act = (name, sign, onclick, extra = {}) => button({ icon: sign, label: say(LIVE_WORDS[name], lang), onclick, className: `plc-live-${name}`, ...extra });
  const group = (...parts) => h("div", { className: "plc-steps", role: "group" }, parts);
  bench.parts = {
    run: act("run", "play", () => (bench.running ? halt(bench) : start(bench))),
    freeze: act("freeze", "next", () => freeze(bench), { text: say(LIVE_WORDS.freeze, lang) }),
    past: h("input", { type: "range", className: "plc-slider", min: 0, max: 0, step: 1, "aria-label": say(LIVE_WORDS.past, lang), oninput: (event) => lookBack(bench, Number(event.target.value)) }),
    time: h("output", { className: "plc-count" }),
  };
  const paces = PACES.map((pace) => h("option", { value: pace, selected: pace === bench.pace }, `${pace}×`));
  const choose = (event) => (Object.assign(bench, { pace: Number(event.target.value) }), remember("live-pace", bench.pace));
  const pace = h("select", { className: "plc-speed", "aria-label": say(LIVE_WORDS.pace, lang), title: say(LIVE_WORDS.pace, lang), onchange: choose }, paces);
  bench.bar.replaceChildren(
    group(bench.parts.run, act("scan", "last", () => oneScan(bench), { text: say(LIVE_WORDS.scan, lang) }), bench.parts.freeze),
    h("div", { className: "plc-seek" }, bench.parts.past, bench.parts.time),
    h("div", { className: "plc-view", role: "group" }, pace,
      act("restart", "restart", () => begin(bench, "cold"), { text: say(LIVE_WORDS.restart, lang) }), act("warm", "restart", () => begin(bench, "warm"), { text: say(LIVE_WORDS.warm, lang) }),
      act("save", "save", () => ask(bench, { type: "timeline" }))),
  );
  showRunning(bench);
}

/** The run button becomes a pause button while it runs. */
function showRunning(bench) {
  const { run } = bench.parts;
  const label = say(LIVE_WORDS[bench.running ? "pause" : "run"], bench.lang);
  run.replaceChildren(icon(bench.running ? "pause" : "play"));
  run.setAttribute("aria-label", label);
  run.title = label;
  bench.figure.classList.toggle("plc-live-runs", bench.running);
}

// the talk with the kernel

/** Asks for something; the note says so when no answer comes. */
function ask(bench, message) {
  bench.asked += 1;
  bench.waiting = true;
  clearTimeout(bench.patience);
  bench.patience = setTimeout(() => (bench.note.textContent = say(LIVE_WORDS.late, bench.lang)), LATE_MS);
  const events = bench.queue.splice(0);
  try {
    bench.send({ ...message, id: bench.asked, ...(events.length ? { events } : {}) });
  } catch {
    // the connection is closed: the note after three seconds says so
  }
}

/** Takes an answer: only the last one asked for is waited for, but nothing that was told is lost. */
function takeAnswer(bench, message) {
  if (message.type === "film") return showFilmOf(bench, message.film);
  if (message.type === "timeline") return saveTimeline(message.text, message.name);
  if (message.type !== "batch") return;
  clearTimeout(bench.patience);
  bench.note.textContent = "";
  bench.news = takeBatch(bench.news, message);
  trimTracks(bench.news.tracks, bench.news.end - HISTORY_MS);
  if (message.id >= bench.asked) bench.waiting = false;
  redraw(bench);
}

/** Runs on: with each frame of the page one request, never a second before the answer to the first. */
function tick(bench, now) {
  if (!bench.running) return;
  bench.frame = requestAnimationFrame((later) => tick(bench, later));
  if (bench.waiting) return;
  bench.debt = Math.min(MOST_MS, bench.debt + (now - bench.last) * bench.pace);
  bench.last = now;
  const scans = Math.floor(bench.debt / bench.cast.ms);
  if (!scans && !bench.queue.length) return;
  bench.debt -= scans * bench.cast.ms;
  ask(bench, { type: "run", scans });
}

/** Starts to run, from the present. */
function start(bench) {
  thaw(bench);
  Object.assign(bench, { running: true, at: null, last: performance.now(), debt: 0 });
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

/** Sets an input for the scans to come; paused, it is told at once. */
function press(bench, address, value) {
  bench.queue.push([address, value]);
  if (!bench.running) ask(bench, { type: "run", scans: 0 });
}

/** Gives an input back to the plant. */
function free(bench, address) {
  bench.queue.push([address, null]);
  if (!bench.running) ask(bench, { type: "run", scans: 0 });
}

/** Presses a button that is drawn in the plant. */
function pressSymbol(bench, symbol, down) {
  bench.queue.push([`@${symbol}`, down ? 1 : 0]);
  if (!bench.running) ask(bench, { type: "run", scans: 0 });
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
  bench.waiting = false;
  clearTimeout(bench.patience);
  bench.stage.hidden = false;
  if (bench.player) bench.player.load(film);
  else bench.player = mountPlayer(bench.stage, { film, lang: bench.lang, index: 0, compact: true });
  bench.parts.freeze.replaceChildren(icon("play"), say(LIVE_WORDS.thaw, bench.lang));
  bench.stage.querySelector(".plc-player")?.focus({ preventScroll: true });
}

/** Lets the frozen scan go. */
function thaw(bench) {
  if (!bench.player) return;
  bench.player.destroy();
  bench.player = null;
  bench.stage.hidden = true;
  bench.parts.freeze.replaceChildren(icon("next"), say(LIVE_WORDS.freeze, bench.lang));
}

/** Offers the inputs of the run as a file. */
function saveTimeline(text, name) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain;charset=utf-8" }));
  h("a", { href: address, download: name || "timeline.txt" }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

// the picture of a moment

/** Shows what is known. */
function redraw(bench) {
  const { news, lang, parts, panels } = bench;
  const open = (name) => panels[name]?.open;
  parts.past.min = news.first;
  parts.past.max = Math.max(news.first, news.scans - 1);
  parts.past.value = bench.at ?? news.scans - 1;
  const words = say(LIVE_WORDS.time, lang).replace("{}", timeWords(news.now)).replace("{n}", news.scan + 1);
  parts.time.textContent = news.scans ? words : "";
  parts.past.setAttribute("aria-valuetext", words);
  showInputs(bench.inputs, news.bits, news.forced);
  showShows(bench.lamps, news.bits);
  showShows(bench.words, news.words);
  if (open("ladder")) lightLadder(bench.rungs, new Set(news.lit));
  if (open("list")) showStatusList(bench.list, news.lines);
  if (open("blocks")) bench.blocks.show(Object.values(news.faces), lang);
  if (open("chart")) drawLiveChart(bench.chart, news);
  if (open("plant") && news.plant) showPlant(bench.plant, news.plant, lang);
  showFaults(bench);
}

/** Says what has gone wrong, each thing once. */
function showFaults({ news, lang, faults }) {
  const said = news.found.map((one) => say(one, lang));
  if (faults.textContent === said.join("")) return;
  faults.replaceChildren(...said.map((words) => h("p", {}, icon("flag"), " ", words)));
}

/** The number keys hold the first nine inputs. */
function listenToNumbers(bench) {
  const hold = (on) => (event) => {
    if (event.repeat || event.target.closest("input, select, textarea") || bench.stage.contains(event.target)) return;
    const address = inputOfKey(bench.inputs, event.key);
    if (address) holdInput(bench.inputs, address, on);
  };
  const [down, up] = [hold(true), hold(false)];
  bench.figure.addEventListener("keydown", down);
  bench.figure.addEventListener("keyup", up);
  return () => {
    bench.figure.removeEventListener("keydown", down);
    bench.figure.removeEventListener("keyup", up);
  };
}
