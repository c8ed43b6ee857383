// Knows how a verdict and a server-made drawing are shown: headline, marks, the counterexample as a truth-table row.

import { h, svgEl, say } from "./ui.js";
import { verdictGroups, marksText } from "./worksheet.js";

const VERDICT_WORDS = {
  marks: { zh: "得分", en: "Marks" },
  input: { zh: "输入", en: "Inputs" },
  expected: { zh: "应为", en: "Expected" },
  got: { zh: "你的程序给出", en: "Your program gives" },
  caption: { zh: "能看出差别的一组输入", en: "Inputs that show the difference" },
  differs: { zh: "不同", en: "differs" },
  equal: { zh: "一致", en: "agrees" },
  different: { zh: "不同", en: "differs" },
  unknown: { zh: "还不能确定", en: "not certain yet" },
  outputs: { zh: "各输出", en: "Each output" },
  parts: { zh: "得分的各部分", en: "What the marks are made of" },
  chart: { zh: "时序图：应为和你的程序", en: "Timing chart: what is expected, and your program" },
};

/** One shape a status. */
const STATUS_SHAPES = {
  equal: "M2.8 8.6 6.4 12.2 13.2 4.4",
  different: "M2.5 5.8h11M2.5 10.2h11M10.6 2.6 5.4 13.4",
  unknown: "M5.2 5.6C5.2 4 6.4 3 8 3s2.8 1 2.8 2.5C10.8 7.5 8 7.6 8 9.8M8 12.6v.6",
  error: "M8 2.6v7M8 12.4v.8",
  unsettled: "M1.8 9.4c1.6-4.2 4-4.2 6.2-1.4s4.6 2.8 6.2-1.4",
};

/** Gives a status that has a shape; anything newer counts as unknown. */
export function knownStatus(status) {
  return Object.hasOwn(STATUS_SHAPES, status) ? status : "unknown";
}

/** Draws the shape of a status; the words beside it say the same. */
export function statusShape(status) {
  const ink = { fill: "none", stroke: "currentColor", "stroke-width": 1.8, "stroke-linecap": "round", "stroke-linejoin": "round" };
  return svgEl("svg", { className: "plc-status-shape", viewBox: "0 0 16 16", "aria-hidden": "true", focusable: "false" },
    svgEl("path", { d: STATUS_SHAPES[knownStatus(status)], ...ink }));
}

/** Takes out of a drawing whatever could act instead of being looked at. */
function onlyDrawing(svg) {
  for (const node of svg.querySelectorAll("script, foreignObject, iframe")) node.remove();
  for (const node of [svg, ...svg.querySelectorAll("*")]) {
    for (const { name } of [...node.attributes]) if (/^on/i.test(name)) node.removeAttribute(name);
  }
  return svg;
}

/** Lets a drawing grow with the type size, and shrink to what is left of its width when there is less room. */
function adaptable(svg) {
  const width = parseFloat(svg.getAttribute("width")) || svg.viewBox.baseVal.width || 300;
  svg.style.width = `calc(${width}px * var(--plc-size, 1))`;
  svg.style.minWidth = `${Math.round(width * 0.7)}px`;
  return svg;
}

/** Turns SVG markup made by Python into a node, or null where it is none. */
export function drawingOf(markup) {
  if (!markup) return null;
  const svg = new DOMParser().parseFromString(markup, "image/svg+xml").documentElement;
  return svg.localName === "svg" ? adaptable(document.importNode(onlyDrawing(svg), true)) : null;
}

/** Draws the value of one cell; a difference is boxed and carries the sign ≠ as well as its colour. */
function valueCell({ value, differs }, lang) {
  const sign = differs && h("span", { className: "plc-differs-sign", role: "img", "aria-label": say(VERDICT_WORDS.differs, lang) }, "≠");
  return h("td", { className: differs ? "plc-differs" : null },
    h("span", { className: "plc-verdict-value", dataset: { value } }, value), sign);
}

/** Draws the head cell of one signal: its address; whether it is an input or an output stands over the group. */
function signalHead({ address }) {
  return h("th", { scope: "col" }, h("span", { className: "plc-address" }, address));
}

