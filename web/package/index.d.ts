/** Stripes over surfaces. Arrays are copied on input and output. */

/** A failure; the message has the reason and the remedy. */
export class BrindleError extends Error {
  readonly name: 'BrindleError';
}

/** Numbers: typed arrays of up to 32 bits or of doubles, or a plain array. */
export type Numbers = Float32Array | Float64Array | Int8Array | Uint8Array | Int16Array | Uint16Array |
  Int32Array | Uint32Array | readonly number[];

/** Three numbers per vertex: a unit tangent vector, which stripes run across, or 0, 0, 0 for no stripes. */
export type DirectionField = Float32Array;

export interface SurfaceInput {
  /** x, y, z of every vertex. */
  positions: Numbers;
  /** Three vertex numbers, from 0, per triangle. */
  triangles: Numbers;
}

export interface CreaseOption {
  /** Edges that bend by more degrees are creases: their vertices are copied for each further face, behind all others, with a
   * wave of their own. 0 to 180 (none); default 40 for files and shapes, 180 for your own arrays. */
  creaseAngle?: number;
}

export interface SurfaceOptions extends CreaseOption {
  /** Joins vertices at one position and drops invalid triangles, before creases are found. */
  repair?: boolean;
}

export interface RotateOption {
  /** Degrees about the normals, counter-clockwise seen from outside; default 0. */
  rotate?: number;
}

export interface ArrayFieldOptions extends RotateOption {
  /** Whether vectors have a sense: where arrays of cells, or of a surface that was subdivided, are averaged, those that face each
   * other cancel. Left out, they are lines. */
  oriented?: boolean;
}

/** A line near the surface that the field follows. */
export interface FieldStroke {
  /** x, y, z of at least two points, relative to the surface's `origin`. */
  points: Numbers;
  /** Radius of influence, in units of length; above 0. */
  radius: number;
  /** Relative to the pull of all neighbours of a vertex together; default 1. */
  strength?: number;
}

export interface SmoothFieldOptions extends RotateOption {
  /** 1 vectors, 2 lines (default), 4 crosses. */
  symmetry?: number;
  /** Attraction to principal curvature; default 0. */
  curvature?: number;
  curvatureDirection?: 'max' | 'min';
  /** Attraction to sharp edges and boundaries; default 0. */
  features?: number;
  /** Bend from which an edge is sharp, in degrees; default 40. */
  featureAngle?: number;
  strokes?: readonly FieldStroke[];
}

export interface FrequencyOptions {
  /** Stripes along the diagonal of the surface's box; 40 if nothing is said. Excludes the others. */
  stripes?: number;
  /** Stripes per unit length: one number, or one per vertex. */
  frequency?: number | Numbers;
  /** Distance between stripes: the same as a `frequency` of 1 / spacing. */
  spacing?: number;
}

export interface MeasuredFieldOptions extends FrequencyOptions {
  symmetry?: number;
  /** Smoothing length in periods of the stripes; default 1. */
  periods?: number;
  /** Distance over which holes are filled, in periods; default 2. */
  fill?: number;
  /** Cancels pairs of singularities until at most this many remain. */
  singularities?: number;
  /** Confidence of each datum: one number per vertex. */
  confidence?: Float32Array;
}

export interface MeasuredField {
  directions: DirectionField;
  /** Directional coherence of the data around each vertex, from 0 to 1. */
  coherence: Float32Array;
  /** 1 for directions that fill a hole, else 0. */
  filled: Uint8Array;
}

export interface StripeOptions extends FrequencyOptions {
  /** Spacing tolerance: frequencies may vary by a factor of 1 + slack, for fewer branches; default 0. */
  slack?: number;
  /** Further descents of the solver; default 0. */
  cycles?: number;
  /** Phases to stay near to, from `Pattern.phases()`. */
  lastPhases?: Float32Array;
}

export interface TextureOptions extends StripeOptions {
  frequency?: number;
  /** Whether directions have signs, along which the texture points. */
  oriented?: boolean;
  /** The tile that it is drawn with, for `brokenTiles()`. */
  tile?: string;
}

declare class Owned {
  /** Frees the module's memory; any later call throws. */
  dispose(): void;
  readonly isDisposed: boolean;
}

