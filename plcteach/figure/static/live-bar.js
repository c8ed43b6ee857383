// Knows the bar of the live bench and its words: run, one scan, one instruction, pace, starts, the past, the time.

import { button, h, icon, remember, say } from "./ui.js";
import { tapeButtons } from "./live-replay.js";
import { PACES } from "./live-shape.js";

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
/** A word of the live bench in one language. */
export function liveWord(name, lang) {
  return say(LIVE_WORDS[name], lang);
}

/** How many levels of the stack stand beside the list. */
export function levelChoice(bench, onLevels) {
  const label = say(LIVE_WORDS.levels, bench.lang);
  const options = [0, 1, 2, 3, 4].map((count) => h("option", { value: count, selected: count === bench.levels }, String(count)));
  const choose = (event) => {
    bench.levels = Number(event.target.value);
    remember("live-levels", bench.levels);
    onLevels();
  };
  return h("label", { className: "plc-live-levels" }, ` ${label} `, h("select", { "aria-label": label, onchange: choose }, options));
}

/**
 * The bar: run, one scan, one instruction, pace, starts, the past, the time.
 * @param {Object<string, Function>} acts run scan freeze past restart warm save replay load
 */
export function writeBar(bench, acts) {
  const { lang } = bench;
  const act = (name, sign, onclick, extra = {}) => button({ icon: sign, label: say(LIVE_WORDS[name], lang), onclick, className: `plc-live-${name}`, ...extra });
  const group = (...parts) => h("div", { className: "plc-steps", role: "group" }, parts);
  bench.parts = {
    run: act("run", "play", acts.run),
    freeze: act("freeze", "next", acts.freeze, { text: say(LIVE_WORDS.freeze, lang) }),
    past: h("input", { type: "range", className: "plc-slider", min: 0, max: 0, step: 1, "aria-label": say(LIVE_WORDS.past, lang), oninput: (event) => acts.past(Number(event.target.value)) }),
    time: h("output", { className: "plc-count" }),
  };
  const paces = PACES.map((pace) => h("option", { value: pace, selected: pace === bench.pace }, `${pace}×`));
  const choose = (event) => (Object.assign(bench, { pace: Number(event.target.value) }), remember("live-pace", bench.pace));
  const pace = h("select", { className: "plc-speed", "aria-label": say(LIVE_WORDS.pace, lang), title: say(LIVE_WORDS.pace, lang), onchange: choose }, paces);
  bench.bar.replaceChildren(
    group(bench.parts.run, act("scan", "last", acts.scan, { text: say(LIVE_WORDS.scan, lang) }), bench.parts.freeze),
    h("div", { className: "plc-seek" }, bench.parts.past, bench.parts.time),
    h("div", { className: "plc-view", role: "group" }, pace,
      act("restart", "restart", acts.restart, { text: say(LIVE_WORDS.restart, lang) }), act("warm", "restart", acts.warm, { text: say(LIVE_WORDS.warm, lang) }),
      ...tapeButtons(acts, lang), act("save", "save", acts.save)),
  );
  showRunning(bench);
}

/** The run button becomes a pause button while it runs. */
export function showRunning(bench) {
  const { run } = bench.parts;
  const label = say(LIVE_WORDS[bench.running ? "pause" : "run"], bench.lang);
  run.replaceChildren(icon(bench.running ? "pause" : "play"));
  run.setAttribute("aria-label", label);
  run.title = label;
  bench.figure.classList.toggle("plc-live-runs", bench.running);
}

/** Names the button that freezes a scan, or lets it go again. */
export function showFrozen({ parts, lang }, frozen) {
  parts.freeze.replaceChildren(icon(frozen ? "play" : "next"), liveWord(frozen ? "thaw" : "freeze", lang));
}
