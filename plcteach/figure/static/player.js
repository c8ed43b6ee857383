// Knows how to play a Film: which step is shown, when the next one comes, and how keys and buttons lead there.

import { h, prefersReducedMotion, recall, remember } from "./ui.js";
import { clampIndex, facesAt, lastIndex, lineTextAt, readFilm, stepOfLine } from "./film.js";
import { buildStack, makeStackView, setWanted, settle, showNext, showStack, translateStack } from "./stack-view.js";
import { queueRooms } from "./block-shape.js";
import { mountBlocks } from "./block-view.js";
import { buildList, linkLines, makeListView, markLines } from "./list-view.js";
import { buildLadder, makeLadderView, pointLadder, showLadder } from "./ladder-view.js";
import { freshScore, isQuestion, isRight, makeAskView, translateAsk, verdictWords } from "./ask.js";
import { makeControls, playerWord, pressToggle, showPlaying, translateControls, updateControls } from "./transport.js";
import { makeCaption, showCaption, showNothing, showQuestion } from "./caption.js";
import { listenToClicks, listenToKeys, resizeType, setTypeSize, toggleFullScreen } from "./comfort.js";

const STEP_MS = 1700;
const MOTION_MS = 480;

/**
 * Puts a player into `root`. `compact` leaves out what a host around it has itself: title, language and type size.
 * @param {HTMLElement} root
 * @param {{film: string|object, lang?: "zh"|"en", index?: number, size?: number, ask?: boolean, compact?: boolean,
 *   onIndex?: (index: number) => void, onLang?: (lang: string) => void}} options
 * @returns {{load: Function, go: Function, lang: Function, index: () => number, destroy: () => void}}
 */
export function mountPlayer(root, options) {
  const player = makePlayer(options);
  const unlisten = [listenToKeys(player.figure, player.acts, () => player.pending >= 0), listenToClicks(player.figure)];
  root.classList.add("plc-root");
  root.append(player.figure);
  if (!options.compact) setTypeSize(player.figure, options.size ?? recall("size", 1));
  loadFilm(player, options.film, options.index ?? 0);
  return {
    load: (film) => loadFilm(player, film),
    go: (index) => goTo(player, index),
    lang: (lang) => setLanguage(player, lang),
    index: () => player.index,
    destroy: () => {
      stop(player);
      settle(player.stack);
      player.blocks.destroy();
      for (const undo of unlisten) undo();
      player.figure.remove();
    },
  };
}

/** The host goes to a step; its echo of our own step must not disturb a question. */
function goTo(player, wanted) {
  if (!player.film) return;
  const index = clampIndex(player.film, wanted);
  if (index === player.index) return;
  stop(player);
  arrive(player, index);
}

/** The player's parts and what it knows. */
function makePlayer(options) {
  const player = {
    options, film: null, index: 0, lang: options.lang ?? "zh",
    speed: recall("speed", 1), formulas: recall("formulas", false), names: recall("names", false), ladder: recall("ladder", true),
    asking: options.ask ?? false, pending: -1, verdict: null, score: freshScore(),
    breakpoints: new Set(), timer: null,
  };
  player.stack = makeStackView();
  player.shelf = h("div", {});
  player.blocks = mountBlocks(player.shelf, player.lang);
  player.acts = actsOf(player);
  player.rungs = makeLadderView((line) => wishLine(player, line), (lines) => linkLines(player.list, lines));
  player.list = makeListView(
    (line) => wishLine(player, line), (line, on) => setBreakpoint(player, line, on), (line) => pointLadder(player.rungs, line),
  );
  player.answers = makeAskView(player.acts.guess, player.acts.show);
  player.caption = makeCaption(player.answers.node);
  player.controls = makeControls(player.acts, options.compact);
  const picture = h("div", { className: "plc-picture" }, player.list.node, player.stack.node, player.shelf);
  player.figure = h(
    "div", { className: "plc-player", role: "group", tabindex: 0 },
    player.controls.head, player.controls.node, player.rungs.node, picture, player.caption.node,
  );
  player.figure.classList.toggle("plc-compact", Boolean(options.compact));
  return player;
}

