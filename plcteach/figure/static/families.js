// Knows how to play one ladder in several families at once: a list and a stack each, all stepping together.

import { h, prefersReducedMotion, recall, remember, say } from "./ui.js";
import { buildStack, makeStackView, setWanted, settle, showStack, translateStack } from "./stack-view.js";
import { buildList, linkLines, makeListView, markLines } from "./list-view.js";
import { buildLadder, makeLadderView, pointLadder, showLadder } from "./ladder-view.js";
import { makeControls, pressToggle, showPlaying, translateControls, updateControls } from "./transport.js";
import { listenToClicks, listenToKeys, resizeType, setTypeSize, toggleFullScreen } from "./comfort.js";
import { clampIndex, lineTextAt } from "./film.js";

const TOGETHER_MS = 2200;
const GLIDE_MS = 480;
const FAMILY_WORDS = {
  families: { zh: "同一个梯形图在几个系列里", en: "One ladder in several families" },
  waits: { zh: "这一步没有要做的", en: "nothing to do in this step" },
};

/**
 * What Python sends: one ladder, and for each family its film and at which step of it each moment stands.
 * @typedef {{title: import("./ui.js").Text, moments: number[][], words: import("./ui.js").Text[],
 *   families: {title: import("./ui.js").Text, kind: import("./ui.js").Text, film: import("./film.js").Film}[]}} Together
 * @param {HTMLElement} root
 * @param {{data: Together, lang?: "zh"|"en", index?: number, size?: number, onIndex?: Function, onLang?: Function}} options
 */
export function mountFamilies(root, options) {
  const player = makeTogether(options);
  const unlisten = [listenToKeys(player.figure, player.acts, () => false), listenToClicks(player.figure)];
  root.classList.add("plc-root");
  root.append(player.figure);
  setTypeSize(player.figure, options.size ?? recall("size", 1));
  writeTogether(player);
  return {
    go: (index) => index !== player.index && stepTogether(player, index, false),
    lang: (lang) => lang !== player.lang && (Object.assign(player, { lang }), writeTogether(player)),
    index: () => player.index,
    destroy: () => {
      clearTimeout(player.timer);
      for (const one of player.families) settle(one.stack);
      for (const undo of unlisten) undo();
      player.figure.remove();
    },
  };
}

/** The moments as a film of their own, for the slider and its words: each moment is named by the lines that it executes. */
function momentsFilm({ title, moments, families }) {
  const text = (at) => families.map(({ film }, family) => (moves(moments, at, family) ? lineTextAt(film, moments[at][family]) : "–"));
  return {
    title, columns: [], texts: [],
    lines: moments.map((_, at) => ({ text: text(at).join(" · ") })),
    steps: moments.map((_, at) => ({ line: at || -1, scan: 0, cells: [] })),
  };
}

/** Whether a family executes a line at a moment. */
function moves(moments, at, family) {
  return at > 0 && moments[at][family] !== moments[at - 1][family];
}

/** The parts of the player. */
function makeTogether(options) {
  const { data } = options;
  const player = {
    options, data, film: momentsFilm(data), lang: options.lang ?? "zh", timer: null, pending: -1,
    speed: recall("speed", 1), formulas: recall("formulas", false), names: false, asking: false, ladder: recall("ladder", true),
  };
  player.index = clampIndex(player.film, options.index ?? 0);
  player.acts = actsTogether(player);
  player.controls = makeControls(player.acts, false);
  player.rungs = makeLadderView((line) => goToLine(player, 0, line), (lines) => linkLines(player.families[0].list, lines));
  player.families = data.families.map((family, at) => makeFamily(player, family, at));
  const grid = h("div", { className: "plc-families" }, player.families.map((one) => one.node));
  player.figure = h(
    "div", { className: "plc-player plc-together", role: "group", tabindex: 0 },
    player.controls.head, player.controls.node, player.rungs.node, grid,
  );
  return player;
}

/** One family: its name, its list, its stack and a sentence. */
function makeFamily(player, family, at) {
  const list = makeListView(
    (line) => goToLine(player, at, line), () => {}, (line) => at === 0 && pointLadder(player.rungs, line),
  );
  const stack = makeStackView();
  const title = h("div", { className: "plc-family-title" });
  const sentence = h("p", { className: "plc-say plc-family-say", "aria-live": at === 0 ? "polite" : undefined });
  const node = h("section", { className: "plc-family" }, title, list.node, stack.node, sentence);
  return { ...family, list, stack, node, titleNode: title, sentence };
}

