// Real-time stripes only, with embedded WebAssembly: a third of the library's size.
import createModule from './stripes_module.js';
import { BrindleError } from './error.js';
import { inflated, moduleOf } from './loading.js';
import { Brindle } from './realtime.js';
import { compressed } from './stripes_inlined.js';

export { BrindleError };
export { Animator, Pattern, Surface } from './realtime.js';

/** `wasm`: the address of stripes.wasm, its bytes, or a compiled WebAssembly.Module; default: the embedded one. */
export async function createBrindle({ wasm } = {}) {
  const how = wasm === undefined ? { wasmBinary: await inflated(compressed) } : await moduleOf(wasm);
  return new Brindle(await createModule({ ...how, BrindleError }));
}

export default createBrindle;
