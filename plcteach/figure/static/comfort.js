// Knows the reader's comforts around a figure: keys, type size and full screen; not what is shown in it.

import { guardKeys, isPageKey, recall, remember } from "./ui.js";

const TYPE_SIZES = { least: 0.75, most: 3, step: 0.25 };

/** Sets the type size factor of a figure through its one variable. */
export function setTypeSize(figure, size) {
  figure.style.setProperty("--plc-size", String(size));
}

/** Makes the type one step bigger (1) or smaller (-1), and remembers it. */
export function resizeType(figure, direction) {
  const now = Number(figure.style.getPropertyValue("--plc-size")) || recall("size", 1);
  const { least, most, step } = TYPE_SIZES;
  const size = Math.max(least, Math.min(most, now + direction * step));
  setTypeSize(figure, size);
  remember("size", size);
}

/** Enters full screen with the figure, or leaves it. */
export function toggleFullScreen(figure) {
  if (document.fullscreenElement) document.exitFullscreen();
  else figure.requestFullscreen?.();
}

/**
 * Which act a key asks for: steps and play at any time; with a question open, answers too.
 * Keys that a focused control needs itself (Space on a button, arrows on the slider) ask for nothing.
 * @returns {[string, string?]|null} the act's name and what it is given
 */
export function actOfKey({ key, repeat }, tag, asked) {
  if (tag === "SELECT") return null;
  if (tag === "BUTTON" && (key === " " || key === "Enter")) return null;
  if (tag === "INPUT" && !["0", "1", "x", "X", "Enter", " "].includes(key)) return null;
  if (asked) {
    if (["0", "1", "x", "X"].includes(key)) return ["guess", key.toLowerCase()];
    if (key === "Enter") return ["show"];
    if (repeat && key === "ArrowRight") return ["wait"];
  }
  const name = { ArrowRight: "next", ArrowLeft: "prev", Home: "first", End: "last", " ": "play" }[key];
  return name ? [name] : null;
}

/** Listens to keys while the focus is inside, and keeps them from the page. Returns the undo. */
export function listenToKeys(figure, acts, isAsked) {
  const unguard = guardKeys(figure);
  const onKey = (event) => {
    if (event.defaultPrevented || isPageKey(event)) return;
    const act = actOfKey(event, event.target.tagName, isAsked());
    if (!act) return;
    event.preventDefault();
    acts[act[0]]?.(act[1]);
  };
  figure.addEventListener("keydown", onKey);
  return () => {
    unguard();
    figure.removeEventListener("keydown", onKey);
  };
}

/**
 * Gives the focus back to the figure after a click with the mouse, so that Space plays and does not press the same button
 * again; a button pressed with a key keeps it, and so do the step buttons. Returns the undo.
 */
export function listenToClicks(figure) {
  const onClick = ({ detail, target }) => {
    const pressed = detail > 0 && target.closest?.("button");
    if (pressed && !pressed.closest(".plc-steps")) figure.focus({ preventScroll: true });
  };
  figure.addEventListener("click", onClick);
  return () => figure.removeEventListener("click", onClick);
}
