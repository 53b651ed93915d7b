// The other end of ./worker: keeps numbered objects and calls their methods.
const plain = (value) => value === null || typeof value !== 'object' || ArrayBuffer.isView(value);

function buffersIn(value, found = new Set()) {
  if (ArrayBuffer.isView(value)) found.add(value.buffer);
  else if (!plain(value)) Object.values(value).forEach((part) => buffersIn(part, found));
  return found;
}

/** Processes the messages of `port` in order; `create` makes the library. */
export function serve(port, create) {
  const objects = new Map();
  let library = null, last = 0, order = Promise.resolve();

  const keep = (result) => {
    if (plain(result) || typeof result.dispose !== 'function') return { value: result };
    objects.set(++last, result);
    return { object: last, kind: result.kind, properties: { ...result } };
  };
  const given = (value) => (!plain(value) && value.brindleObject ? objects.get(value.brindleObject) : value);

  async function answer({ id, target, method, values }) {
    try {
      library ??= await create();
      const self = target === 0 ? library : objects.get(target);
      if (method === 'dispose') objects.delete(target);
      const made = method === 'version' ? { value: library.version } : keep(self[method](...values.map(given)));
      port.postMessage({ id, ...made }, [...buffersIn(made.value)]);
    } catch (error) {
      port.postMessage({ id, error: error.message, isBrindle: error.name === 'BrindleError' });
    }
  }
  port.onmessage = ({ data }) => {
    order = order.then(() => answer(data));
  };
}
