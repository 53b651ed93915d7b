// The library with its WebAssembly in a file of its own, ./brindle.wasm.
import { brindleOf } from './brindle.js';

export { BrindleError, Surface, Pattern, Texture, Animator } from './brindle.js';

async function bytesOf(wasm) {
  if (wasm instanceof ArrayBuffer || ArrayBuffer.isView(wasm)) return wasm;
  const response = await fetch(wasm);
  if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** `wasm`: where brindle.wasm is, its bytes, or a compiled WebAssembly.Module. */
export async function createBrindle({ wasm = new URL('./brindle.wasm', import.meta.url) } = {}) {
  if (!(wasm instanceof WebAssembly.Module)) return brindleOf({ wasmBinary: await bytesOf(wasm) });
  return brindleOf({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(wasm, imports).then((instance) => done(instance, wasm));
      return {};
    },
  });
}

export default createBrindle;
