import type { BufferGeometry, Color, ColorRepresentation, Material } from 'three';

export interface SurfaceArrays {
  /** Three numbers a vertex. */
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
 * What `brindle.surface` takes, of triangles with an index or without; with `repair: true` it joins their vertices.
 * Coordinates are rounded to a millionth of the largest, so that seams close.
 */
export function surfaceInput(geometry: BufferGeometry): { positions: Float32Array; triangles: Uint32Array };

/** Stripes for materials of three's WebGLRenderer, computed at every pixel by the library's own shaders. */
export class Stripes {
  /** Arrays as Surface, Pattern and frames give them. `width` is a share of the period. */
  constructor(surface: SurfaceArrays, pattern: PatternArrays, options?: { color?: ColorRepresentation; width?: number });
  /** Three vertices a triangle, which materials with stripes need. */
  readonly geometry: BufferGeometry;
  readonly color: Color;
  width: number;
  /** Another pattern of the same surface, such as a frame; `moved`: positions and normals that changed with it. */
  setPattern(pattern: PatternArrays, moved?: { positions: Float32Array; normals: Float32Array }): void;
  /** A frame's `vertices`: its pattern, and where vertices are now. */
  setVertices(vertices: Float32Array): void;
  /** Lets a material have the stripes over its colour, and gives it back. Use it with `geometry` alone. */
  paint<M extends Material>(material: M): M;
  /** Gives geometry and textures back; the materials are yours. */
  dispose(): void;
}
