// Real-time stripes on either WebAssembly module: checks input and names results. Results are copies:
// nothing refers to the module's memory.
import { choice, corners, creased, fail, filled, floats, options, table } from './checks.js';

// Owns an object of the module until it is disposed of.
export class Owned {
  #raw;
  #module;
  constructor(kind, module, raw) {
    this.#raw = raw;
    this.#module = module;
    this.kind = kind;
  }
  get module() {
    return this.#module;
  }
  get raw() {
    return this.#raw ?? fail(`this ${this.kind.toLowerCase()} was disposed of`);
  }
  get isDisposed() {
    return this.#raw === null;
  }
  /** Frees the module's memory; may be called again. */
  dispose() {
    this.#raw?.delete();
    this.#raw = null;
  }
}
if (Symbol.dispose) {
  Owned.prototype[Symbol.dispose] = Owned.prototype.dispose;
}

// A field of the module, rotated by degrees.
export function turned(surface, field, degrees) {
  return degrees === 0 ? field : surface.module.rotatedField(surface.raw, field, degrees);
}

export const frequencyOptions = { stripes: undefined, frequency: undefined, spacing: undefined };
export const stripeOptions = { ...frequencyOptions, slack: 0, cycles: 0, lastPhases: undefined };

export class Surface extends Owned {
  constructor(module, raw) {
    super('Surface', module, raw);
    this.vertexCount = raw.vertexCount();
    this.triangleCount = raw.triangleCount();
    this.diagonal = raw.diagonal();
    this.origin = raw.origin();
    this.notes = raw.notes();
  }

  positions() {
    return this.raw.positions();
  }
  normals() {
    return this.raw.normals();
  }
  triangles() {
    return this.raw.triangles();
  }
  vertexOfRow() {
    return this.raw.vertexOfRow();
  }
  creaseVertices() {
    return this.raw.creaseVertices();
  }

  smoothField(given) {
    const o = options(given, { symmetry: 2, curvature: 0, curvatureDirection: 'max', features: 0,
                               featureAngle: 40, strokes: [], rotate: 0 }, 'smoothField');
    choice(o.curvatureDirection, ['max', 'min'], 'curvatureDirection');
    o.strokes = o.strokes.map((stroke) => {
      const s = options(stroke, { points: undefined, radius: NaN, strength: 1 }, 'a stroke');
      return { ...s, points: Float32Array.from(table(s.points, "a stroke's points")) };
    });
    return turned(this, this.module.smoothField(this.raw, o), o.rotate);
  }
  curvatureField(given) {
    const o = options(given, { direction: 'max', rotate: 0 }, 'curvatureField');
    choice(o.direction, ['max', 'min'], 'direction');
    return turned(this, this.module.curvatureField(this.raw, o.direction), o.rotate);
  }
  projectedField(vector, given) {
    const o = options(given, { rotate: 0 }, 'projectedField');
    const [x, y, z] = floats(vector, 3, 'the vector');
    return turned(this, this.module.projectedField(this.raw, x, y, z), o.rotate);
  }
  tangentField(vectors, given) {
    const o = options(given, { rotate: 0 }, 'tangentField');
    const field = floats(vectors, 3 * this.vertexCount, 'the field');
    return turned(this, this.module.tangentField(this.raw, field), o.rotate);
  }
  rotatedField(field, degrees) {
    return this.module.rotatedField(this.raw, floats(field, 3 * this.vertexCount, 'the field'), degrees);
  }

  // `stripes` along the diagonal, 40 if nothing is said, `frequency` in stripes per unit length, or `spacing`.
  frequencies({ stripes, frequency, spacing } = {}) {
    if ([stripes, frequency, spacing].filter((given) => given !== undefined).length > 1) {
      fail("'stripes', 'frequency' and 'spacing' exclude each other");
    }
    if (frequency !== undefined && typeof frequency !== 'number') {
      return floats(frequency, this.vertexCount, "'frequency'");
    }
    const number = frequency ?? (spacing === undefined ? Math.fround(stripes ?? 40) / Math.fround(this.diagonal)
                                                       : 1 / Math.fround(spacing));
    if (!(number > 0 && Number.isFinite(number))) fail("'stripes', 'frequency' and 'spacing' must be above 0");
    return new Float32Array(this.vertexCount).fill(number);
  }

  stripes(field, given) {
    const o = options(given, stripeOptions, 'stripes');
    const directions = floats(field, 3 * this.vertexCount, 'the field');
    return this.patternOf(this.module.stripes(this.raw, directions, this.frequencies(o), o));
  }

  patternOf(raw) {
    return new Pattern(this.module, raw);
  }

  animator(given) {
    const o = options(given, { lambda: 0.025, cycles: 0, slack: 0 }, 'animator');
    return new Animator(this.module, this.module.animator(this.raw, o), this);
  }
}

export class Pattern extends Owned {
  constructor(module, raw) {
    super('Pattern', module, raw);
    Object.assign(this, raw.metrics());
    this.warnings = raw.warnings();
  }

  phases() {
    return this.raw.phases();
  }
  directions() {
    return this.raw.directions();
  }
  frequencies() {
    return this.raw.frequencies();
  }
  triangleKinds() {
    return this.raw.kinds();
  }
}

export const frameOptions = { ...frequencyOptions, directions: undefined, frequencies: undefined,
                              positions: undefined, normals: undefined };

// The common input of all animators' frames.
export function frameInput(surface, o) {
  const vectors = 3 * surface.vertexCount;
  const input = { directions: floats(o.directions, vectors, 'directions') };
  if (o.positions) input.positions = floats(o.positions, vectors, 'positions');
  if (o.normals) input.normals = floats(o.normals, vectors, 'normals');
  input.frequencies = o.frequencies
    ? floats(o.frequencies, surface.vertexCount, 'frequencies') : surface.frequencies(o);
  return input;
}

export class Animator extends Owned {
  #surface;
  constructor(module, raw, surface) {
    super('Animator', module, raw);
    this.#surface = surface;
  }
  frame(given) {
    const o = options(given, { ...frameOptions, vertices: undefined, corners: undefined }, 'frame');
    const surface = this.#surface, input = frameInput(surface, o);
    const drawn = { vertices: filled(o.vertices, 12 * surface.vertexCount, 'vertices'),
                    corners: filled(o.corners, 3 * surface.triangleCount, 'corners') };
    return { ...this.raw.frame({ ...input, ...drawn }), ...Object.fromEntries(Object.entries(drawn).filter(([, array]) => array)) };
  }
  energy() {
    return this.raw.energy();
  }
  restart() {
    this.raw.restart();
  }
}

export class Brindle {
  #module;
  constructor(module) {
    this.#module = module;
    this.version = module.version();
  }
  get module() {
    return this.#module;
  }

  surface({ positions, triangles }, given) {
    // Copied vertices would change the required length of a caller's arrays.
    const o = creased(options(given, { repair: false, creaseAngle: 180 }, 'surface'));
    return this.surfaceOf(this.rawSurface(positions, triangles, o));
  }
  rawSurface(positions, triangles, { repair, creaseAngle }) {
    return this.module.surfaceFromArrays(table(positions, 'positions'), corners(triangles), repair, creaseAngle);
  }
  surfaceOf(raw) {
    return new Surface(this.module, raw);
  }
}
