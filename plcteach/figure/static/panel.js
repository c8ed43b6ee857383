// Knows the parts that workbench and exercise desk share: the talk with the kernel, the head bar, drafts and the film beside the text.

import { h, say, icon, button, guardKeys, remember, recall } from "./ui.js";
import { readTrait, rowOfStep, stepOfRow, placeInNext, draftKey, draftToOffer, nextSize } from "./worksheet.js";
import { countProblems } from "./problems.js";
import { mountPlayer } from "./player.js";

export const PANEL_WORDS = {
  chinese: { zh: "中文", en: "中文" },
  english: { zh: "EN (English)", en: "EN (English)" },
  language: { zh: "语言", en: "Language" },
  size: { zh: "字号", en: "Type size" },
  smaller: { zh: "缩小字号", en: "Smaller type" },
  larger: { zh: "放大字号", en: "Larger type" },
  waiting: {
    zh: "内核还没有回答；你输入的内容已保留。",
    en: "The kernel has not answered yet; what you typed is kept.",
  },
  draft: {
    zh: "这个浏览器里还保存着这个文件的另一份草稿",
    en: "This browser still keeps another draft of this file",
  },
  restore: { zh: "恢复草稿", en: "Restore the draft" },
  discard: { zh: "不需要", en: "Not needed" },
  lastGood: { zh: "上一个无错误程序的画面", en: "From the last program without errors" },
  clean: { zh: "没有发现问题", en: "Nothing to remark" },
  error: { zh: "处错误", en: "to correct" },
  warning: { zh: "处提醒", en: "to look at" },
  info: { zh: "条说明", en: "to know" },
};

const PATIENCE = 3000;

/** Sends what was set; a kernel that is gone must not stop anyone from typing. */
function trySending(action) {
  try {
    action();
  } catch {
    // the connection is closed: the note after three seconds says so
  }
}

/** Waits for answers: says so when one is late, and when it has come. */
function makePatience(onWaiting) {
  let timer = 0;
  const stop = () => clearTimeout(timer);
  const wait = () => {
    stop();
    timer = setTimeout(() => onWaiting(true), PATIENCE);
  };
  return { stop, wait, answered: () => (stop(), onWaiting(false)) };
}

/**
 * Talks with the kernel: numbers every change, drops answers to older ones, and says when none comes.
 * @param {object} model  an anywidget model
 * @param {{onReport: (report: object) => void, onWaiting: (late: boolean) => void,
 *   beforeTelling?: () => void}} options  beforeTelling hands over what is typed but not yet sent
 */
export function openSession(model, { onReport, onWaiting, beforeTelling }) {
  const patience = makePatience(onWaiting);
  const serial = () => Number(model.get("serial")) || 0;
  const put = (changes) => {
    for (const name in changes) model.set(name, changes[name]);
    trySending(() => model.save_changes());
  };
  const tell = (changes) => {
    beforeTelling?.();
    patience.wait();
    put({ ...changes, serial: serial() + 1 });
  };
  const send = (message, buffers) => {
    beforeTelling?.();
    patience.wait();
    trySending(() => model.send(message, undefined, buffers));
  };
  const settle = () => {
    const report = readTrait(model, "report", null);
    if (!report || Number(report.source) !== serial()) return;
    patience.answered();
    onReport(report);
  };
  const unfollow = followTraits(model, { report: settle, film: settle });
  return { put, tell, send, settle, answered: patience.answered, close: () => (patience.stop(), unfollow()) };
}

/** Listens to traits of a model; gives back the way to stop. */
export function followTraits(model, handlers) {
  const entries = Object.entries(handlers).map(([name, handler]) => [`change:${name}`, handler]);
  for (const [event, handler] of entries) model.on(event, handler);
  return () => entries.forEach(([event, handler]) => model.off(event, handler));
}

