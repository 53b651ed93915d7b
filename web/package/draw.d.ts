export type RGB = [number, number, number];
/** sRGB values of '#1c325a', from 0 to 1. */
export function colorOf(hex: string): RGB;

export interface PatternBuffers {
  /** Twelve numbers per vertex: x, y, z, frequency; direction, cosine of the phase; normal, its sine. */
  vertices: Float32Array;
  /** Four numbers per triangle: its vertices and its kind. */
  triangles: Uint32Array;
}
/** Input of brindle/shaders, in the layout of the library's pattern_buffers.h. */
export function patternBuffers(
  surface: { positions: Float32Array; normals: Float32Array; triangles: Uint32Array },
  pattern: { directions: Float32Array; frequencies: Float32Array; phases: Float32Array },
  kinds?: Uint8Array): PatternBuffers;

export interface StripeView {
  /** For positions relative to `center`; column-major. */
  viewFromWorld: Float32Array | readonly number[];
  clipFromView: Float32Array | readonly number[];
  /** Pixels of the target. */
  width: number;
  height: number;
  /** The world's up in view coordinates, for the light. */
  up?: Float32Array | readonly number[];
  /** Share of the period, 0 to 1. */
  stripeWidth?: number;
  baseColor?: RGB;
  stripeColor?: RGB;
  /** Shows triangles in which stripes begin or end. */
  branches?: boolean;
  branchColor?: RGB;
  singularColor?: RGB;
  /** In pixels. */
  markSize?: number;
}

/** Draws stripes per pixel in a WebGL 2 context, by the library's own shaders. */
export class StripeDrawing {
  constructor(gl: WebGL2RenderingContext);
  /** Of the bounding box; positions are drawn relative to it. */
  readonly center: number[];
  readonly triangleCount: number;
  setSurface(surface: { positions: Float32Array; normals: Float32Array; triangles: Uint32Array }): void;
  setPattern(pattern: { directions: Float32Array; frequencies: Float32Array; phases: Float32Array }): void;
  setPhases(phases: Float32Array): void;
  /** A frame's `vertices`: its pattern and its positions. */
  setVertices(vertices: Float32Array): void;
  setKinds(kinds: Uint8Array): void;
  /**
   * A texture instead of stripes, until a pattern is set: `Texture.waves()`, `brindle.tile(name)` and
   * `Texture.brokenTiles(name)`, without which motifs are cut; or a frame's `waves` and `broken`, with moved positions
   * and normals.
   */
  setTexture(waves: { u: Float32Array; v: Float32Array }, tile: { side: number; distances: Float32Array },
             broken?: { words: Uint32Array; layout: number; split: boolean },
             moved?: { positions?: Float32Array; normals?: Float32Array }): void;
  draw(view: StripeView): void;
  dispose(): void;
}
