// Knows how to make DOM nodes, icons and buttons, to pick a language and to keep keys at home; no PLC words.

/** @typedef {{zh?: string, en?: string}} Text  every word that a learner reads */
/** @typedef {"zh"|"en"} Lang */

const SVG_NS = "http://www.w3.org/2000/svg";
const SET_AS_PROPERTY = new Set(["value", "checked", "disabled", "hidden", "textContent", "selected"]);

/** Sets one prop of an HTML element: handler, dataset, style, property or attribute. */
function setProp(node, key, value) {
  if (value === undefined || value === null) return;
  if (key.startsWith("on")) node.addEventListener(key.slice(2).toLowerCase(), value);
  else if (key === "className") node.setAttribute("class", value);
  else if (key === "dataset") Object.assign(node.dataset, value);
  else if (key === "style") setStyle(node, value);
  else if (key === "attributes") for (const k in value) setProp(node, k, value[k]);
  else if (SET_AS_PROPERTY.has(key)) node[key] = value;
  else if (typeof value === "boolean" && !key.startsWith("aria-")) node.toggleAttribute(key, value);
  else node.setAttribute(key, String(value));
}

/** Sets styles one by one, so that custom properties (`--plc-…`) work and a strict CSP has nothing to refuse. */
function setStyle(node, style) {
  for (const k in style) {
    if (k.startsWith("--")) node.style.setProperty(k, style[k]);
    else node.style[k] = style[k];
  }
}

/** Appends children, passing over null, undefined and false; strings become text nodes. */
function appendAll(node, children) {
  for (const child of children.flat(Infinity)) {
    if (child !== null && child !== undefined && child !== false) node.append(child);
  }
  return node;
}

/**
 * Makes an HTML element. Props: className, dataset, style (object), on* handlers, properties such as value
 * and disabled, and attributes by their own names (`"aria-label"`, `type`, …).
 */
export function h(tag, props, ...children) {
  const node = document.createElement(tag);
  for (const key in props || {}) setProp(node, key, props[key]);
  return appendAll(node, children);
}

/** Makes an SVG element from plain attributes (and on* handlers). */
export function svgEl(tag, attrs, ...children) {
  const node = document.createElementNS(SVG_NS, tag);
  for (const key in attrs || {}) {
    const value = attrs[key];
    if (key.startsWith("on")) node.addEventListener(key.slice(2).toLowerCase(), value);
    else if (value !== undefined && value !== null) {
      node.setAttribute(key === "className" ? "class" : key, String(value));
    }
  }
  return appendAll(node, children);
}

/**
 * Picks one language of a text, or the other one when it is missing; a plain string stands for itself.
 * @param {Text|string|undefined|null} text @param {Lang} lang @returns {string}
 */
export function say(text, lang) {
  if (text === undefined || text === null) return "";
  if (typeof text === "string") return text;
  return text[lang] ?? text.en ?? text.zh ?? "";
}

/** Paths on a grid of 16; `line` icons are stroked, the others filled. */
const ICONS = {
  first: { d: "M3 3h1.8v10H3zM13.4 3.2v9.6L5.8 8z" },
  prev: { d: "M12 2.6v10.8L3.6 8z" },
  next: { d: "M4 2.6v10.8L12.4 8z" },
  last: { d: "M11.2 3H13v10h-1.8zM2.6 3.2v9.6L10.2 8z" },
  play: { d: "M4.2 2.4v11.2L13.4 8z" },
  pause: { d: "M4 3h3v10H4zM9 3h3v10H9z" },
  plus: { line: true, d: "M8 3.2v9.6M3.2 8h9.6" },
  minus: { line: true, d: "M3.2 8h9.6" },
  gear: {
    line: true,
    d: "M8 6a2 2 0 1 0 0 4 2 2 0 0 0 0-4zM8 3.4a4.6 4.6 0 1 0 0 9.2 4.6 4.6 0 0 0 0-9.2z"
      + "M8 1.4v2M8 12.6v2M1.4 8h2M12.6 8h2M3.3 3.3l1.4 1.4M11.3 11.3l1.4 1.4M12.7 3.3l-1.4 1.4M4.7 11.3l-1.4 1.4",
  },
  eye: {
    line: true,
    d: "M1.2 8S3.6 3.6 8 3.6 14.8 8 14.8 8 12.4 12.4 8 12.4 1.2 8 1.2 8zM8 6a2 2 0 1 0 0 4 2 2 0 0 0 0-4z",
  },
  help: { line: true, d: "M5.4 5.8C5.4 4.2 6.5 3.2 8 3.2s2.6 1 2.6 2.4c0 1.9-2.6 2.1-2.6 4M8 12.4v.6" },
  "full-screen": { line: true, d: "M2.6 6V2.6H6M10 2.6h3.4V6M13.4 10v3.4H10M6 13.4H2.6V10" },
  globe: {
    line: true,
    d: "M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8zM1.8 8h12.4"
      + "M8 1.8c1.8 1.8 2.6 3.9 2.6 6.2S9.8 12.4 8 14.2C6.2 12.4 5.4 10.3 5.4 8S6.2 3.6 8 1.8z",
  },
  save: { line: true, d: "M8 2v7.6M4.8 6.6 8 9.8l3.2-3.2M2.4 11.2v2.4h11.2v-2.4" },
  open: { line: true, d: "M1.8 12.8V3.4h4.4l1.4 1.8h5.4v2M1.8 12.8 4 7.2h10.8l-2.2 5.6z" },
  check: { line: true, d: "M2.8 8.6 6.4 12.2 13.2 4.4" },
  flag: { line: true, d: "M3.6 14.2V2.2M3.6 3h8.6l-2 3 2 3H3.6" },
  lightbulb: { line: true, d: "M6 11.2c0-1.6-2-2.4-2-5a4 4 0 0 1 8 0c0 2.6-2 3.4-2 5zM6.2 13.4h3.6" },
  restart: { line: true, d: "M3.2 8a4.9 4.9 0 1 0 1.6-3.6M4.9 1.6v3.1H8" },
};

