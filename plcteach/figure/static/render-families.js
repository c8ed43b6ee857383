// Joins the player of several families to a widget model: what it plays and the language come from Python, the index goes back.
import { mountFamilies } from "./families.js";

/** @param {{model: object, el: HTMLElement}} where */
export function render({ model, el }) {
  const tell = (name) => (value) => {
    model.set(name, value);
    model.save_changes();
  };
  const handle = mountFamilies(el, {
    data: JSON.parse(model.get("together")), lang: model.get("language"), index: model.get("index"), size: model.get("size"),
    onIndex: tell("index"), onLang: tell("language"),
  });
  const onIndex = () => handle.go(model.get("index"));
  const onLang = () => handle.lang(model.get("language"));
  model.on("change:index", onIndex);
  model.on("change:language", onLang);
  return () => {
    model.off("change:index", onIndex);
    model.off("change:language", onLang);
    handle.destroy();
  };
}
