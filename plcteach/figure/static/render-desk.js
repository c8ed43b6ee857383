// Joins the desk to a widget model; the desk itself listens to the model.
import { mountDesk } from "./desk.js";

/** @param {{model: object, el: HTMLElement}} where */
export function render({ model, el }) {
  const handle = mountDesk(el, model);
  return () => handle.destroy();
}
