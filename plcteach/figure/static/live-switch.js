// Knows how a workbench changes between stepping through one scan and running live; each takes the place of the other.

import { button, h, say } from "./ui.js";
import { mountLive } from "./live.js";
import { followTraits } from "./panel.js";

const SWITCH_WORDS = {
  how: { zh: "怎样运行", en: "How it runs" },
  step: { zh: "逐条看", en: "Step by step" },
  live: { zh: "实时运行", en: "Live" },
};

/**
 * Two buttons, and the live bench while it is wanted; `others` are the parts that it takes the place of.
 * @param {object} model  an anywidget model with the trait `live` @param {HTMLElement[]} others
 */
export function liveSwitch(model, others) {
  const choice = h("div", { className: "plc-choices plc-live-choice", role: "group" });
  const stage = h("div", { className: "plc-live-place", hidden: true });
  const node = h("div", {}, choice, stage);
  const now = { handle: null, lang: model.get("language") };
  const onMessage = (message) => now.handle?.take(message);
  const ask = (on) => () => model.send({ type: "live", on });
  const write = () => {
    choice.setAttribute("aria-label", say(SWITCH_WORDS.how, now.lang));
    const make = (name, on) => button({
      label: say(SWITCH_WORDS[name], now.lang), onclick: ask(on), className: `plc-live-choose-${name}`, pressed: Boolean(now.handle) === on,
    });
    choice.replaceChildren(make("step", false), make("live", true));
  };
  const follow = () => {
    const text = model.get("live");
    if (text && now.handle) now.handle.cast(JSON.parse(text));
    else if (text) {
      now.handle = mountLive(stage, { cast: JSON.parse(text), lang: now.lang, send: (message) => model.send(message), compact: true });
    } else {
      now.handle?.destroy();
      now.handle = null;
    }
    stage.hidden = !now.handle;
    for (const other of others) other.classList.toggle("plc-live-aside", Boolean(now.handle));
    write();
  };
  const unfollow = followTraits(model, { live: follow });
  model.on("msg:custom", onMessage);
  follow();
  return {
    node,
    lang: (lang) => (Object.assign(now, { lang }), now.handle?.lang(lang), write()),
    destroy: () => {
      model.off("msg:custom", onMessage);
      unfollow();
      now.handle?.destroy();
    },
  };
}
