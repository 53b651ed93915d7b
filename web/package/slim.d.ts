import type { Brindle } from './index.js';
export * from './index.js';
/** `wasm`: where brindle.wasm is, its bytes, or a compiled module; left out: beside this file. */
export function createBrindle(options?: {
  wasm?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
}): Promise<Brindle>;
export default createBrindle;
