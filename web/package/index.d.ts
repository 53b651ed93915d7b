/** Stripes over surfaces. Arrays that come out are copies; those that go in are copied, too. */

/** What could not be done; the message says what failed and the remedy. */
export class BrindleError extends Error {
  readonly name: 'BrindleError';
}

/** Numbers one after the other: typed arrays of up to 32 bits or of doubles, or a plain array. */
export type Numbers = Float32Array | Float64Array | Int8Array | Uint8Array | Int16Array | Uint16Array |
  Int32Array | Uint32Array | readonly number[];

/** Three numbers a vertex: a unit tangent vector that stripes run across, or 0, 0, 0 for no stripes. */
export type DirectionField = Float32Array;

export interface SurfaceInput {
  /** x, y, z of every vertex. */
  positions: Numbers;
  /** Three numbers of vertices, from 0, of every triangle. */
  triangles: Numbers;
}

export interface CreaseOption {
  /** Edges that bend by more degrees are creases: their vertices get one more for each further face, behind all others, each with
   * a wave of its own. From 0 to 180, which is none; left out, 40 for files and shapes, and 180 for your own arrays. */
  creaseAngle?: number;
}

export interface SurfaceOptions extends CreaseOption {
  /** Joins vertices at one place and drops bad triangles, before creases are looked for. */
  repair?: boolean;
}

export interface RotateOption {
  /** Degrees about the normals, counter-clockwise seen from outside; 0 if left out. */
  rotate?: number;
}

/** A line near the surface that the field follows. */
export interface FieldStroke {
  /** x, y, z of two points or more, relative to the surface's `origin`. */
  points: Numbers;
  /** How far from the line it draws, in units of length; above 0. */
  radius: number;
  /** In multiples of what all neighbours of a vertex pull together; 1 if left out. */
  strength?: number;
}

export interface SmoothFieldOptions extends RotateOption {
  /** 1 vectors, 2 lines (default), 4 crosses. */
  symmetry?: number;
  /** How strongly principal curvature attracts the field; 0 (default): not. */
  curvature?: number;
  curvatureDirection?: 'max' | 'min';
  /** How strongly sharp edges and boundaries attract it; 0 (default): not. */
  features?: number;
  /** An edge is sharp from this bend on, in degrees; 40 if left out. */
  featureAngle?: number;
  strokes?: readonly FieldStroke[];
}

export interface FrequencyOptions {
  /** Stripes along the diagonal of the surface's box; 40 if nothing is said. Excludes the others. */
  stripes?: number;
  /** Stripes per unit length, everywhere or a number per vertex. */
  frequency?: number | Numbers;
  /** Distance between stripes: the same as a `frequency` of 1 / spacing. */
  spacing?: number;
}

export interface MeasuredFieldOptions extends FrequencyOptions {
  symmetry?: number;
  /** The field is averaged over places so many periods of the stripes away; 1 if left out. */
  periods?: number;
  /** How far holes are filled from their border, in periods; 2 if left out. */
  fill?: number;
  /** Pairs of singularities are undone until so many are left. */
  singularities?: number;
  /** How much each datum counts: one number per vertex. */
  confidence?: Float32Array;
}

export interface MeasuredField {
  directions: DirectionField;
  /** How much the data around a vertex agree, from 0 to 1. */
  agreement: Float32Array;
}

export interface StripeOptions extends FrequencyOptions {
  /** Frequencies may depart by up to a factor 1 + slack, so that fewer stripes begin or end; 0 if left out. */
  slack?: number;
  /** Further descents of the solver; 0 if left out. */
  cycles?: number;
  /** Phases to stay near to, as `Pattern.phases()` gives them. */
  lastPhases?: Float32Array;
}

export interface TextureOptions extends StripeOptions {
  frequency?: number;
  /** Whether directions have a sense, along which the texture points. */
  oriented?: boolean;
}

declare class Owned {
  /** Gives the module's memory back; any other call then throws. */
  dispose(): void;
  readonly isDisposed: boolean;
}

export class Surface extends Owned {
  readonly vertexCount: number;
  readonly triangleCount: number;
  /** Of the box around all vertices. */
  readonly diagonal: number;
  /** Where the positions' zero stands; not zero for surfaces far away from it. */
  readonly origin: [number, number, number];
  /** What was repaired, joined or left out, and what is probably not meant. */
  readonly notes: string[];
  /** What the file that it was read from says of its points and cells. */
  readonly arrays: readonly { name: string; of: 'points' | 'cells'; components: number }[];
  /** Three numbers a vertex, relative to `origin`. */
  positions(): Float32Array;
  normals(): Float32Array;
  triangles(): Uint32Array;
  /** Of every vertex that was handed in the one that triangles use; empty if nothing was joined. */
  vertexOfRow(): Uint32Array;
  /** Of the last vertices those that they are copies of, at creases; empty if there are none. */
  creaseVertices(): Uint32Array;