/** Makes the choice of language: two buttons, the one in use pressed. */
function languageButtons(onLang) {
  const make = (lang, text, label) => {
    const node = button({ label: say(label, lang), text, onclick: () => onLang(lang), className: "plc-choice", pressed: false });
    node.setAttribute("lang", lang);
    return node;
  };
  const nodes = { zh: make("zh", "中", PANEL_WORDS.chinese), en: make("en", "EN", PANEL_WORDS.english) };
  const group = h("div", { className: "plc-choices", role: "group" }, nodes.zh, nodes.en);
  const show = (lang) => {
    group.setAttribute("aria-label", say(PANEL_WORDS.language, lang));
    for (const key in nodes) nodes[key].setAttribute("aria-pressed", String(key === lang));
  };
  return { group, show };
}

/** Gives a button a new name in another language. */
export function renameButton(node, text) {
  if (node.title) node.title = text;
  if (node.hasAttribute("aria-label")) node.setAttribute("aria-label", text);
  const words = node.querySelector(".plc-button-text");
  if (words) words.textContent = text;
}

/** Makes a button of an icon and words whose words can change with the language. */
export function wordButton(name, onclick, className) {
  return h("button", { type: "button", className: `plc-button ${className || ""}`.trim(), onclick },
    name && icon(name), h("span", { className: "plc-button-text" }));
}

/**
 * Makes the choices at the end of every head bar: type size and language, kept in the model.
 * @param {object} model @param {{put: (changes: object) => void}} session
 */
export function viewChoices(model, session) {
  const resize = (direction) => session.put({ size: nextSize(model.get("size"), direction) });
  const smaller = button({ icon: "minus", label: say(PANEL_WORDS.smaller, "en"), onclick: () => resize(-1) });
  const larger = button({ icon: "plus", label: say(PANEL_WORDS.larger, "en"), onclick: () => resize(1) });
  const sizes = h("div", { className: "plc-choices plc-sizes", role: "group" },
    smaller, h("span", { className: "plc-size-sign", "aria-hidden": "true" }, "A"), larger);
  const languages = languageButtons((lang) => session.put({ language: lang }));
  const show = (lang) => {
    renameButton(smaller, say(PANEL_WORDS.smaller, lang));
    renameButton(larger, say(PANEL_WORDS.larger, lang));
    sizes.setAttribute("aria-label", say(PANEL_WORDS.size, lang));
    languages.show(lang);
  };
  return { nodes: [sizes, languages.group], show };
}

/** Makes the quiet line under the editor: how many diagnostics, and whether the kernel is late. */
export function statusLine() {
  const summary = h("span", { className: "plc-summary" });
  const late = h("span", { className: "plc-late" });
  const node = h("p", { className: "plc-status", role: "status" }, summary, late);
  const told = { report: null, late: false };
  const show = (lang, news = {}) => {
    Object.assign(told, news);
    summary.textContent = told.report ? summaryText(told.report.diagnostics || [], lang) : "";
    late.textContent = told.late ? say(PANEL_WORDS.waiting, lang) : "";
  };
  return { node, show };
}

/** Writes how many diagnostics there are. */
function summaryText(diagnostics, lang) {
  const count = countProblems(diagnostics);
  const parts = Object.keys(count).filter((severity) => count[severity])
    .map((severity) => `${count[severity]} ${say(PANEL_WORDS[severity], lang)}`);
  return parts.length ? parts.join(lang === "zh" ? "，" : ", ") : say(PANEL_WORDS.clean, lang);
}

/** Writes when a draft was kept. */
function timeOf(draft, lang) {
  if (!draft?.at) return "";
  const style = { dateStyle: "medium", timeStyle: "short" };
  return ` (${new Date(draft.at).toLocaleString(lang === "zh" ? "zh-CN" : "en-GB", style)})`;
}

/**
 * Keeps what is typed in this browser too, and offers it when the page comes back with another text.
 * @param {{filename: () => string, source: string, restore: (text: string) => void}} options
 */
