// Draws stripes and textures in your WebGL 2 context by the library's own shaders. The phase is computed per
// pixel, so that stripes are sharp at any zoom, also at branches. Data are in two textures, in the layout of
// the library's pattern_buffers.h.
import { BrindleError } from './error.js';
import { marksFragment, marksVertex, stripesFragment, stripesVertex, textureFragment } from './shaders.js';

const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
/** sRGB values of '#1c325a', from 0 to 1. */
export const colorOf = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

function compiled(gl, kind, source) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  return shader;
}

class Program {
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = gl.createProgram();
    const shaders = [compiled(gl, gl.VERTEX_SHADER, vertex), compiled(gl, gl.FRAGMENT_SHADER, fragment)];
    shaders.forEach((shader) => gl.attachShader(this.program, shader));
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) {
      throw new BrindleError(`the driver does not take the shaders: ${
        [gl.getProgramInfoLog(this.program), ...shaders.map((s) => gl.getShaderInfoLog(s))].join(' ')}`);
    }
    shaders.forEach((shader) => gl.deleteShader(shader));
    this.places = new Map();
  }
  place(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }
}

/**
 * Twelve numbers a vertex (x, y, z, frequency; direction, cosine of the phase; normal, its sine) and four a
 * triangle (vertices, kind): what the shaders read.
 */
export function patternBuffers({ positions, normals, triangles }, { directions, frequencies, phases }, kinds) {
  const count = positions.length / 3;
  const sizes = { normals: [normals, 3], directions: [directions, 3], frequencies: [frequencies, 1], phases: [phases, 2] };
  for (const [name, [numbers, width]] of Object.entries(sizes)) {
    if (numbers.length !== width * count) {
      throw new BrindleError(`${name} must have ${width * count} numbers for ${count} vertices, not ${numbers.length}`);
    }
  }
  const vertices = new Float32Array(12 * count);
  for (let i = 0; i < count; ++i) {
    for (let axis = 0; axis < 3; ++axis) {
      vertices[12 * i + axis] = positions[3 * i + axis];
      vertices[12 * i + 4 + axis] = directions[3 * i + axis];
      vertices[12 * i + 8 + axis] = normals[3 * i + axis];
    }
    vertices[12 * i + 3] = frequencies[i];
    vertices[12 * i + 7] = phases[2 * i];
    vertices[12 * i + 11] = phases[2 * i + 1];
  }
  return { vertices, triangles: triangleBuffer(triangles, kinds) };
}

function triangleBuffer(triangles, kinds) {
  const count = triangles.length / 3, numbers = new Uint32Array(4 * count);
  for (let t = 0; t < count; ++t) {
    for (let m = 0; m < 3; ++m) numbers[4 * t + m] = triangles[3 * t + m];
    numbers[4 * t + 3] = kinds?.[t] ?? 0;
  }
  return numbers;
}

// Format, number type and numbers per texel of every texture.
const layouts = (gl) => ({
  pattern_vertices: [gl.RGBA32F, gl.RGBA, gl.FLOAT, 4],
  pattern_triangles: [gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, 4],
  texture_u: [gl.RG32F, gl.RG, gl.FLOAT, 2],
  texture_v: [gl.RG32F, gl.RG, gl.FLOAT, 2],
  broken_words: [gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, 1],
  marks: [gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, 1],
});

export class StripeDrawing {
  /** Throws BrindleError if the driver rejects the shaders. */
  constructor(gl) {
    this.gl = gl;
    this.stripes = new Program(gl, stripesVertex, stripesFragment);
    this.marks = new Program(gl, marksVertex, marksFragment);
    this.layouts = layouts(gl);
    this.textures = {};
    this.triangleCount = 0;
    this.markCount = 0;
    this.center = [0, 0, 0];
    this.nothing = gl.createVertexArray();
    this.largest = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    this.rowLength = Math.min(this.largest, 4096);
  }

