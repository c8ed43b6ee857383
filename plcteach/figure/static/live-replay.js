// Knows how the live bench shows that a recording runs in the place of hands and sensors, and how the reader takes over again.

import { button, h, say } from "./ui.js";
import { syncLatches } from "./live-io.js";
import { timeWords } from "./live-shape.js";

const TAPE_WORDS = {
  replay: { zh: "重放", en: "Replay" },
  load: { zh: "打开时序文件并重放", en: "Open a timeline and replay it" },
  hand: { zh: "手动接管", en: "Take over by hand" },
  mark: { zh: "重放", en: "Replay" },
  runs: { zh: "输入按记录动作，共 {}。", en: "The inputs do what was recorded, {} in all." },
  over: { zh: "记录放完了。", en: "The recording is over." },
  same: { zh: "记录放完了，输出每次扫描都与记录相同。", en: "The recording is over; in every scan the outputs were as recorded." },
  other: { zh: "输出与记录不同，见下。", en: "Outputs are not as recorded, see below." },
};

/** The strip that says that a recording runs. `onHand()` takes over. */
export function makeTape(onHand) {
  const words = h("span", { className: "plc-live-tape-words", role: "status" });
  const badge = h("strong", { className: "plc-live-tape-mark" });
  const node = h("div", { className: "plc-live-tape", hidden: true }, badge, words);
  return { node, badge, words, hand: null, onHand, shown: undefined };
}

/** Writes the strip's own words. */
export function writeTape(view, lang) {
  view.badge.textContent = say(TAPE_WORDS.mark, lang);
  view.hand?.remove();
  view.hand = button({ label: say(TAPE_WORDS.hand, lang), text: say(TAPE_WORDS.hand, lang), className: "plc-live-hand", onclick: view.onHand });
  view.node.append(view.hand);
}

/** The buttons of the bar: replay what was done here, or a file. */
export function tapeButtons({ replay, load }, lang) {
  const file = h("input", { type: "file", accept: ".txt,text/plain", hidden: true, "aria-label": say(TAPE_WORDS.load, lang) });
  file.addEventListener("change", async () => {
    const [one] = file.files;
    file.value = "";
    if (one) load(await one.text());
  });
  const words = say(TAPE_WORDS.replay, lang);
  return [
    button({ icon: "restart", label: words, text: words, className: "plc-live-replay", onclick: replay }),
    button({ icon: "open", label: say(TAPE_WORDS.load, lang), className: "plc-live-load", onclick: () => file.click() }),
    file,
  ];
}

/** What the strip says of a recording. */
export function tapeWords({ end, over, tells, same }, lang) {
  const name = tells && !same ? "other" : !over ? "runs" : tells ? "same" : "over";
  return say(TAPE_WORDS[name], lang).replace("{}", timeWords(end));
}

/** Shows whether a recording runs; where that changes, the switches stand as the kernel holds them. */
export function showTape(view, inputs, { tape, held }, figure, lang) {
  view.node.hidden = !tape;
  view.node.classList.toggle("plc-live-taped-over", Boolean(tape?.over));
  figure.classList.toggle("plc-live-taped", Boolean(tape));
  const words = tape ? tapeWords(tape, lang) : "";
  if (view.words.textContent !== words) view.words.textContent = words;
  if (view.shown === Boolean(tape)) return;
  view.shown = Boolean(tape);
  syncLatches(inputs, held, view.shown);
}

/** Offers the inputs of the run as a file. */
export function saveTimeline(text, name) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain;charset=utf-8" }));
  h("a", { href: address, download: name || "timeline.txt" }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}
