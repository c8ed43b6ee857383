// Knows the workbench: a program being typed, switches, lamps and scans, with the player beside it.

import { h, say } from "./ui.js";
import { mountEditor } from "./editor.js";
import { liveSwitch } from "./live-switch.js";
import { readTrait, switchRows, sameAddresses, valueText } from "./worksheet.js";
import { PANEL_WORDS, openSession, followTraits, viewChoices, wordButton, renameButton } from "./panel.js";
import { statusLine, keepDrafts, filmPanel, toolRoot, flushOnLeave } from "./panel.js";

const BENCH_WORDS = {
  bench: { zh: "PLC 工作台", en: "PLC workbench" },
  save: { zh: "保存", en: "Save" },
  load: { zh: "打开", en: "Load" },
  switches: { zh: "输入", en: "Inputs" },
  lamps: { zh: "输出", en: "Outputs" },
  scan: { zh: "再扫描一次", en: "One more scan" },
  restart: { zh: "冷启动", en: "Cold start" },
  number: { zh: "扫描", en: "Scan" },
  tooBig: { zh: "这个文件太大了，请选一个 1 MB 以内的文件。", en: "That file is too big here; please choose one under 1 MB." },
};

const LARGEST_FILE = 1 << 20;

/** Offers a text to the reader as a file of that name. */
function saveAs(filename, text) {
  const address = URL.createObjectURL(new Blob([text], { type: "text/plain;charset=utf-8" }));
  h("a", { href: address, download: filename || "program.txt" }).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** Makes Save and Load; the bytes of a loaded file go to Python, which knows the old encodings. */
function fileButtons({ model, session, text, complain }) {
  const picker = h("input", { type: "file", hidden: true, tabindex: "-1", "aria-hidden": "true" });
  picker.addEventListener("change", async () => {
    const [file] = picker.files;
    picker.value = "";
    if (!file) return;
    complain(file.size > LARGEST_FILE);
    if (file.size <= LARGEST_FILE) session.send({ type: "open", name: file.name }, [await file.arrayBuffer()]);
  });
  const save = wordButton("save", () => saveAs(model.get("filename"), text()));
  const load = wordButton("open", () => picker.click());
  const show = (lang) => {
    renameButton(save, say(BENCH_WORDS.save, lang));
    renameButton(load, say(BENCH_WORDS.load, lang));
  };
  return { nodes: [save, load, picker], show };
}

/** Draws one switch: address, a track with a knob, and its value as text. */
function makeSwitch({ address, value }, flip) {
  const number = h("span", { className: "plc-switch-value" });
  const node = h("button", { type: "button", role: "switch", className: "plc-switch", "aria-label": address },
    h("span", { className: "plc-address" }, address),
    h("span", { className: "plc-switch-track", "aria-hidden": "true" }, h("span", { className: "plc-switch-knob" })), number);
  const show = (next) => {
    node.setAttribute("aria-checked", String(next === "1"));
    number.textContent = next;
  };
  node.addEventListener("click", () => flip(address, node.getAttribute("aria-checked") === "true" ? 0 : 1));
  show(value);
  return { node, show };
}

/** Draws one lamp: address and its value as text in a shape of its own (lit, dark, not known). */
function makeLamp({ address, value }) {
  const bulb = h("span", { className: "plc-lamp-bulb" });
  const node = h("li", { className: "plc-lamp" }, h("span", { className: "plc-address" }, address), bulb);
  const show = (next) => {
    bulb.textContent = next;
    bulb.dataset.value = next;
  };
  show(value);
  return { node, show };
}

/** Keeps a row of switches or lamps in step with a report; what stays keeps its node, and with it the focus. */
function rowOf(make, tag, className) {
  const title = h("span", { className: "plc-io-title" });
  const list = h(tag, { className: "plc-io-list" });
  const node = h("div", { className: `plc-io ${className}`, role: tag === "ul" ? null : "group", hidden: true }, title, list);
  let rows = [];
  let items = [];
  const show = (next) => {
    if (!sameAddresses(rows, next)) {
      items = next.map(make);
      list.replaceChildren(...items.map((item) => item.node));
    }
    next.forEach(({ value }, i) => items[i].show(value));
    rows = next;
    node.hidden = next.length === 0;
  };
  const name = (text) => {
    title.textContent = text;
    (tag === "ul" ? list : node).setAttribute("aria-label", text);
  };
  return { node, show, name };
}

/** Makes the row of scan buttons with the number of the scan. */
function scanRow(session) {
  const ask = (type) => (session.tell({}), session.send({ type }));
  const scan = wordButton("next", () => ask("scan"));
  const restart = wordButton("restart", () => ask("restart"));
  const number = h("span", { className: "plc-scan-number", role: "status" });
  const told = { lang: "zh", scan: 0 };
  const show = (news) => {
    Object.assign(told, news);
    renameButton(scan, say(BENCH_WORDS.scan, told.lang));
    renameButton(restart, say(BENCH_WORDS.restart, told.lang));
    number.textContent = told.scan ? `${say(BENCH_WORDS.number, told.lang)} ${told.scan}` : "";
  };
  return { node: h("div", { className: "plc-scan" }, scan, restart, number), show };
}

/** Makes the switches, lamps and scans of a workbench. */
function controls(model, session) {
  const inputs = () => readTrait(model, "inputs", {});
  const flip = (address, value) => {
    session.tell({ inputs: JSON.stringify({ ...inputs(), [address]: value }) });
    show(shown);
  };
  const switches = rowOf((row) => makeSwitch(row, flip), "div", "plc-switches");
  const lamps = rowOf(makeLamp, "ul", "plc-lamps");
  const scan = scanRow(session);
  let shown = {};
  const show = (report) => {
    shown = report;
    switches.show(switchRows(report.switches || [], inputs()));
    lamps.show((report.lamps || []).map(({ address, value }) => ({ address, value: valueText(value) })));
    scan.show({ scan: report.scan });
  };
  const lang = (l) => {
    switches.name(say(BENCH_WORDS.switches, l));
    lamps.name(say(BENCH_WORDS.lamps, l));
    scan.show({ lang: l });
  };
  return { node: h("div", { className: "plc-controls" }, switches.node, lamps.node, scan.node), show, lang };
}

/** Makes the head bar: family, file, and the choices. */
function headBar(files, choices) {
  const family = h("strong", { className: "plc-family" });
  const list = h("span", { className: "plc-list-name" });
  const file = h("span", { className: "plc-file" });
  const node = h("div", { className: "plc-bar" }, h("div", { className: "plc-bar-names" }, family, list, file),
    h("div", { className: "plc-bar-tools" }, files.nodes, choices.nodes));
  const show = (lang, report, filename) => {
    family.textContent = say(report?.dialect?.title || report?.dialect?.name, lang);
    list.textContent = say(report?.list, lang);
    file.textContent = filename || "";
    files.show(lang);
    choices.show(lang);
  };
  return { node, show };
}

/** Makes the parts of a workbench and the place where each says what it has to say to the others. */
function benchParts(model, tool) {
  const parts = { lang: () => (model.get("language") === "en" ? "en" : "zh") };
  const big = h("p", { className: "plc-late", role: "alert" });
  parts.status = statusLine();
  parts.session = openSession(model, {
    onReport: (report) => parts.report(report),
    onWaiting: (late) => parts.status.show(parts.lang(), { late }),
    beforeTelling: () => parts.editor?.flush(),
  });
  parts.film = filmPanel({
    lang: parts.lang(), index: model.get("index"),
    onIndex: (index) => index !== model.get("index") && parts.session.put({ index }),
    onRow: (row) => parts.editor?.highlight(row),
  });
  parts.controls = controls(model, parts.session);
  const complain = (tooBig) => (big.textContent = tooBig ? say(BENCH_WORDS.tooBig, parts.lang()) : "");
  parts.files = fileButtons({ model, session: parts.session, text: () => parts.editor.text(), complain });
  parts.bar = headBar(parts.files, viewChoices(model, parts.session));
  parts.drafts = keepDrafts({
    filename: () => model.get("filename"), source: model.get("source") || "",
    restore: (text) => (parts.editor.setText(text), parts.typed(text)),
  });
  parts.desk = h("div", { className: "plc-work-text" });
  parts.live = liveSwitch(model, [parts.controls.node, parts.film.node]);
  tool.node.append(parts.bar.node, parts.drafts.node, big, h("div", { className: "plc-work" }, parts.desk,
    h("div", { className: "plc-work-run" }, parts.live.node, parts.controls.node, parts.film.node)));
  return parts;
}

/** Lets the parts of a workbench work together. */
function connectBench(parts, model) {
  let last = readTrait(model, "report", null);
  parts.typed = (text) => {
    parts.drafts.keep(text);
    parts.session.tell({ source: text });
  };
  parts.take = (text) => {
    if (text === parts.editor.text()) return;
    parts.editor.setText(text);
    parts.session.answered();
  };
  parts.report = (report) => {
    last = report;
    const film = model.get("film");
    const good = report.ok !== false && Boolean(film);
    if (good) parts.film.show(film);
    parts.film.mark(good ? null : PANEL_WORDS.lastGood);
    parts.editor.diagnostics(report.diagnostics || []);
    parts.controls.show(report);
    parts.status.show(parts.lang(), { report });
    parts.bar.show(parts.lang(), report, model.get("filename"));
  };
  parts.relabel = () => {
    const lang = parts.lang();
    for (const part of [parts.editor, parts.film, parts.controls, parts.live]) part.lang(lang);
    for (const part of [parts.drafts, parts.status]) part.show(lang);
    parts.bar.show(lang, last, model.get("filename"));
  };
}

/** Follows what Python, or another view of the same bench, does to the model. */
function followBench(parts, model, resize) {
  return followTraits(model, {
    source: () => parts.take(model.get("source") || ""),
    language: () => (resize(), parts.relabel()),
    size: resize,
    filename: parts.relabel,
    index: () => parts.film.go(model.get("index")),
  });
}

/**
 * Mounts a workbench on an anywidget model (its traits and messages: see the contract in figure/static).
 * @param {HTMLElement} root @param {object} model
 */
export function mountBench(root, model) {
  const tool = toolRoot(root, "plc-bench");
  const parts = benchParts(model, tool);
  const resize = () => tool.show(parts.lang(), model.get("size"), say(BENCH_WORDS.bench, parts.lang()));
  connectBench(parts, model);
  parts.editor = mountEditor(parts.desk, {
    text: model.get("source") || "", lang: parts.lang(),
    onChange: parts.typed, onCursor: (row) => parts.film.goRow(row),
  });
  parts.desk.append(parts.status.node);
  const unfollow = followBench(parts, model, resize);
  resize();
  parts.relabel();
  parts.session.settle();
  const unflush = flushOnLeave(parts.editor);
  return { destroy: () => (unflush(), parts.editor.destroy(), parts.film.destroy(), parts.live.destroy(), parts.session.close(), unfollow(), tool.remove()) };
}
