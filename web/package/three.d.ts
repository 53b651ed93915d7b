import type { BufferGeometry, Color, ColorRepresentation, Material } from 'three';

export interface SurfaceArrays {
  /** Three numbers per vertex. */
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
}
export interface PatternArrays {
  directions: Float32Array;
  frequencies: Float32Array;
  phases: Float32Array;
}

/**
 * Input of `brindle.surface` from indexed or plain triangles; pass `repair: true` to join vertices.
 * Coordinates are rounded to a millionth of the largest, so that seams close.
 */
export function surfaceInput(geometry: BufferGeometry): { positions: Float32Array; triangles: Uint32Array };

/** Stripes for materials of three's WebGLRenderer, computed per pixel by the library's own shaders. */
export class Stripes {
  /** Arrays of Surface, Pattern and frames. `width` is a share of the period. */
  constructor(surface: SurfaceArrays, pattern: PatternArrays, options?: { color?: ColorRepresentation; width?: number });
  /** Separate vertices for each triangle, for materials with stripes. */
  readonly geometry: BufferGeometry;
  readonly color: Color;
  width: number;
  /** Another pattern of the same surface, such as a frame; `moved`: its changed positions and normals. */
  setPattern(pattern: PatternArrays, moved?: { positions: Float32Array; normals: Float32Array }): void;
  /** A frame's `vertices`: its pattern and its positions. */
  setVertices(vertices: Float32Array): void;
  /** Adds stripes to a material, and returns it. Use it only with `geometry`. */
  paint<M extends Material>(material: M): M;
  /** Frees geometry and textures; dispose of materials yourself. */
  dispose(): void;
}
