// The library on its full WebAssembly module: realtime.js, and files, shapes, curves, textures and
// measured fields.
import createModule from './module.js';
import { readGLB, writeGLB } from './glb.js';
import { choice, creased, fail, floats, options } from './checks.js';
import { BrindleError } from './error.js';
import { Brindle as RealtimeBrindle, frameInput, frameOptions, frequencyOptions, Owned, Pattern as RealtimePattern,
         stripeOptions, Surface as RealtimeSurface, turned } from './realtime.js';

export { BrindleError };
export { Animator } from './realtime.js';

const projections = ['perspective', 'orthographic'];
const isOrthographic = (projection) => choice(projection, projections, 'projection') === 'orthographic';

export class Surface extends RealtimeSurface {
  constructor(module, raw) {
    super(module, raw);
    this.arrays = module.arrays(raw);
  }

  array(name) {
    return this.module.array(this.raw, String(name));
  }
  arrayField(name, given) {
    const o = options(given, { rotate: 0, oriented: false }, 'arrayField');
    return turned(this, this.module.arrayField(this.raw, String(name), o.oriented), o.rotate);
  }
  subdivided(times) {
    if (!(Number.isInteger(times) && times >= 0 && times <= 10)) fail(`subdivided: expected a whole number from 0 to 10, got '${times}'`);
    return new Surface(this.module, this.module.subdivided(this.raw, times));
  }
  measuredField(vectors, given) {
    const o = options(given, { symmetry: 2, periods: 1, fill: 2, singularities: undefined,
                               confidence: undefined, ...frequencyOptions },
                      'measuredField');
    const field = floats(vectors, 3 * this.vertexCount, 'the field');
    return this.module.smoothedField(this.raw, field, this.frequencies(o), o);
  }
  texture(field, given) {
    const o = options(given, { ...stripeOptions, oriented: false, tile: undefined }, 'texture');
    const directions = floats(field, 3 * this.vertexCount, 'the field');
    const frequency = this.frequencies(o)[0];
    if (o.tile !== undefined) choice(o.tile, this.module.tileNames().split('|'), 'tile');
    if (o.frequency !== undefined && typeof o.frequency !== 'number') {
      fail("texture: 'frequency' must be one number");
    }
    return new Texture(this.module, this.module.texture(this.raw, directions, frequency, o.oriented, o), o.tile);
  }

  crosses(field, given) {
    const { lastPhases, ...known } = stripeOptions;
    const o = options(given, known, 'crosses'), directions = floats(field, 3 * this.vertexCount, 'the field');
    return new Texture(this.module, this.module.crosses(this.raw, directions, this.frequencies(o), o));
  }

  textureAnimator(given) {
    const o = options(given, { lambda: 0.025, cycles: 0, slack: 0, oriented: false, tile: '' }, 'textureAnimator');
    return new TextureAnimator(this.module, this.module.textureAnimator(this.raw, { ...o, tile: String(o.tile) }), this);
  }

  camera(given) {
    const o = options(given, { azimuth: 30, elevation: 20, side: '', zoom: 1, projection: projections[0], up: 'y', width: 800, height: 600 },
      'camera');
    if (o.side !== '' && (given.azimuth ?? given.elevation) !== undefined) fail('side excludes azimuth and elevation');
    if (Math.abs(o.elevation) > 90) fail('elevation must be from -90 to 90');
    if (!(o.zoom > 0 && o.width > 0 && o.height > 0)) fail('zoom, width and height must be above 0');
    const orthographic = isOrthographic(o.projection);
    const seen = this.module.camera(this.raw, { ...o, side: String(o.side), up: String(o.up), orthographic });
    return { ...seen, zoom: o.zoom, projection: o.projection, width: o.width, height: o.height };
  }

  patternOf(raw) {
    return new Pattern(this.module, raw);
  }
}

// Camera results; drawings need only the last five.
const seen = { viewFromWorld: undefined, clipFromView: undefined, up: undefined, rotation: undefined, zoom: 1,
  projection: projections[0], width: 800, height: 600 };
