// The library with its WebAssembly inside: nothing to load, whatever bundles it.
import { brindleOf } from './brindle.js';
import { compressed } from './inlined.js';

export { BrindleError, Surface, Pattern, Texture, Animator } from './brindle.js';

async function inflated() {
  const bytes = Uint8Array.from(atob(compressed), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

export async function createBrindle() {
  return brindleOf({ wasmBinary: await inflated() });
}

export default createBrindle;
