// Knows how an anywidget model behaves, without a kernel: traits, change events, messages.

/** Makes a model; `answer(model, changes)` plays Python after every save, `hear(model, message, buffers)` at every message. */
export function fakeModel(traits, { answer = () => {}, hear = () => {} } = {}) {
  const values = { ...traits };
  const listeners = new Map();
  let unsaved = {};
  const model = {
    sent: [],
    saved: [],
    get: (name) => values[name],
    set: (name, value) => {
      if (values[name] === value) return;
      values[name] = value;
      unsaved[name] = value;
      (listeners.get(`change:${name}`) || []).slice().forEach((listener) => listener());
    },
    save_changes: () => {
      const changes = unsaved;
      unsaved = {};
      model.saved.push(changes);
      answer(model, changes);
    },
    on: (event, listener) => listeners.set(event, [...(listeners.get(event) || []), listener]),
    off: (event, listener) => listeners.set(event, (listeners.get(event) || []).filter((other) => other !== listener)),
    send: (message, _callbacks, buffers) => {
      model.sent.push(message);
      hear(model, message, buffers);
    },
    fromPython: (changes) => {
      const changed = Object.keys(changes).filter((name) => values[name] !== changes[name]);
      Object.assign(values, changes);
      changed.forEach((name) => (listeners.get(`change:${name}`) || []).slice().forEach((listener) => listener()));
    },
    listening: () => [...listeners.values()].reduce((sum, list) => sum + list.length, 0),
  };
  return model;
}
