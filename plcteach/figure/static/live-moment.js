// Knows how the live bench shows one moment: the time, and what each of its open panels makes of the news.

import { h, icon, say } from "./ui.js";
import { lightLadder } from "./ladder-view.js";
import { drawLiveChart } from "./live-chart.js";
import { showInputs, showShows } from "./live-io.js";
import { showStatusList } from "./live-list.js";
import { showPlant } from "./plant-view.js";
import { liveWord } from "./live-bar.js";
import { showTape } from "./live-replay.js";
import { timeWords } from "./live-shape.js";

/** Shows what is known. */
export function showMoment(bench) {
  const { news, lang, parts, panels } = bench;
  const open = (name) => panels[name]?.open;
  parts.past.min = news.first;
  parts.past.max = Math.max(news.first, news.scans - 1);
  parts.past.value = bench.at ?? news.scans - 1;
  const words = liveWord("time", lang).replace("{}", timeWords(news.now)).replace("{n}", news.scan + 1);
  parts.time.textContent = news.scans ? words : "";
  parts.past.setAttribute("aria-valuetext", words);
  if (news.scans) showTape(bench.tape, bench.inputs, news, bench.figure, lang);
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
