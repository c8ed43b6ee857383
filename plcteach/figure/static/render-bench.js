// Joins the bench to a widget model; the bench itself listens to the model.
import { mountBench } from "./bench.js";

/** @param {{model: object, el: HTMLElement}} where */
export function render({ model, el }) {
  const handle = mountBench(el, model);
  return () => handle.destroy();
}
