import type * as whole from './index.js';
export { BrindleError } from './index.js';
export type { DirectionField, FieldStroke, Frame, FrameInput, Numbers, SmoothFieldOptions, StripeOptions, SurfaceInput,
              SurfaceOptions } from './index.js';

export type Animator = whole.Animator;
export type Pattern = Omit<whole.Pattern, 'curves' | 'curvesFile' | 'samplesWith' | 'svg'>;
export interface Surface extends Omit<whole.Surface, 'arrays' | 'array' | 'arrayField' | 'subdivided' | 'measuredField' | 'stripes' | 'texture' | 'crosses' |
                                                     'textureAnimator' | 'camera'> {
  stripes(field: whole.DirectionField, options?: whole.StripeOptions): Pattern;
}

/** Real-time stripes only: the same functions as in 'brindle', with the same results. */
export interface Brindle {
  readonly version: string;
  surface(input: whole.SurfaceInput, options?: whole.SurfaceOptions): Surface;
}

/** `wasm`: the address of stripes.wasm, its bytes, or a compiled module; default: the embedded one. */
export function createBrindle(options?: {
  wasm?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
}): Promise<Brindle>;
export default createBrindle;
