// Knows what a film says of its ladder at a step: signs drawn so far, wires behind them, and parts with power; no DOM.

const BUILT_OF = new WeakMap();
const LIT_OF = new WeakMap();

/** What is true at a step, worked out once from the step before; `next(before, step)` gives the same object if nothing changes. */
function along(cache, film, index, next) {
  const known = cache.get(film) ?? [];
  cache.set(film, known);
  for (let at = known.length; at <= index; at += 1) known.push(next(at ? known[at - 1] : new Set(), film.steps[at]));
  return known[index];
}

/** The signs that the lines of this scan have drawn so far. @returns {Set<string>} */
export function builtAt(film, index) {
  return along(BUILT_OF, film, index, (before, step) => {
    if (step.line < 0) return new Set();
    const added = film.ladder.growth[step.line]?.added ?? [];
    return added.every((part) => before.has(part)) ? before : new Set([...before, ...added]);
  });
}

/** The parts that carry power at a step. @returns {Set<string>} */
export function litAt(film, index) {
  return along(LIT_OF, film, index, (before, step) => {
    if (!step.power) return before;
    const now = new Set(before);
    for (const [part, on] of step.power) {
      if (on) now.add(part);
      else now.delete(part);
    }
    return now;
  });
}

const RUN_OF = new WeakMap();

/** The lines that this scan has executed up to a step. @returns {Set<number>} */
export function executedAt(film, index) {
  return along(RUN_OF, film, index, (before, step) => {
    if (step.line < 0) return new Set();
    return before.has(step.line) ? before : new Set([...before, step.line]);
  });
}

/**
 * The wires that are there: the rail, nets with a drawn sign on their left whose paths are joined, and each vertical wire once
 * its join has been executed, if it takes one. @returns {Set<string>}
 */
export function wiresBuilt(film, built, executed) {
  const there = new Set();
  film.ladder.rungs.forEach(({ nets, joints = {} }, rung) => {
    for (const [net, signs] of [["0", null], ...Object.entries(nets)]) {
      const joined = joints[`${net}-0`] === undefined || executed.has(joints[`${net}-0`]);
      if (signs && !(joined && signs.some((at) => built.has(`s${rung}-${at}`)))) continue;
      there.add(`n${rung}-${net}`);
      for (const opens of ["0", "1"]) {
        const line = joints[`${net}-${opens}`];
        if (line === undefined || executed.has(line)) there.add(`j${rung}-${net}-${opens}`);
      }
    }
  });
  return there;
}

/** The net that a part of the wires belongs to: a vertical wire is alive with its net. */
export function netOf(part) {
  return part.startsWith("j") ? `n${part.slice(1).split("-").slice(0, 2).join("-")}` : part;
}

/** The lines that have made a sign, its own first. @returns {number[]} */
export function linesOfPart(film, part) {
  const [rung, at] = part.slice(1).split("-").map(Number);
  return film.ladder.rungs[rung]?.lines[at] ?? [];
}