  #upload(name, numbers) {
    const { gl, rowLength } = this;
    const [inside, format, type, width] = this.layouts[name];
    const count = numbers.length / width, rows = Math.max(1, Math.ceil(count / rowLength));
    if (rows > this.largest) {
      throw new BrindleError(`the graphics card takes ${Math.floor(this.largest * rowLength / 3)} vertices at most; use a smaller mesh`);
    }
    let texture = this.textures[name];
    if (texture?.rows !== rows) {
      if (texture) gl.deleteTexture(texture.id);
      texture = this.textures[name] = { id: gl.createTexture(), rows };
      gl.bindTexture(gl.TEXTURE_2D, texture.id);
      gl.texStorage2D(gl.TEXTURE_2D, 1, inside, rowLength, rows);
      for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
        gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
      }
    }
    gl.bindTexture(gl.TEXTURE_2D, texture.id);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const whole = Math.floor(count / rowLength), rest = count - whole * rowLength;
    if (whole > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rowLength, whole, format, type, numbers);
    if (rest > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, whole, rest, 1, format, type, numbers, whole * rowLength * width);
  }

  /** Three numbers per vertex and per triangle, from `Surface`. */
  setSurface({ positions, normals, triangles }) {
    const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
    for (const vertex of triangles) {
      for (let axis = 0; axis < 3; ++axis) {
        const value = positions[3 * vertex + axis];
        if (value < lower[axis]) lower[axis] = value;
        if (value > upper[axis]) upper[axis] = value;
      }
    }
    this.center = lower.map((l, axis) => (l + upper[axis]) / 2);
    this.surface = { positions, normals, triangles };
    this.pattern = null;
    this.hasVertices = false;
    this.tile = null;
    this.triangleCount = triangles.length / 3;
    this.setKinds(new Uint8Array(this.triangleCount));
  }

  /** Directions (three numbers per vertex), frequencies (one), phases (two), from `Pattern`. */
  setPattern({ directions, frequencies, phases }) {
    this.pattern = { directions, frequencies, phases };
    this.setVertices(patternBuffers({ ...this.surface, triangles: [] }, this.pattern).vertices);
  }

  /** A frame's `vertices`: its pattern and its positions. */
  setVertices(vertices) {
    const count = 4 * this.surface.positions.length;
    if (vertices.length !== count) throw new BrindleError(`vertices must have ${count} numbers, not ${vertices.length}`);
    this.#upload('pattern_vertices', vertices);
    this.hasVertices = true;
    this.tile = null;
  }

  /**
   * A texture instead of stripes, until a pattern is set: `Texture.waves()`, `brindle.tile(name)`, `Texture.brokenTiles(name)`, or a frame's
   * `waves` and `broken`, with moved positions and normals.
   */
  setTexture({ u, v }, tile, broken, { positions = this.surface.positions, normals = this.surface.normals } = {}) {
    const { words = new Uint32Array(0), layout = 0, split = false } = broken ?? {};
    const { triangles } = this.surface, count = this.surface.positions.length / 3;
    for (const [name, numbers] of [['u', u], ['v', v]]) {
      if (numbers.length !== 6 * triangles.length) {
        throw new BrindleError(`${name} must have ${6 * triangles.length} numbers for ${triangles.length / 3} triangles, not ${numbers.length}`);
      }
    }
    if (words.length > 0 && words.length < triangles.length / 3) throw new BrindleError('the broken tiles are those of another surface');
    this.texture ??= new Program(this.gl, stripesVertex, textureFragment);
    // Positions and normals only; waves are per corner.
    this.setVertices(patternBuffers({ positions, normals, triangles: [] }, { directions: new Float32Array(3 * count),
      frequencies: new Float32Array(count), phases: new Float32Array(2 * count) }).vertices);
    this.#upload('texture_u', u);
    this.#upload('texture_v', v);
    this.#upload('broken_words', words);
    if (this.uploadedTile !== tile.distances) this.#uploadTile(tile);
    this.tile = { has_broken_tiles: words.length > 0, tile_layout: layout, splits_broken_tiles: split, tile_is_motif: true, wave_count: 2 };
  }

  // Distances, and the motif's coverage of each texel, with mipmaps.
  #uploadTile({ side, distances }) {
    const { gl } = this;
    this.uploadedTile = distances;
    const covered = Uint8Array.from(distances, (d) => Math.round(255 * Math.min(1, Math.max(0, 0.5 - side * d))));
    for (const [name, inside, type, numbers, smallest] of [['tile_distances', gl.R16F, gl.FLOAT, distances, gl.LINEAR],
                                                           ['tile_colors', gl.R8, gl.UNSIGNED_BYTE, covered, gl.LINEAR_MIPMAP_LINEAR]]) {
      this.textures[name] ??= { id: gl.createTexture() };
      gl.bindTexture(gl.TEXTURE_2D, this.textures[name].id);
      gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
      gl.texImage2D(gl.TEXTURE_2D, 0, inside, side, side, 0, gl.RED, type, numbers);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, smallest);
      for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.REPEAT);
      if (smallest !== gl.LINEAR) gl.generateMipmap(gl.TEXTURE_2D);
    }
  }

  setPhases(phases) {
    this.setPattern({ ...this.pattern, phases });
  }

  /** From `Pattern.triangleKinds()`; branches and singularities get marks. */
  setKinds(kinds) {
    const marked = [];
    kinds.forEach((kind, t) => {
      if (kind === 1 || kind === 2) marked.push(t);
    });
    this.#upload('pattern_triangles', triangleBuffer(this.surface.triangles, kinds));
    this.#upload('marks', Uint32Array.from(marked));
    this.markCount = marked.length;
  }

  /**
   * Draws into the bound target, `width` x `height` pixels. Matrices are column-major; `viewFromWorld` is for
   * positions relative to `center`. Colours are sRGB.
   */
  draw({ viewFromWorld, clipFromView, width, height, up = [0, 1, 0], stripeWidth = 0.5,
         baseColor = colorOf('#f4efe5'), stripeColor = colorOf('#1c325a'),
         branches = false, branchColor = colorOf('#d1352b'), singularColor = colorOf('#f0a202'), markSize = 10 }) {
    const { gl, marks } = this, surface = this.tile ? this.texture : this.stripes;
    if (this.triangleCount === 0 || !this.hasVertices) return;
    gl.viewport(0, 0, width, height);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(this.nothing);
    this.#use(surface, viewFromWorld, clipFromView);
    for (const [name, value] of Object.entries(this.tile ?? {})) gl.uniform1i(surface.place(name), Number(value));
    gl.uniform2f(surface.place('target_size'), width, height);
    gl.uniform1i(surface.place('smooth_normals'), 1);
    gl.uniform3fv(surface.place('base_color'), baseColor.map(linear));
    gl.uniform3fv(surface.place('stripe_color'), stripeColor.map(linear));
    gl.uniform3fv(surface.place('branch_color'), branchColor.map(linear));
    gl.uniform3fv(surface.place('singular_color'), singularColor.map(linear));
    gl.uniform1f(surface.place('stripe_width'), stripeWidth);
    gl.uniform1i(surface.place('branches'), branches ? 1 : 0);
    gl.uniform3fv(surface.place('up'), up);
    gl.drawArrays(gl.TRIANGLES, 0, 3 * this.triangleCount);
    if (!branches || this.markCount === 0) return;
    this.#use(marks, viewFromWorld, clipFromView);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.uniform1f(marks.place('mark_size'), markSize);
    gl.uniform3fv(marks.place('branch_color'), branchColor);
    gl.uniform3fv(marks.place('singular_color'), singularColor);
    gl.drawArrays(gl.POINTS, 0, this.markCount);
    gl.disable(gl.BLEND);
  }

  #use(program, viewFromWorld, clipFromView) {
    const { gl } = this;
    gl.useProgram(program.program);
    Object.entries(this.textures).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture.id);
      gl.uniform1i(program.place(name), unit);
    });
    gl.activeTexture(gl.TEXTURE0 + 15);
    gl.uniformMatrix4fv(program.place('view_from_world'), false, viewFromWorld);
    gl.uniformMatrix4fv(program.place('clip_from_view'), false, clipFromView);
    gl.uniform3fv(program.place('origin'), this.center);
  }

  /** Frees textures and programs. */
  dispose() {
    const { gl } = this;
    Object.values(this.textures).forEach(({ id }) => gl.deleteTexture(id));
    [this.stripes, this.marks, this.texture].forEach((made) => made && gl.deleteProgram(made.program));
    gl.deleteVertexArray(this.nothing);
    this.textures = {};
  }
}