  /** A field that turns as little as possible. */
  smoothField(options?: SmoothFieldOptions): DirectionField;
  /** The directions of the larger (max) or smaller curvature. */
  curvatureField(options?: RotateOption & { direction?: 'max' | 'min' }): DirectionField;
  /** One vector for all vertices, projected into the tangent planes. */
  projectedField(vector: Numbers, options?: RotateOption): DirectionField;
  /** Your own vectors, three numbers a vertex, projected into the tangent planes. */
  tangentField(vectors: Numbers, options?: RotateOption): DirectionField;
  /** One of `arrays`, a row per vertex; of cells the mean around it. */
  array(name: string): Float32Array;
  /** One of `arrays` that has vectors: as `tangentField` of it. */
  arrayField(name: string, options?: RotateOption): DirectionField;
  rotatedField(field: DirectionField, degrees: number): DirectionField;
  /** Vectors that were measured, noisy or with holes, seen at the scale of the stripes. */
  measuredField(vectors: Numbers, options?: MeasuredFieldOptions): MeasuredField;
  /** One number per vertex: what the options say. */
  frequencies(options?: FrequencyOptions): Float32Array;

  stripes(field: DirectionField, options?: StripeOptions): Pattern;
  /** Texture coordinates: two patterns, the second across the first. */
  texture(field: DirectionField, options?: TextureOptions): Texture;
  /** The same along both directions of crosses, as `smoothField({ symmetry: 4 })` has them: for tiles that look the same turned by 90
   * degrees. It is drawn on `Texture.surface()`, on which triangles around which a cross turns are split. */
  crosses(field: DirectionField, options?: Omit<StripeOptions, 'lastPhases'>): Texture;
  /** Where pictures of the tool are taken from, by its --camera: the whole surface, or with `zoom` its middle. */
  camera(options?: CameraOptions): CameraView;
  /** Stripes that follow changing input, frame by frame. */
  animator(options?: AnimatorOptions): Animator;
  /** Textures that do. */
  textureAnimator(options?: TextureAnimatorOptions): TextureAnimator;
}

export interface CameraOptions {
  /** Degrees; 30 and 20 if left out. The camera moves counter-clockwise, seen from above, as the azimuth grows. */
  azimuth?: number;
  elevation?: number;
  /** 1 if left out. */
  zoom?: number;
  /** The axis that points up; 'y' if left out. */
  up?: 'y' | 'z';
  /** Pixels of the picture; 800 and 600 if left out. */
  width?: number;
  height?: number;
}

/** What `StripeDrawing.draw` takes: matrices in columns, the first of positions less the middle of the surface's box. */
export interface CameraView {
  viewFromWorld: Float32Array;
  clipFromView: Float32Array;
  up: Float32Array;
  width: number;
  height: number;
}

export interface Curves {
  /** x, y, z of all curves' points, one curve after the other. */
  points: Float32Array;
  normals: Float32Array;
  /** Curve i has the points offsets[i] to offsets[i + 1] - 1. */
  offsets: Uint32Array;
  /** 1 if the curve comes back to its first point, which is not repeated. */
  closed: Uint8Array;
  /** Two a curve, at its first and its last point: 0 none, as it is closed, 1 a boundary, 2 no wave, 3 an
   * edge of three triangles, 4 a branch, 5 a singularity of the field, 6 a crease where phases do not meet. */
  ends: Uint8Array;
}

export interface CurveOptions {
  /** Joins curves that end in one branch in pairs; others run on into their neighbours, with `fair` smoothly. */
  join?: boolean;
  /** Cuts ends back to where no curve is nearer than this share of the spacing; 0: as traced. Default: 0.6, or
   * 0 with `join`, which excludes others. */
  trim?: number;
  /** Takes out kinks shorter than about this share of the spacing; 0: not. */
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
  /** Of spacing, as a share. */
  readonly spacingErrorMean: number;
  readonly verticesWithoutWave: number;
  /** With slack: frequencies chosen over those asked for. */
  readonly frequencyChange?: { ratioMin: number; ratioMax: number };
  /** With creases: degrees by which the phases of both sides differ on average. */
  readonly creaseSlipMean?: number;
  /** Of the creases' length, the share where these differ by more than 60. */
  readonly creaseSlipShare?: number;
  readonly milliseconds: { topology: number; frequency: number; couple: number; solve: number; pattern: number };
  /** Sentences on what is probably not meant. */
  readonly warnings: string[];
  /** cos and sin of every vertex's phase. */
  phases(): Float32Array;
  directions(): DirectionField;
  /** Stripes per unit length, one number per vertex: with slack those chosen. */
  frequencies(): Float32Array;
  /** Per triangle 0 regular, 1 branch, 2 singularity of the field, 3 no wave. */
  triangleKinds(): Uint8Array;
  /** The stripes' centre lines. */
  curves(options?: CurveOptions): Curves;
  /** The same as a file: .obj, .ply, .vtp or .csv by its name. */
  curvesFile(name: string, options?: CurveOptions): Uint8Array;
  /** Where the stripes of two patterns of one surface cross. */
  samplesWith(other: Pattern): Samples;
  /** A drawing of the curves without hidden lines. `rotation` (x, y, z, w) turns coordinates to the viewer's. */
  svg(options?: { rotation?: readonly number[]; zoom?: number; width?: number; height?: number } & CurveOptions): Uint8Array;
}