export function keepDrafts({ filename, source, restore }) {
  const offered = draftToOffer(recall(draftKey(filename()), null), source);
  const words = h("span", {});
  const done = () => (node.hidden = true);
  const yes = wordButton("restart", () => (restore(offered.text), done()), "plc-primary");
  const no = wordButton(null, () => (remember(draftKey(filename()), null), done()));
  const node = h("div", { className: "plc-draft", role: "region", hidden: !offered }, words, yes, no);
  const show = (lang) => {
    node.setAttribute("aria-label", say(PANEL_WORDS.draft, lang));
    words.textContent = say(PANEL_WORDS.draft, lang) + timeOf(offered, lang);
    renameButton(yes, say(PANEL_WORDS.restore, lang));
    renameButton(no, say(PANEL_WORDS.discard, lang));
  };
  return { node, show, keep: (text) => remember(draftKey(filename()), { text, at: Date.now() }) };
}

/**
 * Shows a film beside the text, keeps the last good one when there is none, and links its steps to rows.
 * @param {{lang: string, index: number, onIndex: (index: number) => void, onRow: (row: number) => void}} options
 */
export function filmPanel(options) {
  const stage = h("div", { className: "plc-film-stage" });
  const banner = h("p", { className: "plc-film-old", role: "status" });
  const node = h("div", { className: "plc-film", hidden: true }, banner, stage);
  const now = { film: null, text: "", index: options.index || 0, lang: options.lang, stale: null, player: null };
  const moved = (index) => {
    now.index = index;
    options.onIndex(index);
    tellRow(now, options);
  };
  const go = (index) => {
    if (!now.player || index === now.index) return;
    now.player.go(index);
    moved(now.player.index());
  };
  const mark = (stale) => {
    now.stale = stale;
    node.classList.toggle("plc-is-old", Boolean(stale));
    banner.textContent = say(stale, now.lang);
    if (now.film) tellRow(now, options);
  };
  const show = (text) => showFilm(now, text, { node, stage, moved, options });
  const lang = (next) => (Object.assign(now, { lang: next }), now.player?.lang(next), mark(now.stale));
  const goRow = (row) => (now.stale || rowOfStep(now.film, now.index) === row ? 0 : goStep(stepOfRow(now.film, row, now.index)));
  const goStep = (step) => (step >= 0 ? go(step) : 0);
  return { node, mark, show, go, goRow, lang, destroy: () => now.player?.destroy() };
}

/** Tells which row of the text the player stands on; an old film stands on none. */
function tellRow(now, options) {
  options.onRow(now.stale ? 0 : rowOfStep(now.film, now.index));
}

/** Puts a new film on the stage, standing where the last one stood. */
function showFilm(now, text, { node, stage, moved, options }) {
  if (!text || text === now.text) return;
  const film = JSON.parse(text);
  const index = now.film ? placeInNext(now.film, now.index, film) : Math.min(now.index, film.steps.length - 1);
  Object.assign(now, { text, film, index });
  node.hidden = false;
  if (now.player) {
    now.player.load(film);
    now.player.go(index);
  } else {
    now.player = mountPlayer(stage, { film, lang: now.lang, index, onIndex: moved, compact: true });
  }
  moved(index);
}

/** Sets up the outer element of a tool: its class, its name, its keys, its type size and language. */
export function toolRoot(root, className) {
  const node = h("div", { className: `plc-tool ${className}`, role: "group" });
  const unguard = guardKeys(node);
  root.append(node);
  const show = (lang, size, label) => {
    node.setAttribute("lang", lang === "zh" ? "zh-CN" : "en");
    node.setAttribute("aria-label", label);
    node.style.setProperty("--plc-size", String(size || 1));
  };
  return { node, show, remove: () => (unguard(), node.remove()) };
}

/** Hands over what is typed before the page goes away; gives back the way to stop. */
export function flushOnLeave(editor) {
  const leave = () => editor.flush();
  globalThis.addEventListener("pagehide", leave);
  return () => globalThis.removeEventListener("pagehide", leave);
}