/** Draws one icon as inline SVG in the colour of the text; hidden from screen readers (the button is labelled). */
export function icon(name) {
  const { d, line } = ICONS[name];
  const round = { "stroke-width": 1.5, "stroke-linecap": "round", "stroke-linejoin": "round" };
  const ink = line ? { fill: "none", stroke: "currentColor", ...round } : { fill: "currentColor" };
  const frame = { viewBox: "0 0 16 16", width: "1em", height: "1em", "aria-hidden": "true", focusable: "false" };
  return svgEl("svg", { className: "plc-icon", ...frame }, svgEl("path", { d, ...ink }));
}

/**
 * Makes a button. With `icon`, `label` is its name and tooltip; without, `label` is the visible text.
 * `text` adds visible text beside an icon; `pressed` (true or false) makes it a toggle.
 * @param {{icon?: string, label: string, text?: string, onclick?: (event: Event) => void, className?: string,
 *   pressed?: boolean}} options
 */
export function button({ icon: name, label, text, onclick, className, pressed }) {
  const node = h("button", { type: "button", className: `plc-button${className ? ` ${className}` : ""}`, onclick });
  if (pressed !== undefined) node.setAttribute("aria-pressed", String(pressed));
  if (name) node.append(icon(name));
  if (name || text) {
    node.setAttribute("aria-label", label);
    node.title = label;
  }
  if (!name || text) node.append(text || label);
  return node;
}

/** Whether a key belongs to the page (Tab, Escape, chords) and not to the figure that has the focus. */
export function isPageKey(event) {
  return event.key === "Tab" || event.key === "Escape" || event.ctrlKey || event.metaKey || event.altKey;
}

/** Keeps keys pressed inside `root` from the page around it: a notebook must not act on them. Returns the undo. */
export function guardKeys(root) {
  const guard = (event) => {
    if (!isPageKey(event)) event.stopPropagation();
  };
  root.addEventListener("keydown", guard);
  return () => root.removeEventListener("keydown", guard);
}

/** Keeps a preference for this browser; silently nothing where storage is closed (file://, sandboxed frames). */
export function remember(key, value) {
  try {
    localStorage.setItem(`plc-${key}`, JSON.stringify(value));
  } catch {
    // no storage here: the preference lasts as long as the page
  }
}

/** Gives back a remembered preference, or the fallback. */
export function recall(key, fallback) {
  try {
    const kept = localStorage.getItem(`plc-${key}`);
    return kept === null ? fallback : JSON.parse(kept);
  } catch {
    return fallback;
  }
}

/** Lets a part go on hearing a pointer that leaves it while it is down; a pointer that is gone already is no loss. */
export function keepPointer(node, event) {
  try {
    node.setPointerCapture(event.pointerId);
  } catch {
    // the pointer is up again: its end has been heard
  }
}

/** Whether the reader asked for no motion. */
export function prefersReducedMotion() {
  return typeof matchMedia === "function" && matchMedia("(prefers-reduced-motion: reduce)").matches;
}
