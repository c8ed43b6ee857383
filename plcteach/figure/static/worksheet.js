// Knows what a workbench and an exercise desk show of a model: switches, lamps, places in a film, drafts, verdict tables; no DOM.

/** Reads a JSON trait, or gives the fallback where there is none (yet). */
export function readTrait(model, name, fallback) {
  const kept = model.get(name);
  if (kept === null || kept === undefined || kept === "") return fallback;
  if (typeof kept !== "string") return kept;
  try {
    return JSON.parse(kept);
  } catch {
    return fallback;
  }
}

/** Gives a signal's value as the text "0", "1" or "x", whichever way it was sent. */
export function valueText(value) {
  if (value === true || value === 1 || value === "1") return "1";
  if (value === false || value === 0 || value === "0") return "0";
  return "x";
}

/**
 * Gives the switches in the report's order; what was switched here counts before the kernel has answered.
 * @param {{address: string, value: unknown}[]} switches @param {Record<string, unknown>} inputs
 */
export function switchRows(switches, inputs) {
  return switches.map(({ address, value }) => (
    { address, value: valueText(inputs[address] ?? value) === "1" ? "1" : "0" }
  ));
}

/** Whether two lists name the same addresses in the same order, so that what is drawn can stay. */
export function sameAddresses(before, after) {
  return before.length === after.length && before.every(({ address }, i) => address === after[i].address);
}

/** Gives the row of the text on which a step of a film stands; 0 before the first instruction. */
export function rowOfStep(film, index) {
  const step = film?.steps?.[index];
  return step && step.line >= 0 ? film.lines[step.line]?.row || 0 : 0;
}

/** Gives the step that has just carried out a row, in the scan now shown if it can be; -1 where there is none. */
export function stepOfRow(film, row, index) {
  const steps = film?.steps || [];
  const scan = steps[index]?.scan;
  const fits = (step) => step.line >= 0 && film.lines[step.line]?.row === row;
  const here = steps.findIndex((step) => fits(step) && step.scan === scan);
  return here >= 0 ? here : steps.findIndex(fits);
}

/** Gives a film's last scan number. */
function lastScan(film) {
  return film?.steps?.length ? film.steps[film.steps.length - 1].scan : -1;
}

/**
 * Gives the step to stand on when a film follows another: the start of a scan that is new, else the same row
 * in the same scan, else the same number as far as it goes.
 */
export function placeInNext(film, index, next) {
  const last = next?.steps?.length - 1;
  if (!(last >= 0)) return 0;
  if (film && lastScan(next) > lastScan(film)) {
    return Math.max(0, next.steps.findIndex((step) => step.scan === lastScan(next)));
  }
  const row = rowOfStep(film, index);
  const scan = film?.steps?.[index]?.scan;
  const again = row ? next.steps.findIndex((step, i) => step.scan === scan && rowOfStep(next, i) === row) : -1;
  return again >= 0 ? again : Math.min(Math.max(0, index || 0), last);
}

/** Gives the name under which this browser keeps what was typed into a file. */
export function draftKey(filename) {
  return `draft:${filename || "program"}`;
}

/** Gives the draft to offer, or null: one that holds something and differs from the text at hand. */
export function draftToOffer(draft, source) {
  if (!draft || typeof draft.text !== "string" || !draft.text.trim()) return null;
  return draft.text === source ? null : draft;
}

const BENCH_SIZES = [1, 1.15, 1.3, 1.5, 1.75, 2, 2.25, 2.5];

/** Gives the next type size up (1) or down (-1); the ends stay. */
export function nextSize(size, direction) {
  const now = Number(size) || 1;
  const onward = direction > 0 ? BENCH_SIZES.find((s) => s > now + 1e-6) : BENCH_SIZES.findLast((s) => s < now - 1e-6);
  return onward ?? Math.min(Math.max(now, BENCH_SIZES[0]), BENCH_SIZES[BENCH_SIZES.length - 1]);
}

/** Writes marks as people do: 3, 2.5, 1.33. */
export function marksText(marks) {
  return String(Math.round(Number(marks || 0) * 100) / 100);
}

/**
 * Lays the rows of a verdict out as one row of a truth table: inputs, then what was expected and what came.
 * @param {{address: string, kind: "input"|"expected"|"got", value: unknown, differs?: boolean}[]} rows
 * @returns {{kind: string, cells: {address: string, value: string, differs: boolean}[]}[]}
 */
export function verdictGroups(rows) {
  return ["input", "expected", "got"]
    .map((kind) => ({
      kind,
      cells: rows.filter((row) => row.kind === kind).map(({ address, value, differs }) => (
        { address, value: valueText(value), differs: kind === "got" && Boolean(differs) }
      )),
    }))
    .filter(({ cells }) => cells.length > 0);
}

/** Splits a task into paragraphs. */
export function paragraphs(text) {
  return text.split(/\n\s*\n/).map((part) => part.trim()).filter(Boolean);
}