export interface TexturedMesh {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
  /** U and V, one tile a unit, V upwards. */
  uvs: Float32Array;
}

/** Direction, frequency and cosine and sine of the phase at every corner of every triangle: six numbers each. */
export interface TextureWaves {
  u: Float32Array;
  v: Float32Array;
}

/** A figure that repeats: distances to its border in sides of the tile, negative inside; row by row from V = 0. */
export interface Tile {
  side: number;
  distances: Float32Array;
}

/** Which figures of a tile branches, seams and borders would cut; without words none. */
export interface BrokenTiles {
  words: Uint32Array;
  layout: number;
  split: boolean;
}

export class Texture extends Owned {
  /** Branches of U and V, and the mean of their energies; of crosses those of both waves together. */
  readonly branches: number;
  readonly energy: number;
  /** What it is drawn on: a surface of its own to be disposed of; of crosses, with triangles split. */
  surface(): Surface;
  /** For `StripeDrawing.setTexture`, with `brindle.tile(name)` and `brokenTiles(name)`. */
  waves(): TextureWaves;
  /** Of tiles that the tool draws whole: arrows, dots, signs and bricks. */
  brokenTiles(tile: string): BrokenTiles;
  /** As those of a Pattern: of U, and where that is regular, of V. */
  triangleKinds(): Uint8Array;
  /** U and V of three corners per triangle; NaN in singularities and where there is no wave. */
  cornerUVs(): Float32Array;
  /** One pair per vertex: vertices are split where needed, triangles at branches, too. */
  mesh(): TexturedMesh;
  /** The same as binary glTF. */
  glb(): Uint8Array;
}

export interface AnimatorOptions {
  /** How near phases stay to the last frame's; 0.025 if left out, 0: each frame from scratch. */
  lambda?: number;
  cycles?: number;
  slack?: number;
}

export interface FrameInput extends FrequencyOptions {
  directions: DirectionField;
  /** One number per vertex, instead of `stripes` or `frequency`. */
  frequencies?: Float32Array;
  /** Of vertices that moved; left out: where the surface has them. */
  positions?: Float32Array;
  /** Unit vectors that directions must be tangent to. */
  normals?: Float32Array;
  /** Whether the frame has `vertices`; or an array of 12 numbers a vertex, which is filled and handed back. */
  vertices?: boolean | Float32Array;
  /** Whether the frame has `corners`; or an array of 3 numbers a triangle, likewise. */
  corners?: boolean | Float32Array;
}

export interface Frame {
  phases: Float32Array;
  /** Mean angle to the last frame's phases, in radians. */
  phaseStep: number;
  unchanged: boolean;
  milliseconds: number;
  /** With slack: those chosen. */
  frequencies?: Float32Array;
  /** What shaders read, with the normals of positions that moved: for `setVertices` of brindle/draw and brindle/three. */
  vertices?: Float32Array;
  /** Phases at the corners of triangles in radians, linear in each triangle; NaN where there are none. */
  corners?: Float32Array;
}

export class Animator extends Owned {
  frame(input: FrameInput): Frame;
  energy(): number;
  restart(): void;
}

export interface TextureAnimatorOptions extends AnimatorOptions {
  /** Whether directions have a sense, along which the texture points. */
  oriented?: boolean;
  /** The tile whose figures are to stay whole: frames then have `broken`. */
  tile?: string;
}

/** As that of stripes; positions that moved come with normals, about which V is turned. */
export type TextureFrameInput = Omit<FrameInput, 'vertices' | 'corners'>;

/** What `StripeDrawing.setTexture` and `setKinds` take, and figures as those of a Texture. */
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
  /** The next frame, of vertices where the surface has them, as a texture that stays. */
  texture(input: Omit<TextureFrameInput, 'positions' | 'normals'>): Texture;
  /** The next frame goes on from this texture of the surface. */
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
  /** Of arrays, checked. */
  surface(input: SurfaceInput, options?: SurfaceOptions): Surface;
  /** Of a file's bytes, by the extension of its name: .obj, .ply, .stl, .off, .glb, .vtk. */
  readSurface(bytes: ArrayBuffer | Uint8Array, name: string, options?: CreaseOption): Surface;
}

export function createBrindle(): Promise<Brindle>;
export default createBrindle;
