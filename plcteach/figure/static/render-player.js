// Joins the player to a widget model: film and language come from Python, the index goes back.
import { mountPlayer } from "./player.js";

/** @param {{model: object, el: HTMLElement}} where */
export function render({ model, el }) {
  const handle = mountPlayer(el, {
    film: JSON.parse(model.get("film")),
    lang: model.get("language"),
    index: model.get("index"),
    size: model.get("size"),
    onIndex: (index) => {
      model.set("index", index);
      model.save_changes();
    },
    onLang: (lang) => {
      model.set("language", lang);
      model.save_changes();
    },
  });
  const onFilm = () => handle.load(JSON.parse(model.get("film")));
  const onIndex = () => model.get("index") !== handle.index() && handle.go(model.get("index"));
  const onLang = () => handle.lang(model.get("language"));
  model.on("change:film", onFilm);
  model.on("change:index", onIndex);
  model.on("change:language", onLang);
  return () => {
    model.off("change:film", onFilm);
    model.off("change:index", onIndex);
    model.off("change:language", onLang);
    handle.destroy();
  };
}
