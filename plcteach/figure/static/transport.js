// Knows the player's controls: heading tools, step buttons, slider, speed and toggles; what they do is handed in.

import { button, h, icon, say } from "./ui.js";
import { describeStep, lastIndex, scanCount } from "./film.js";

const PLAYER_WORDS = {
  player: { zh: "逻辑堆栈演示", en: "Logic stack player" },
  steps: { zh: "步进", en: "Steps" },
  first: { zh: "第一步（Home）", en: "First step (Home)" },
  prev: { zh: "上一步（←）", en: "Previous step (←)" },
  play: { zh: "播放（空格）", en: "Play (Space)" },
  pause: { zh: "暂停（空格）", en: "Pause (Space)" },
  next: { zh: "下一步（→）", en: "Next step (→)" },
  last: { zh: "最后一步（End）", en: "Last step (End)" },
  slider: { zh: "当前步", en: "Step" },
  speed: { zh: "播放速度", en: "Speed" },
  formulas: { zh: "公式", en: "Formulas" },
  formulasHint: { zh: "在每一格里显示逻辑表达式", en: "Show the Boolean formula in each cell" },
  names: { zh: "名称", en: "Names" },
  namesHint: { zh: "在每一格里显示值的名称（iv0、S0 …）", en: "Show the value's name in each cell (iv0, S0 …)" },
  ladder: { zh: "梯形图", en: "Ladder" },
  ladderHint: { zh: "在指令表上方显示梯形图", en: "Show the ladder above the list" },
  asking: { zh: "先猜后看", en: "Ask first" },
  askingHint: { zh: "每一步先猜结果，再看画面", en: "Guess each result before it is shown" },
  language: { zh: "EN: switch to English", en: "中：切换到中文" },
  bigger: { zh: "放大文字", en: "Bigger type" },
  smaller: { zh: "缩小文字", en: "Smaller type" },
  full: { zh: "全屏", en: "Full screen" },
  view: { zh: "显示", en: "View" },
  scan: { zh: "第 {} 个扫描周期", en: "scan {}" },
  warn: { zh: "注意", en: "Take note" },
  none: { zh: "还没有可以演示的步骤。", en: "There are no steps to show yet." },
};
const SPEEDS = [0.5, 1, 2, 4];

/** A word of the player in one language. */
export function playerWord(name, lang) {
  return say(PLAYER_WORDS[name], lang);
}

/**
 * The controls, empty until `translateControls`.
 * @param {Object<string, Function>} acts first prev play next last seek speed ladder formulas names asking language
 *   bigger smaller full
 */
export function makeControls(acts, compact) {
  return {
    head: h("div", { className: "plc-top" }),
    node: h("div", { className: "plc-transport" }),
    acts, compact: Boolean(compact), parts: {},
  };
}

/** Writes all controls in one language, in the state given. */
export function translateControls(view, state) {
  const { lang } = state;
  const act = (name, props) => button({
    label: playerWord(name, lang), className: `plc-${name}`, onclick: () => view.acts[name](), ...props,
  });
  const step = (name) => act(name, { icon: name });
  const toggle = (name) => {
    const [text, label] = [playerWord(name, lang), playerWord(`${name}Hint`, lang)];
    const node = act(name, { text, label, pressed: state[name] });
    node.removeAttribute("aria-label");
    return node;
  };
  view.parts = {
    title: h("div", { className: "plc-title" }),
    first: step("first"), prev: step("prev"), play: step("play"), next: step("next"), last: step("last"),
    slider: sliderPart(view, lang), count: h("output", { className: "plc-count" }), speed: speedPart(view, state),
    ladder: toggle("ladder"), formulas: toggle("formulas"), names: toggle("names"), asking: toggle("asking"),
    language: act("language", { icon: "globe", text: lang === "zh" ? "EN" : "中" }),
    full: document.fullscreenEnabled && act("full", { icon: "full-screen" }),
  };
  fillHead(view, act);
  fillTransport(view, lang);
}

/** The heading: the film's title, and tools for language, type size and full screen; a compact player has none. */
function fillHead(view, act) {
  const { title, language, full } = view.parts;
  view.head.hidden = view.compact;
  if (view.compact) return;
  const sizes = [act("smaller", { icon: "minus" }), act("bigger", { icon: "plus" })];
  view.head.replaceChildren(title, h("div", { className: "plc-tools" }, language, sizes, full));
}

/** The bar above the picture, which stays in place however long the words below it are; a compact player has its full-screen button here. */
function fillTransport(view, lang) {
  const { first, prev, play, next, last, slider, count, speed, ladder, formulas, names, asking, full } = view.parts;
  const group = (name, className, ...parts) => (
    h("div", { className, role: "group", "aria-label": playerWord(name, lang) }, parts)
  );
  view.node.replaceChildren(
    group("steps", "plc-steps", first, prev, play, next, last),
    h("div", { className: "plc-seek" }, slider, count),
    group("view", "plc-view", speed, ladder, formulas, names, asking, view.compact && full),
  );
}

/** The native slider over all steps. */
function sliderPart(view, lang) {
  return h("input", {
    type: "range", className: "plc-slider", min: 0, step: 1, "aria-label": playerWord("slider", lang),
    oninput: (event) => view.acts.seek(Number(event.target.value)),
  });
}

/** The choice of a speed. */
function speedPart(view, { lang, speed }) {
  const options = SPEEDS.map((times) => h("option", { value: times, selected: times === speed }, `${times}×`));
  return h("select", {
    className: "plc-speed", "aria-label": playerWord("speed", lang), title: playerWord("speed", lang),
    onchange: (event) => view.acts.speed(Number(event.target.value)),
  }, options);
}

/** Brings the controls up to the step on screen. */
export function updateControls(view, { film, index, lang, timer, pending }) {
  const { title, first, prev, next, last, slider, count } = view.parts;
  const end = film ? lastIndex(film) : 0;
  title.textContent = film ? say(film.title, lang) : "";
  slider.max = end;
  slider.value = index;
  slider.setAttribute("aria-valuetext", film ? describeStep(film, index, lang) : "");
  const scans = film && scanCount(film) > 1;
  count.textContent = `${index} / ${end}`
    + (scans ? ` · ${playerWord("scan", lang).replace("{}", film.steps[index].scan + 1)}` : "");
  dim(first, index === 0 && pending < 0);
  dim(prev, index === 0 && pending < 0);
  dim(next, index === end);
  dim(last, index === end);
  showPlaying(view, Boolean(timer), lang);
}

/** Marks a button as without effect; it keeps the focus, which a disabled one would lose. */
function dim(node, idle) {
  if (node.getAttribute("aria-disabled") !== String(idle)) node.setAttribute("aria-disabled", String(idle));
}

/** The play button becomes a pause button while it plays. */
export function showPlaying(view, playing, lang) {
  const { play } = view.parts;
  if (!play || play.dataset.playing === String(playing)) return;
  play.dataset.playing = playing;
  const label = playerWord(playing ? "pause" : "play", lang);
  play.setAttribute("aria-label", label);
  play.title = label;
  play.replaceChildren(icon(playing ? "pause" : "play"));
}

/** Shows whether a toggle is on. */
export function pressToggle(view, name, on) {
  view.parts[name].setAttribute("aria-pressed", String(on));
}
