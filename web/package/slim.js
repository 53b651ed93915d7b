// The library with its WebAssembly in a separate file, ./brindle.wasm.
import { brindleOf } from './brindle.js';
import { moduleOf } from './loading.js';

export { BrindleError, Surface, Pattern, Texture, Animator, TextureAnimator } from './brindle.js';

/** `wasm`: the address of brindle.wasm, its bytes, or a compiled WebAssembly.Module. */
export async function createBrindle({ wasm = new URL('./brindle.wasm', import.meta.url) } = {}) {
  return brindleOf(await moduleOf(wasm));
}

export default createBrindle;