export class Surface extends Owned {
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** The diagonal of the bounding box. */
  readonly diagonal: number;
  /** The origin of positions; not zero for surfaces far from zero. */
  readonly origin: [number, number, number];
  /** Repairs, joined vertices, left-out parts and likely mistakes. */
  readonly notes: string[];
  /** The point and cell arrays of its file. */
  readonly arrays: readonly { name: string; of: 'points' | 'cells'; components: number }[];
  /** Three numbers per vertex, relative to `origin`. */
  positions(): Float32Array;
  normals(): Float32Array;
  triangles(): Uint32Array;
  /** The vertex that replaces each input vertex; empty if nothing was joined. */
  vertexOfRow(): Uint32Array;
  /** The sources of the last vertices, which are copies at creases; may be empty. */
  creaseVertices(): Uint32Array;

  /** The smoothest field. */
  smoothField(options?: SmoothFieldOptions): DirectionField;
  /** The directions of the larger (max) or smaller curvature. */
  curvatureField(options?: RotateOption & { direction?: 'max' | 'min' }): DirectionField;
  /** One vector for all vertices, projected into the tangent planes. */
  projectedField(vector: Numbers, options?: RotateOption): DirectionField;
  /** Your own vectors, three numbers per vertex, projected into the tangent planes. */
  tangentField(vectors: Numbers, options?: RotateOption): DirectionField;
  /** One of `arrays`, a row per vertex; cell arrays are averaged. */
  array(name: string): Float32Array;
  /** One of `arrays` that has vectors: as `tangentField` of it. */
  arrayField(name: string, options?: ArrayFieldOptions): DirectionField;
  rotatedField(field: DirectionField, degrees: number): DirectionField;
  /** Smooths measured vectors, which may be noisy and have holes. */
  measuredField(vectors: Numbers, options?: MeasuredFieldOptions): MeasuredField;
  /** The options' frequencies, one number per vertex. */
  frequencies(options?: FrequencyOptions): Float32Array;

  /** The same surface, every triangle split in four, `times` times; `arrays` are interpolated. */
  subdivided(times: number): Surface;

  stripes(field: DirectionField, options?: StripeOptions): Pattern;
  /** Texture coordinates: two patterns, the second across the first. */
  texture(field: DirectionField, options?: TextureOptions): Texture;
  /** The same along both directions of crosses, as from `smoothField({ symmetry: 4 })`, for tiles with fourfold symmetry.
   * Draw it on `Texture.surface()`, where singular triangles are split. */
  crosses(field: DirectionField, options?: Omit<StripeOptions, 'lastPhases'>): Texture;
  /** The camera of the tool's --camera: frames the whole surface, or with `zoom` its middle. */
  camera(options?: CameraOptions): CameraView;
  /** Stripes that follow changing input, frame by frame. */
  animator(options?: AnimatorOptions): Animator;
  /** Textures that follow changing input. */
  textureAnimator(options?: TextureAnimatorOptions): TextureAnimator;
}

/** Orthographic keeps parallel lines. */
export type Projection = 'perspective' | 'orthographic';

export interface CameraOptions {
  /** Degrees; default 30 and 20. A larger azimuth moves the camera counter-clockwise, seen from above. */
  azimuth?: number;
  elevation?: number;
  /** Instead of azimuth and elevation. */
  side?: 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom';
  /** Default 1. */
  zoom?: number;
  /** Default 'perspective'. */
  projection?: Projection;
  /** The axis that points up; 'y' if left out. */
  up?: 'x' | 'y' | 'z' | '-x' | '-y' | '-z';
  /** Pixels of the picture; 800 and 600 if left out. */
  width?: number;
  height?: number;
}

/** A view as `Pattern.svg` draws it: `rotation` (x, y, z, w) turns coordinates to the viewer's. */
export interface DrawnView {
  rotation?: Numbers;
  zoom?: number;
  projection?: Projection;
  width?: number;
  height?: number;
}

/** What `StripeDrawing.draw` takes: matrices in columns, the first of positions less the middle of the surface's box. Also for
 * `Pattern.svg`. */