/** What each control does. */
function actsTogether(player) {
  const step = (index) => {
    pauseTogether(player);
    stepTogether(player, index, true);
  };
  const keep = (name, value) => {
    player[name] = value;
    remember(name, value);
  };
  return {
    first: () => step(0), prev: () => step(player.index - 1), next: () => step(player.index + 1), last: () => step(Infinity),
    play: () => (player.timer ? pauseTogether(player) : playTogether(player)),
    seek: step,
    speed: (times) => keep("speed", times),
    formulas: () => (keep("formulas", !player.formulas), writeTogether(player)),
    ladder: () => (keep("ladder", !player.ladder), writeTogether(player)),
    names: () => {}, asking: () => {},
    language: () => {
      player.lang = player.lang === "zh" ? "en" : "zh";
      writeTogether(player);
      player.controls.parts.language.focus({ preventScroll: true });
      player.options.onLang?.(player.lang);
    },
    bigger: () => resizeType(player.figure, 1),
    smaller: () => resizeType(player.figure, -1),
    full: () => toggleFullScreen(player.figure),
  };
}

/** Writes every word in the player's language and shows its moment. */
function writeTogether(player) {
  const { figure, lang, formulas } = player;
  figure.lang = lang === "zh" ? "zh-CN" : "en";
  figure.setAttribute("aria-label", say(FAMILY_WORDS.families, lang));
  translateControls(player.controls, player);
  for (const name of ["names", "asking"]) player.controls.parts[name].hidden = true;
  for (const name of ["ladder", "formulas"]) pressToggle(player.controls, name, player[name]);
  buildLadder(player.rungs, player.families[0].film, lang, { shown: player.ladder, formulas });
  for (const one of player.families) {
    one.titleNode.replaceChildren(h("b", {}, say(one.title, lang)), h("span", {}, say(one.kind, lang)));
    buildStack(one.stack, one.film, { aligned: true });
    setWanted(one.stack, { formulas, names: false, asking: false });
    translateStack(one.stack, lang);
    buildList(one.list, one.film, lang, new Set());
  }
  drawTogether(player, player.index, 0);
}

/** Shows the player's moment, coming from another one. */
function drawTogether(player, from, ms) {
  const { data, index, lang } = player;
  updateControls(player.controls, player);
  player.families.forEach((one, at) => {
    const [step, before] = [data.moments[index][at], data.moments[from][at]];
    const active = index === 0 || moves(data.moments, index, at);
    markLines(one.list, one.film.steps[step].line);
    showStack(one.stack, step, before, Math.abs(step - before) === 1 ? ms : 0);
    one.node.classList.toggle("plc-family-waits", !active);
    one.sentence.textContent = active ? say(one.film.steps[step].say, lang) : say(FAMILY_WORDS.waits, lang);
  });
  showLadder(player.rungs, data.moments[index][0]);
}

/** Goes to a moment. */
function stepTogether(player, wanted, tell) {
  const from = player.index;
  player.index = clampIndex(player.film, Math.min(wanted, player.film.steps.length - 1));
  drawTogether(player, from, prefersReducedMotion() || from === player.index ? 0 : GLIDE_MS / player.speed);
  if (tell && from !== player.index) player.options.onIndex?.(player.index);
}

/** Goes to the moment at which a family executes a line. */
function goToLine(player, family, line) {
  const { film } = player.families[family];
  const at = player.data.moments.findIndex((moment) => film.steps[moment[family]].line === line);
  pauseTogether(player);
  if (at >= 0) stepTogether(player, at, true);
}

/** Plays from here, or from the beginning when it is at the end. */
function playTogether(player) {
  const last = player.film.steps.length - 1;
  stepTogether(player, player.index === last ? 0 : player.index + 1, true);
  const goesOn = player.index < last;
  player.timer = goesOn ? setTimeout(() => playTogether(player), TOGETHER_MS / player.speed) : null;
  showPlaying(player.controls, goesOn, player.lang);
}

/** Stops the clock. */
function pauseTogether(player) {
  clearTimeout(player.timer);
  player.timer = null;
  showPlaying(player.controls, false, player.lang);
}
