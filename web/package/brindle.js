// The library over the module of WebAssembly: checks what is handed in, names what comes out. Results
// are copies: nothing refers to the module's memory.
import createModule from './module.js';
import { readGLB, writeGLB } from './glb.js';
import { BrindleError } from './error.js';

export { BrindleError };

const fail = (message) => {
  throw new BrindleError(message);
};

// Of options with their defaults those that were given. A default says what type is meant.
function options(given, known, what) {
  const result = { ...known };
  for (const [name, value] of Object.entries(given ?? {})) {
    if (!(name in known)) {
      fail(`${what} knows no option '${name}'; it knows ${Object.keys(known).join(', ')}`);
    }
    if (value === undefined) continue;
    if (typeof known[name] === 'number' && !(typeof value === 'number' && Number.isFinite(value))) {
      fail(`${what}: '${name}' must be a finite number, not ${String(value)}`);
    }
    if (typeof known[name] === 'boolean' && typeof value !== 'boolean') {
      fail(`${what}: '${name}' must be true or false`);
    }
    result[name] = value;
  }
  return result;
}

function choice(value, names, what) {
  return names.includes(value) ? value : fail(`${what} must be ${names.join(' or ')}, not '${value}'`);
}

const tables = [Float32Array, Float64Array, Int32Array, Uint32Array];

// Numbers of any kind as one of the arrays that the module takes, 64-bit whole numbers excepted.
function table(numbers, what) {
  if (tables.some((type) => numbers instanceof type)) return numbers;
  if (numbers instanceof Uint16Array || numbers instanceof Uint8Array) return Uint32Array.from(numbers);
  if (numbers instanceof Int16Array || numbers instanceof Int8Array) return Int32Array.from(numbers);
  if (Array.isArray(numbers) && numbers.every((n) => typeof n === 'number')) {
    return Float64Array.from(numbers);
  }
  return fail(`${what} must be a typed array or an array of numbers`);
}

// The same of numbers of vertices: a plain array's are whole where they can be.
function corners(numbers) {
  const whole = Array.isArray(numbers) && numbers.every((n) => Number.isInteger(n) && Math.abs(n) < 2 ** 31);
  return whole ? Int32Array.from(numbers) : table(numbers, 'triangles');
}

function floats(numbers, count, what) {
  const array = numbers instanceof Float32Array ? numbers : Float32Array.from(table(numbers, what));
  if (array.length !== count) fail(`${what} must have ${count} numbers, not ${array.length}`);
  return array;
}

// An array to be filled: the one that was given, or a new one where that is asked for.
function filled(wanted, count, what) {
  if (wanted === undefined || wanted === false) return undefined;
  if (wanted === true) return new Float32Array(count);
  if (!(wanted instanceof Float32Array) || wanted.length !== count) {
    fail(`${what} must be true or a Float32Array of ${count} numbers`);
  }
  return wanted;
}

// Has one object of the module, until it is disposed of.
class Owned {
  #raw;
  constructor(kind, raw) {
    this.#raw = raw;
    this.kind = kind;
  }
  get raw() {
    return this.#raw ?? fail(`this ${this.kind.toLowerCase()} was disposed of`);
  }
  get isDisposed() {
    return this.#raw === null;
  }
  /** Gives the module's memory back. Twice does no harm. */
  dispose() {
    this.#raw?.delete();
    this.#raw = null;
  }
}
if (Symbol.dispose) {
  Owned.prototype[Symbol.dispose] = Owned.prototype.dispose;
}

const stripeOptions = { stripes: undefined, frequency: undefined, slack: 0, cycles: 0, lastPhases: undefined };