export interface CameraView {
  viewFromWorld: Float32Array;
  clipFromView: Float32Array;
  up: Float32Array;
  rotation: Float32Array;
  zoom: number;
  projection: Projection;
  width: number;
  height: number;
}

export interface Curves {
  /** x, y, z of all curves' points, curve by curve. */
  points: Float32Array;
  normals: Float32Array;
  /** Curve i has the points offsets[i] to offsets[i + 1] - 1. */
  offsets: Uint32Array;
  /** 1 if the curve is closed; its first point is not repeated. */
  closed: Uint8Array;
  /** Two per curve, for its first and last point: 0 none (closed), 1 a boundary, 2 no wave, 3 an edge of three triangles,
   * 4 a branch, 5 a singularity of the field, 6 a crease at which phases differ. */
  ends: Uint8Array;
}

export interface CurveOptions {
  /** Joins curves that end in one branch in pairs; extends others to their neighbours, smoothly with `fair`. */
  join?: boolean;
  /** Cuts ends back to where no curve is nearer than this share of the spacing; 0: as traced. Default: 0.6, or
   * 0 with `join`, which excludes others. */
  trim?: number;
  /** Smooths kinks shorter than about this share of the spacing; 0: none. */
  fair?: number;
}

export interface Samples {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
  barycentric: Float32Array;
}

export class Pattern extends Owned {
  /** From 0 to 1; about 0.5 for random phases. */
  readonly energy: number;
  /** Triangles in which a stripe begins or ends, or the field has a singularity. */
  readonly branches: number;
  readonly fieldSingularities: number;
  /** Degrees between the pattern and its field, over regular triangles. */
  readonly angleErrorMean: number;
  /** Relative error of the spacing. */
  readonly spacingErrorMean: number;
  readonly verticesWithoutWave: number;
  /** With slack: chosen over requested frequencies. */
  readonly frequencyChange?: { ratioMin: number; ratioMax: number };
  /** With creases: mean difference of the phases of both sides, in degrees. */
  readonly creaseSlipMean?: number;
  /** The share of the creases' length with a difference of more than 60 degrees. */
  readonly creaseSlipShare?: number;
  readonly milliseconds: { topology: number; frequency: number; couple: number; solve: number; pattern: number };
  /** Sentences about likely mistakes. */
  readonly warnings: string[];
  /** cos and sin of every vertex's phase. */
  phases(): Float32Array;
  directions(): DirectionField;
  /** Stripes per unit length, one number per vertex; with slack, the chosen ones. */
  frequencies(): Float32Array;
  /** Per triangle 0 regular, 1 branch, 2 singularity of the field, 3 no wave. */
  triangleKinds(): Uint8Array;
  /** The stripes' centre lines. */
  curves(options?: CurveOptions): Curves;
  /** The same as the content of a file. */
  curvesFile(format: 'obj' | 'ply' | 'vtp' | 'csv', options?: CurveOptions): Uint8Array;
  /** Where the stripes of two patterns of one surface cross. */
  samplesWith(other: Pattern): Samples;
  /** A drawing of the curves without hidden lines; `camera` as `Surface.camera` gives it. */
  svg(options?: { camera?: CameraView | DrawnView } & CurveOptions): Uint8Array;
}

export interface TexturedMesh {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
  /** U and V, one unit per tile, V upwards. */
  uvs: Float32Array;
}

/** Direction, frequency and cosine and sine of the phase at every corner of every triangle: six numbers each. */
export interface TextureWaves {
  u: Float32Array;
  v: Float32Array;
}

/** A repeating motif: distances to its border in tile sides, negative inside; row by row from V = 0. */
export interface Tile {
  side: number;
  distances: Float32Array;
}

/** The motifs of a tile that branches, seams and borders would cut; none if `words` is empty. */
export interface BrokenTiles {
  words: Uint32Array;
  layout: number;
  split: boolean;
}