/** What each control does; whoever steps by hand stops the playing. */
function actsOf(player) {
  const step = (index) => {
    stop(player);
    wish(player, index);
  };
  return {
    first: () => step(0),
    prev: () => step(player.index - 1),
    next: () => step(player.index + 1),
    last: () => step(Infinity),
    play: () => (player.timer ? stop(player) : play(player)),
    seek: step,
    guess: (value) => guess(player, value),
    show: () => player.pending >= 0 && reveal(player, null),
    speed: (times) => keep(player, "speed", times),
    formulas: () => toggleWanted(player, "formulas"),
    names: () => toggleWanted(player, "names"),
    ladder: () => toggleLadder(player),
    asking: () => toggleAsking(player),
    language: () => changeLanguage(player),
    bigger: () => resizeType(player.figure, 1),
    smaller: () => resizeType(player.figure, -1),
    full: () => toggleFullScreen(player.figure),
  };
}

/** Sets and remembers a preference. */
function keep(player, name, value) {
  player[name] = value;
  remember(name, value);
}

/** Takes another film; one with as many steps stays where the old one was. */
function loadFilm(player, source, index) {
  const film = readFilm(source);
  const stays = film && player.film && lastIndex(film) === lastIndex(player.film);
  stop(player);
  Object.assign(player, { film, pending: -1, verdict: null, score: freshScore() });
  if (!stays) player.breakpoints.clear();
  const wanted = index ?? (stays ? player.index : 0);
  player.index = film ? clampIndex(film, wanted) : 0;
  player.figure.classList.toggle("plc-without-film", !film);
  player.figure.classList.toggle("plc-several-columns", film?.columns.length > 1);
  player.figure.classList.toggle("plc-with-blocks", Boolean(film?.faces?.length));
  player.rooms = queueRooms(film);
  if (film) buildStack(player.stack, film);
  writeAll(player);
}

/** Writes every word in the player's language and shows its step, without motion. */
function writeAll(player) {
  const { film, lang, figure } = player;
  figure.lang = lang === "zh" ? "zh-CN" : "en";
  figure.setAttribute("aria-label", playerWord("player", lang));
  translateControls(player.controls, player);
  translateAsk(player.answers, lang);
  setWanted(player.stack, player);
  if (film) {
    translateStack(player.stack, lang);
    buildList(player.list, film, lang, player.breakpoints);
  }
  drawLadder(player);
  draw(player, player.index, 0);
}

/** Shows the player's step, coming from another one. */
function draw(player, from, ms) {
  const { film, index, lang, pending } = player;
  updateControls(player.controls, player);
  if (!film) return showNothing(player.caption, lang);
  const asked = pending >= 0;
  const score = player.asking ? player.score : null;
  markLines(player.list, film.steps[index].line, asked ? film.steps[pending].line : -1);
  showStack(player.stack, index, from, ms);
  showLadder(player.rungs, index);
  const neighbours = ms > 0 && Math.abs(index - from) === 1;
  player.blocks.show(facesAt(film, index), lang, { animate: neighbours, ms, rooms: player.rooms });
  showNext(player.stack, asked ? lineTextAt(film, pending) : null);
  if (asked) showQuestion(player.caption, { film, index: pending, lang, score });
  else showCaption(player.caption, { film, index, lang, score, verdict: player.verdict });
}

/** Goes to a step and shows it; from a neighbour the cells move there. */
function arrive(player, index, verdict = null) {
  const from = player.index;
  Object.assign(player, { index, verdict, pending: -1 });
  const still = prefersReducedMotion() || from === index;
  draw(player, from, still ? 0 : MOTION_MS / player.speed);
}

/** The learner wishes to be at a step: it is asked about first, or shown and told to the host. */
function wish(player, wanted) {
  const { film, index, pending } = player;
  if (!film) return;
  const to = clampIndex(film, Math.min(wanted, lastIndex(film)));
  if (pending >= 0 && to === pending) return reveal(player, null);
  if (player.asking && to === index + 1 && isQuestion(film, to)) return pose(player, to);
  if (to === index && pending < 0) return;
  arrive(player, to);
  if (to !== index) player.options.onIndex?.(to);
}