export class Surface extends Owned {
  #module;
  constructor(module, raw) {
    super('Surface', raw);
    this.#module = module;
    this.vertexCount = raw.vertexCount();
    this.triangleCount = raw.triangleCount();
    this.diagonal = raw.diagonal();
    this.origin = raw.origin();
    this.notes = raw.notes();
    this.arrays = raw.arrays();
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

  smoothField(given) {
    const o = options(given, { symmetry: 2, curvature: 0, curvatureDirection: 'max', features: 0,
                               featureAngle: 40, strokes: [], rotate: 0 }, 'smoothField');
    choice(o.curvatureDirection, ['max', 'min'], 'curvatureDirection');
    o.strokes = o.strokes.map((stroke) => {
      const s = options(stroke, { points: undefined, radius: NaN, strength: 1 }, 'a stroke');
      return { ...s, points: Float32Array.from(table(s.points, "a stroke's points")) };
    });
    return this.#rotated(this.#module.smoothField(this.raw, o), o.rotate);
  }
  curvatureField(given) {
    const o = options(given, { direction: 'max', rotate: 0 }, 'curvatureField');
    choice(o.direction, ['max', 'min'], 'direction');
    return this.#rotated(this.#module.curvatureField(this.raw, o.direction), o.rotate);
  }
  projectedField(vector, given) {
    const o = options(given, { rotate: 0 }, 'projectedField');
    const [x, y, z] = floats(vector, 3, 'the vector');
    return this.#rotated(this.#module.projectedField(this.raw, x, y, z), o.rotate);
  }
  tangentField(vectors, given) {
    const o = options(given, { rotate: 0 }, 'tangentField');
    const field = floats(vectors, 3 * this.vertexCount, 'the field');
    return this.#rotated(this.#module.tangentField(this.raw, field), o.rotate);
  }
  array(name) {
    return this.raw.array(String(name));
  }
  arrayField(name, given) {
    const o = options(given, { rotate: 0 }, 'arrayField');
    return this.#rotated(this.#module.arrayField(this.raw, String(name)), o.rotate);
  }
  rotatedField(field, degrees) {
    return this.#module.rotatedField(this.raw, floats(field, 3 * this.vertexCount, 'the field'), degrees);
  }
  measuredField(vectors, given) {
    const o = options(given, { symmetry: 2, periods: 1, fill: 2, singularities: undefined,
                               confidence: undefined, stripes: undefined, frequency: undefined },
                      'measuredField');
    const field = floats(vectors, 3 * this.vertexCount, 'the field');
    return this.#module.detailedField(this.raw, field, this.frequencies(o), o);
  }
  #rotated(field, degrees) {
    return degrees === 0 ? field : this.#module.rotatedField(this.raw, field, degrees);
  }

  // `stripes` along the diagonal, 40 if nothing is said, or `frequency` in stripes per unit length.
  frequencies({ stripes, frequency } = {}) {
    if (stripes !== undefined && frequency !== undefined) {
      fail("'stripes' and 'frequency' exclude each other");
    }
    if (frequency !== undefined && typeof frequency !== 'number') {
      return floats(frequency, this.vertexCount, "'frequency'");
    }
    const number = frequency ?? Math.fround(stripes ?? 40) / Math.fround(this.diagonal);
    if (!(number > 0 && Number.isFinite(number))) fail("'stripes' and 'frequency' must be above 0");
    return new Float32Array(this.vertexCount).fill(number);
  }