/** Draws one part of the counterexample: inputs, what was expected, or what came. */
function verdictGroup({ kind, cells }, lang) {
  const name = say(VERDICT_WORDS[kind], lang);
  const table = h("table", { className: "plc-verdict-table" }, h("caption", {}, name),
    h("thead", {}, h("tr", {}, cells.map((cell) => signalHead(cell)))),
    h("tbody", {}, h("tr", {}, cells.map((cell) => valueCell(cell, lang)))));
  const scroll = cells.length > 5 ? { tabindex: "0", role: "region", "aria-label": name } : {};
  return h("div", { className: "plc-scroll", ...scroll }, table);
}

/** Draws the counterexample as one row of a truth table, whose parts go below each other when it is narrow. */
function verdictTable(rows, lang) {
  return h("div", { className: "plc-verdict-row" },
    h("p", { className: "plc-verdict-caption" }, say(VERDICT_WORDS.caption, lang)),
    h("div", { className: "plc-verdict-groups" }, verdictGroups(rows).map((group) => verdictGroup(group, lang))));
}

/** Draws how each output came out, where there is more than one. */
function outputList(outputs, lang) {
  const entries = Object.entries(outputs || {});
  if (entries.length < 2) return null;
  return h("ul", { className: "plc-outputs", "aria-label": say(VERDICT_WORDS.outputs, lang) }, entries.map(([address, status]) => {
    const known = ["equal", "different"].includes(status) ? status : "unknown";
    return h("li", { className: `plc-output plc-status-${known}` },
      statusShape(known), h("span", { className: "plc-address" }, address), h("span", {}, say(VERDICT_WORDS[known], lang)));
  }));
}

/** Draws what the marks are made of, where that is more than one thing. */
function partList(parts, lang) {
  if (!parts || parts.length < 2) return null;
  return h("ul", { className: "plc-parts", "aria-label": say(VERDICT_WORDS.parts, lang) }, parts.map(({ name, got, of }) => (
    h("li", {}, h("span", {}, say(name, lang)), h("strong", {}, `${marksText(got)} / ${marksText(of)}`)))));
}

/** Draws the further remarks, each once. */
function remarkList(verdict, lang) {
  const texts = [...(verdict.says || []), ...(verdict.remarks || [])].map((text) => say(text, lang));
  const others = [...new Set(texts)].filter((text) => text && !say(verdict.headline, lang).includes(text));
  return others.length > 0 && h("ul", { className: "plc-says" }, others.map((text) => h("li", {}, text)));
}

/** Draws the counterexample: as a timing chart if Python has drawn one, else as a row of values. */
function exampleOf(verdict, lang) {
  const svg = drawingOf(say(verdict.picture, lang));
  if (!svg) return verdict.rows?.length > 0 && verdictTable(verdict.rows, lang);
  const name = say(VERDICT_WORDS.chart, lang);
  if (!svg.hasAttribute("aria-label")) svg.setAttribute("aria-label", name);
  svg.setAttribute("role", "img");
  return h("div", { className: "plc-scroll plc-example", tabindex: "0", role: "region", "aria-label": name }, svg);
}

/**
 * Draws a verdict: what was found, the marks, what tells the two programs apart.
 * @param {object} verdict  as the contract has it @param {"zh"|"en"} lang
 */
export function drawVerdict(verdict, lang) {
  const status = knownStatus(verdict.status);
  const marks = Number.isFinite(verdict.max) && h("span", { className: "plc-marks" },
    `${say(VERDICT_WORDS.marks, lang)} ${marksText(verdict.marks)} / ${marksText(verdict.max)}`);
  const detail = say(verdict.detail, lang);
  return h("div", { className: `plc-verdict-body plc-status-${status}` },
    h("div", { className: "plc-verdict-head" }, statusShape(status),
      h("p", { className: "plc-verdict-headline" }, say(verdict.headline, lang)), marks),
    detail && h("p", { className: "plc-verdict-detail" }, detail),
    partList(verdict.parts, lang), remarkList(verdict, lang), outputList(verdict.outputs, lang), exampleOf(verdict, lang));
}