export class Texture extends Owned {
  /** Branches of U and V, and the mean of their energies; for crosses, of both waves together. */
  readonly branches: number;
  readonly energy: number;
  /** Sentences on what is probably not meant. */
  readonly warnings: string[];
  /** As `texture` was given it. */
  readonly tile?: string;
  /** What it is drawn on: a surface of its own to be disposed of; of crosses, with triangles split. */
  surface(): Surface;
  /** For `StripeDrawing.setTexture`, with `brindle.tile(name)` and `brokenTiles(name)`. */
  waves(): TextureWaves;
  /** Of tiles that the tool draws whole: arrows, dots, signs and bricks; left out, the texture's `tile`. */
  brokenTiles(tile?: string): BrokenTiles;
  /** As those of a Pattern: of U, and where that is regular, of V. */
  triangleKinds(): Uint8Array;
  /** U and V of three corners per triangle; NaN in singularities and without a wave. */
  cornerUVs(): Float32Array;
  /** One pair per vertex: splits vertices where needed, and triangles at branches. */
  mesh(): TexturedMesh;
  /** The same as binary glTF. */
  glb(): Uint8Array;
}

export interface AnimatorOptions {
  /** Weight of the last frame's phases; default 0.025, 0: each frame from scratch. */
  lambda?: number;
  cycles?: number;
  slack?: number;
}

export interface FrameInput extends FrequencyOptions {
  directions: DirectionField;
  /** One number per vertex, instead of `stripes` or `frequency`. */
  frequencies?: Float32Array;
  /** Of moved vertices; default: the surface's. */
  positions?: Float32Array;
  /** Unit normals of the directions. */
  normals?: Float32Array;
  /** Whether the frame has `vertices`; or an array of 12 numbers per vertex to fill and return. */
  vertices?: boolean | Float32Array;
  /** Whether the frame has `corners`; or an array of 3 numbers per triangle to fill and return. */
  corners?: boolean | Float32Array;
}

export interface Frame {
  phases: Float32Array;
  /** Mean angle to the last frame's phases, in radians. */
  phaseStep: number;
  unchanged: boolean;
  milliseconds: number;
  /** With slack: the chosen ones. */
  frequencies?: Float32Array;
  /** Shader input with the normals of moved positions, for `setVertices` of brindle/draw and brindle/three. */
  vertices?: Float32Array;
  /** Phases at the corners of triangles in radians, linear in each triangle; NaN if undefined. */
  corners?: Float32Array;
}

export class Animator extends Owned {
  frame(input: FrameInput): Frame;
  energy(): number;
  restart(): void;
}

export interface TextureAnimatorOptions extends AnimatorOptions {
  /** Whether directions have signs, along which the texture points. */
  oriented?: boolean;
  /** The tile whose motifs stay whole: frames then have `broken`. */
  tile?: string;
}

/** As for stripes; moved positions need normals, about which V is turned. */
export type TextureFrameInput = Omit<FrameInput, 'vertices' | 'corners'>;

/** Input of `StripeDrawing.setTexture` and `setKinds`, and metrics as in Texture. */
export interface TextureFrame {
  waves: TextureWaves;
  triangleKinds: Uint8Array;
  broken: BrokenTiles;
  branches: number;
  energy: number;
  unchanged: boolean;
  milliseconds: number;
}

export class TextureAnimator extends Owned {
  frame(input: TextureFrameInput): TextureFrame;
  /** The next frame, on the surface's positions, as a permanent texture. */
  texture(input: Omit<TextureFrameInput, 'positions' | 'normals'>): Texture;
  /** Makes the next frame continue this texture of the surface. */
  follow(texture: Texture): void;
  restart(): void;
}

export interface Brindle {
  readonly version: string;
  /** Names of the built-in shapes. */
  shapes(): string[];
  /** Names of the built-in tiles: 'checker', 'dots' and so on. */
  tiles(): string[];
  tile(name: string): Tile;
  /** A built-in shape: 'torus' or 'torus,resolution=64'. */
  shape(spec: string, options?: CreaseOption): Surface;
  /** From arrays, which are checked. */
  surface(input: SurfaceInput, options?: SurfaceOptions): Surface;
  /** From a file's bytes, by its extension: .obj, .ply, .stl, .off, .glb, .vtk. */
  readSurface(bytes: ArrayBuffer | Uint8Array, name: string, options?: CreaseOption): Surface;
}

export function createBrindle(): Promise<Brindle>;
export default createBrindle;
