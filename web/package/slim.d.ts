import type { Brindle } from './index.js';
export * from './index.js';
/** `wasm`: the address of brindle.wasm, its bytes, or a compiled module; default: beside this file. */
export function createBrindle(options?: {
  wasm?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
}): Promise<Brindle>;
export default createBrindle;
