export type RGB = [number, number, number];
/** Red, green and blue of '#1c325a', from 0 to 1 as they are shown. */
export function colorOf(hex: string): RGB;

export interface PatternBuffers {
  /** Twelve numbers a vertex: x, y, z, frequency; direction, cosine of the phase; normal, its sine. */
  vertices: Float32Array;
  /** Four numbers a triangle: its vertices, and its kind. */
  triangles: Uint32Array;
}
/** What the shaders of brindle/shaders read, as the library's pattern_buffers.h has it. */
export function patternBuffers(
  surface: { positions: Float32Array; normals: Float32Array; triangles: Uint32Array },
  pattern: { directions: Float32Array; frequencies: Float32Array; phases: Float32Array },
  kinds?: Uint8Array): PatternBuffers;

export interface StripeView {
  /** Of positions less `center`; in columns, as WebGL takes it. */
  viewFromWorld: Float32Array | readonly number[];
  clipFromView: Float32Array | readonly number[];
  /** Pixels of what is drawn into. */
  width: number;
  height: number;
  /** Of the world, seen from the camera: the light comes from there. */
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

/** Draws stripes in a WebGL 2 context, at every pixel by the library's own shaders. */
export class StripeDrawing {
  constructor(gl: WebGL2RenderingContext);
  /** Of the surface's box; positions are drawn relative to it. */
  readonly center: number[];
  readonly triangleCount: number;
  setSurface(surface: { positions: Float32Array; normals: Float32Array; triangles: Uint32Array }): void;
  setPattern(pattern: { directions: Float32Array; frequencies: Float32Array; phases: Float32Array }): void;
  setPhases(phases: Float32Array): void;
  /** A frame's `vertices`: its pattern, and where vertices are now. */
  setVertices(vertices: Float32Array): void;
  setKinds(kinds: Uint8Array): void;
  /**
   * A texture instead of stripes, until a pattern is set: `Texture.waves()`, `brindle.tile(name)` and
   * `Texture.brokenTiles(name)`, without which figures are cut; or a frame's `waves` and `broken`, with the positions and
   * normals that moved.
   */
  setTexture(waves: { u: Float32Array; v: Float32Array }, tile: { side: number; distances: Float32Array },
             broken?: { words: Uint32Array; layout: number; split: boolean },
             moved?: { positions?: Float32Array; normals?: Float32Array }): void;
  draw(view: StripeView): void;
  dispose(): void;
}
