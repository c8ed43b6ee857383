// Joins the live bench to a widget model: the kernel answers each request with one message.
import { mountLive } from "./live.js";

/** @param {{model: object, el: HTMLElement}} where */
export function render({ model, el }) {
  const handle = mountLive(el, {
    cast: JSON.parse(model.get("cast")), lang: model.get("language"), size: model.get("size"),
    send: (message) => model.send(message),
  });
  const onMessage = (message) => handle.take(message);
  const onCast = () => handle.cast(JSON.parse(model.get("cast")));
  const onLang = () => handle.lang(model.get("language"));
  model.on("msg:custom", onMessage);
  model.on("change:cast", onCast);
  model.on("change:language", onLang);
  return () => {
    model.off("msg:custom", onMessage);
    model.off("change:cast", onCast);
    model.off("change:language", onLang);
    handle.destroy();
  };
}