/** The learner chose a line of the list. */
function wishLine(player, line) {
  const step = stepOfLine(player.film, line, player.index);
  stop(player);
  if (step >= 0) wish(player, step);
}

/** Asks about the next step instead of showing it. */
function pose(player, index) {
  Object.assign(player, { pending: index, verdict: null });
  draw(player, player.index, 0);
}

/** Takes a guess. */
function guess(player, value) {
  if (player.pending < 0) return;
  const right = isRight(player.film, player.pending, value);
  player.score.set(player.pending, right);
  reveal(player, { right, text: verdictWords(player.film, player.pending, right, player.lang) });
}

/** Shows the step that was asked about; the focus does not stay on a button that goes. */
function reveal(player, verdict) {
  const { pending, answers, figure } = player;
  if (answers.node.contains(document.activeElement)) figure.focus({ preventScroll: true });
  arrive(player, pending, verdict);
  player.options.onIndex?.(pending);
}

/** Plays from here, or from the beginning when it is at the end. */
function play(player) {
  if (!player.film) return;
  const atEnd = player.index === lastIndex(player.film);
  advance(player, atEnd ? 0 : player.index + 1);
}

/** Takes one step of playing and, unless the end, a breakpoint or a question comes, sets the clock for the next. */
function advance(player, to) {
  wish(player, to);
  stop(player);
  const { film, index, pending, breakpoints } = player;
  const goesOn = pending < 0 && index < lastIndex(film) && !breakpoints.has(film.steps[index].line);
  if (goesOn) player.timer = setTimeout(() => advance(player, player.index + 1), STEP_MS / player.speed);
  showPlaying(player.controls, goesOn, player.lang);
}

/** Stops the clock. */
function stop(player) {
  clearTimeout(player.timer);
  player.timer = null;
  showPlaying(player.controls, false, player.lang);
}

/** Sets a breakpoint or takes it away. */
function setBreakpoint(player, line, on) {
  if (on) player.breakpoints.add(line);
  else player.breakpoints.delete(line);
}

/** Shows or hides formulas or names in the cells. */
function toggleWanted(player, name) {
  keep(player, name, !player[name]);
  pressToggle(player.controls, name, player[name]);
  setWanted(player.stack, player);
  drawLadder(player);
  if (player.film) draw(player, player.index, 0);
}

/** Draws the ladder anew, with or without formulas, if there is one and the reader wants it. */
function drawLadder(player) {
  const { film, lang, formulas } = player;
  player.controls.parts.ladder.hidden = !film?.ladder;
  buildLadder(player.rungs, film, lang, { shown: player.ladder, formulas });
}

/** Shows or hides the ladder. */
function toggleLadder(player) {
  keep(player, "ladder", !player.ladder);
  pressToggle(player.controls, "ladder", player.ladder);
  drawLadder(player);
  if (player.film) showLadder(player.rungs, player.index);
}

/** Turns questions on or off; each time the count begins anew. */
function toggleAsking(player) {
  Object.assign(player, { asking: !player.asking, pending: -1, verdict: null, score: freshScore() });
  pressToggle(player.controls, "asking", player.asking);
  setWanted(player.stack, player);
  if (player.film) draw(player, player.index, 0);
}

/** Writes everything in another language. */
function setLanguage(player, lang) {
  if (lang === player.lang) return;
  player.lang = lang;
  if (player.verdict) player.verdict.text = verdictWords(player.film, player.index, player.verdict.right, lang);
  writeAll(player);
}

/** The reader chose the other language; the focus stays on the button that was pressed. */
function changeLanguage(player) {
  setLanguage(player, player.lang === "zh" ? "en" : "zh");
  player.controls.parts.language.focus({ preventScroll: true });
  player.options.onLang?.(player.lang);
}
