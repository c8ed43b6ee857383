// Knows how to draw a list as a status view does: each line with its operand's value and the uppermost levels of the stack.

import { h, say } from "./ui.js";
import { splitLine } from "./film.js";

const STATUS_WORDS = {
  list: { zh: "程序与状态", en: "Program and status" },
  operand: { zh: "操作数", en: "operand" },
  level: { zh: "第{}层", en: "level {}" },
};

/** An empty status list. */
export function makeStatusList() {
  const table = h("table", { className: "plc-status-list" });
  const node = h("div", { className: "plc-status-scroller", tabindex: 0, role: "region" }, table);
  return { node, table, rows: [], levels: 1 };
}

/** Draws the lines once, with so many levels of the stack beside each. */
export function buildStatusList(view, cast, lang, levels) {
  Object.assign(view, { rows: [], levels });
  view.node.setAttribute("aria-label", say(STATUS_WORDS.list, lang));
  const heads = ["", "", say(STATUS_WORDS.operand, lang)];
  for (let level = 1; level <= levels; level += 1) heads.push(say(STATUS_WORDS.level, lang).replace("{}", level));
  const head = h("thead", {}, h("tr", {}, heads.map((words) => (words ? h("th", { scope: "col" }, words) : h("td", {})))));
  view.table.replaceChildren(head, ...cast.networks.map((network, at) => networkBody(view, cast, network, cast.networks[at + 1]?.first)));
}

/** One network: its title and its lines. */
function networkBody(view, cast, network, end = cast.lines.length) {
  const body = h("tbody", {});
  if (network.title) body.append(h("tr", {}, h("th", { colspan: 3 + view.levels, scope: "rowgroup", className: "plc-network" }, network.title)));
  for (let line = network.first; line < end; line += 1) body.append(statusRow(view, cast.lines[line], line));
  return body;
}

/** One line with empty values. */
function statusRow(view, { text, comment, number, row }, line) {
  const { head, rest } = splitLine(text);
  const values = Array.from({ length: 1 + view.levels }, () => h("td", { className: "plc-status-value" }));
  view.rows[line] = { values, shown: [] };
  return h("tr", { dataset: { line } }, h("td", { className: "plc-number" }, String(number ?? row)),
    h("td", { className: "plc-status-words" }, h("span", { className: "plc-code" }, `${head.padEnd(4)} ${rest}`), comment && h("span", { className: "plc-comment" }, ` ${comment}`)),
    values);
}

/** Shows the values of a moment; a line that was not executed has none. */
export function showStatusList(view, lines) {
  view.rows.forEach(({ values, shown }, line) => {
    const now = lines[line] ?? [];
    values.forEach((cell, at) => {
      const value = now[at] ?? "";
      if (shown[at] === value) return;
      shown[at] = value;
      cell.textContent = value;
      cell.dataset.value = value;
    });
  });
}
