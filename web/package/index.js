// The library with embedded WebAssembly: no file to load, with any bundler.
import { brindleOf } from './brindle.js';
import { compressed } from './inlined.js';
import { inflated } from './loading.js';

export { BrindleError, Surface, Pattern, Texture, Animator, TextureAnimator } from './brindle.js';

export async function createBrindle() {
  return brindleOf({ wasmBinary: await inflated(compressed) });
}

export default createBrindle;
