import type { Animator, Brindle, Pattern, Surface, Texture, TextureAnimator } from './index.js';
export { BrindleError } from './index.js';

type Held = Surface | Pattern | Texture | Animator | TextureAnimator;
type HeldFrom<T> = T extends Surface ? RemoteSurface : T extends Pattern ? RemotePattern
  : T extends Texture ? RemoteTexture : T extends Animator ? RemoteAnimator
  : T extends TextureAnimator ? RemoteTextureAnimator : T;
type Given<T> = T extends Pattern ? RemotePattern : T extends Texture ? RemoteTexture : T;
/** The same properties, and methods that return promises. */
type Remote<T> = {
  readonly [K in keyof T]: T[K] extends (...values: infer V) => infer R
    ? (...values: { [I in keyof V]: Given<V[I]> }) => Promise<HeldFrom<R>> : T[K];
};
export type RemoteSurface = Remote<Surface>;
export type RemotePattern = Remote<Pattern>;
export type RemoteTexture = Remote<Texture>;
export type RemoteAnimator = Remote<Animator>;
export type RemoteTextureAnimator = Remote<TextureAnimator>;

/** `worker`: one that runs ./worker-host.js, or a port of one; default: a new one. */
export function createBrindle(options?: { worker?: Worker | MessagePort }):
  Promise<Remote<Brindle> & { terminate(): void }>;
export default createBrindle;
