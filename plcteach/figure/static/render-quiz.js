// Joins the concept test to a widget model; the test itself listens to the model.
import { mountQuiz } from "./quiz.js";

/** @param {{model: object, el: HTMLElement}} where */
export function render({ model, el }) {
  const handle = mountQuiz(el, model);
  return () => handle.destroy();
}