  stripes(field, given) {
    const o = options(given, stripeOptions, 'stripes');
    const directions = floats(field, 3 * this.vertexCount, 'the field');
    return new Pattern(this.#module, this.#module.stripes(this.raw, directions, this.frequencies(o), o));
  }

  texture(field, given) {
    const o = options(given, { ...stripeOptions, oriented: false }, 'texture');
    const directions = floats(field, 3 * this.vertexCount, 'the field');
    const frequency = this.frequencies(o)[0];
    if (o.frequency !== undefined && typeof o.frequency !== 'number') {
      fail("texture: 'frequency' must be one number");
    }
    return new Texture(this.#module.texture(this.raw, directions, frequency, o.oriented, o));
  }

  camera(given) {
    const o = options(given, { azimuth: 30, elevation: 20, zoom: 1, up: 'y', width: 800, height: 600 }, 'camera');
    choice(o.up, ['y', 'z'], 'up');
    if (Math.abs(o.elevation) > 90) fail('elevation must be from -90 to 90');
    if (!(o.zoom > 0 && o.width > 0 && o.height > 0)) fail('zoom, width and height must be above 0');
    return { ...this.raw.camera(o), width: o.width, height: o.height };
  }

  animator(given) {
    const o = options(given, { lambda: 0.025, cycles: 0, slack: 0 }, 'animator');
    return new Animator(this.#module.animator(this.raw, o), this);
  }
}

export class Pattern extends Owned {
  #module;
  constructor(module, raw) {
    super('Pattern', raw);
    this.#module = module;
    Object.assign(this, raw.figures());
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
  curves(given) {
    const o = options(given, { join: false, trim: 0 }, 'curves');
    return this.raw.curves(o.join, o.trim);
  }
  curvesFile(name, given) {
    const o = options(given, { join: false, trim: 0 }, 'curvesFile');
    return this.#module.curvesFile(this.raw, name, o.join, o.trim);
  }
  samplesWith(other) {
    return this.#module.samples(this.raw, other.raw);
  }
  svg(given) {
    const o = options(given, { rotation: [0, 0, 0, 1], zoom: 1, width: 800, height: 600 }, 'svg');
    return this.#module.drawing(this.raw, o.rotation, o.zoom, o.width, o.height);
  }
}

export class Texture extends Owned {
  constructor(raw) {
    super('Texture', raw);
    Object.assign(this, raw.figures());
  }
  waves() {
    return this.raw.waves();
  }
  triangleKinds() {
    return this.raw.kinds();
  }
  brokenTiles(tile) {
    return this.raw.brokenTiles(String(tile));
  }
  cornerUVs() {
    return this.raw.cornerUVs();
  }
  mesh() {
    return this.raw.mesh();
  }
  glb() {
    return writeGLB(this.mesh());
  }
}

export class Animator extends Owned {
  #surface;
  constructor(raw, surface) {
    super('Animator', raw);
    this.#surface = surface;
  }
  frame(given) {
    const o = options(given, { directions: undefined, frequencies: undefined, stripes: undefined,
                               frequency: undefined, positions: undefined, normals: undefined,
                               vertices: undefined, corners: undefined }, 'frame');
    const surface = this.#surface;
    const vectors = 3 * surface.vertexCount;
    const input = { directions: floats(o.directions, vectors, 'directions') };
    if (o.positions) input.positions = floats(o.positions, vectors, 'positions');
    if (o.normals) input.normals = floats(o.normals, vectors, 'normals');
    input.frequencies = o.frequencies
      ? floats(o.frequencies, surface.vertexCount, 'frequencies') : surface.frequencies(o);
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

const tileSide = 512;

class Brindle {
  #module;
  constructor(module) {
    this.#module = module;
    this.version = module.version();
  }

  shapes() {
    return this.#module.shapeNames();
  }
  tiles() {
    return this.#module.tileNames().split('|');
  }
  tile(name) {
    return { side: tileSide, distances: this.#module.tileDistances(String(name), tileSide) };
  }
  shape(spec) {
    return new Surface(this.#module, this.#module.surfaceFromShape(String(spec)));
  }
  surface({ positions, triangles }, given) {
    const o = options(given, { repair: false }, 'surface');
    return new Surface(this.#module, this.#module.surfaceFromArrays(
      table(positions, 'positions'), corners(triangles), o.repair));
  }
  readSurface(bytes, name) {
    const content = bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes;
    if (!(content instanceof Uint8Array)) fail('a file must be an ArrayBuffer or a Uint8Array');
    if (/\.gl(b|tf)$/i.test(name)) return this.surface(readGLB(content, name), { repair: true });
    return new Surface(this.#module, this.#module.surfaceFromFile(content, name));
  }
}

// What entries have in common: a module of these bytes, or of what `instantiateWasm` gives.
export async function brindleOf(how) {
  const module = await createModule({ ...how, BrindleError });
  return new Brindle(module);
}