const curveOptions = { join: false, trim: NaN, fair: 0 };  // NaN: as the library has it

export class Pattern extends RealtimePattern {
  curves(given) {
    const o = options(given, curveOptions, 'curves');
    return this.module.curves(this.raw, o.join, o.trim, o.fair);
  }
  curvesFile(format, given) {
    const o = options(given, curveOptions, 'curvesFile');
    return this.module.curvesFile(this.raw, choice(format, ['obj', 'ply', 'vtp', 'csv'], 'format'), o.join, o.trim, o.fair);
  }
  samplesWith(other) {
    return this.module.samples(this.raw, other.raw);
  }
  svg(given) {
    const o = options(given, { camera: undefined, ...curveOptions }, 'svg');
    const { rotation, zoom, projection, width, height } = options(o.camera, seen, 'camera of svg');
    const turn = rotation && floats(rotation, 4, 'rotation');
    return this.module.drawing(this.raw, turn, zoom, isOrthographic(projection), width, height, o.join, o.trim, o.fair);
  }
}

export class Texture extends Owned {
  constructor(module, raw, tile) {
    super('Texture', module, raw);
    Object.assign(this, raw.metrics());
    this.warnings = raw.warnings();
    this.tile = tile;
  }
  surface() {
    return new Surface(this.module, this.raw.surface());
  }
  waves() {
    return this.raw.waves();
  }
  triangleKinds() {
    return this.raw.kinds();
  }
  brokenTiles(tile = this.tile ?? fail("name a tile, or give 'tile' to texture")) {
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

export class TextureAnimator extends Owned {
  #surface;
  constructor(module, raw, surface) {
    super('TextureAnimator', module, raw);
    this.#surface = surface;
  }
  frame(given) {
    const o = options(given, frameOptions, 'frame');
    if (o.positions && !o.normals) fail("'positions' of a texture's frame need 'normals', about which V is turned");
    return this.raw.frame(frameInput(this.#surface, o));
  }
  texture(given) {
    const { positions, normals, ...known } = frameOptions;
    return new Texture(this.module, this.raw.texture(frameInput(this.#surface, options(given, known, 'texture'))));
  }
  follow(texture) {
    this.raw.follow(texture.raw);
  }
  restart() {
    this.raw.restart();
  }
}

const tileSide = 512;
const creaseOption = { creaseAngle: 40 };

class Brindle extends RealtimeBrindle {
  shapes() {
    return this.module.shapeNames();
  }
  tiles() {
    return this.module.tileNames().split('|');
  }
  tile(name) {
    return { side: tileSide, distances: this.module.tileDistances(String(name), tileSide) };
  }
  shape(spec, given) {
    const { creaseAngle } = creased(options(given, creaseOption, 'shape'));
    return this.surfaceOf(this.module.surfaceFromShape(String(spec), creaseAngle));
  }
  surfaceOf(raw) {
    return new Surface(this.module, raw);
  }
  readSurface(bytes, name, given) {
    const { creaseAngle } = creased(options(given, creaseOption, 'readSurface'));
    const content = bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes;
    if (!(content instanceof Uint8Array)) fail('a file must be an ArrayBuffer or a Uint8Array');
    if (/\.gl(b|tf)$/i.test(name)) {
      const { positions, triangles, arrays } = readGLB(content, name);
      const raw = this.rawSurface(positions, triangles, { repair: true, creaseAngle });
      for (const { name: of, components, numbers } of arrays) this.module.addArray(raw, of, components, numbers);
      return this.surfaceOf(raw);
    }
    return this.surfaceOf(this.module.surfaceFromFile(content, name, creaseAngle));
  }
}

// Common to all entries: a module of these bytes, or from `instantiateWasm`.
export async function brindleOf(how) {
  const module = await createModule({ ...how, BrindleError });
  return new Brindle(module);
}
