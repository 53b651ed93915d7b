// Stripes in a WebGL 2 context of yours, by the library's own shaders: the phase is computed at every
// pixel, so that stripes are clean at every zoom and at branches, too. No vertex buffers: what is
// drawn is in textures.
import { BrindleError } from './error.js';
import { marksFragment, marksVertex, stripesFragment, stripesVertex } from './shaders.js';

const rowLength = 2048;

const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
/** Red, green and blue of '#1c325a', from 0 to 1 as they are shown. */
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

// Format, kind of number and numbers a texel of every texture.
const layouts = (gl) => ({
  positions: [gl.RGB32F, gl.RGB, gl.FLOAT, 3, Float32Array],
  normals: [gl.RGB32F, gl.RGB, gl.FLOAT, 3, Float32Array],
  waves: [gl.RGBA32F, gl.RGBA, gl.FLOAT, 4, Float32Array],
  phases: [gl.RG32F, gl.RG, gl.FLOAT, 2, Float32Array],
  triangle_vertices: [gl.RGB32UI, gl.RGB_INTEGER, gl.UNSIGNED_INT, 3, Uint32Array],
  triangle_kinds: [gl.R8UI, gl.RED_INTEGER, gl.UNSIGNED_BYTE, 1, Uint8Array],
  marks: [gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, 1, Uint32Array],
});

export class StripeDrawing {
  /** Throws BrindleError if the driver does not take the shaders. */
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
  }

  #upload(name, numbers) {
    const { gl } = this;
    const [inside, format, type, width, List] = this.layouts[name];
    const count = numbers.length / width, rows = Math.max(1, Math.ceil(count / rowLength));
    if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE)) {
      throw new BrindleError(`the graphics card takes ${gl.getParameter(gl.MAX_TEXTURE_SIZE) * rowLength
        } triangles at most; use a smaller mesh`);
    }
    const padded = new List(rows * rowLength * width);
    padded.set(numbers);
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
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rowLength, rows, format, type, padded);
  }

  /** Three numbers a vertex and a triangle each, as `Surface` gives them. */
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
    this.#upload('positions', positions);
    this.#upload('normals', normals);
    this.#upload('triangle_vertices', triangles);
    this.triangleCount = triangles.length / 3;
    this.setKinds(new Uint8Array(this.triangleCount));
  }

  /** Directions (three numbers a vertex), frequencies (one), phases (two), as `Pattern` gives them. */
  setPattern({ directions, frequencies, phases }) {
    const waves = new Float32Array(4 * frequencies.length);
    for (let i = 0; i < frequencies.length; ++i) {
      waves[4 * i] = directions[3 * i];
      waves[4 * i + 1] = directions[3 * i + 1];
      waves[4 * i + 2] = directions[3 * i + 2];
      waves[4 * i + 3] = frequencies[i];
    }
    this.#upload('waves', waves);
    this.setPhases(phases);
  }

  setPhases(phases) {
    this.#upload('phases', phases);
  }

  /** What `Pattern.triangleKinds()` gives; branches and singularities get marks. */
  setKinds(kinds) {
    const marked = [];
    kinds.forEach((kind, t) => {
      if (kind === 1 || kind === 2) marked.push(t);
    });
    this.#upload('triangle_kinds', kinds);
    this.#upload('marks', Uint32Array.from(marked));
    this.markCount = marked.length;
  }

  /**
   * Draws into what is bound, `width` x `height` pixels. Matrices are in columns; `viewFromWorld` is of
   * positions less `center`. Colours are as they are shown.
   */
  draw({ viewFromWorld, clipFromView, width, height, up = [0, 1, 0], stripeWidth = 0.5,
         baseColor = colorOf('#f4efe5'), stripeColor = colorOf('#1c325a'),
         branches = false, branchColor = colorOf('#d1352b'), singularColor = colorOf('#f0a202'), markSize = 10 }) {
    const { gl, stripes, marks } = this;
    if (this.triangleCount === 0 || !this.textures.phases) return;
    gl.viewport(0, 0, width, height);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(this.nothing);
    this.#use(stripes, viewFromWorld, clipFromView);
    gl.uniform4f(stripes.place('tile'), 1, 1, 0, 0);
    gl.uniform2f(stripes.place('target_size'), width, height);
    gl.uniform1i(stripes.place('smooth_normals'), 1);
    gl.uniform3fv(stripes.place('base_color'), baseColor.map(linear));
    gl.uniform3fv(stripes.place('stripe_color'), stripeColor.map(linear));
    gl.uniform3fv(stripes.place('branch_color'), branchColor.map(linear));
    gl.uniform3fv(stripes.place('singular_color'), singularColor.map(linear));
    gl.uniform1f(stripes.place('stripe_width'), stripeWidth);
    gl.uniform1i(stripes.place('branches'), branches ? 1 : 0);
    gl.uniform3fv(stripes.place('up'), up);
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

  /** Gives textures and programs back. */
  dispose() {
    const { gl } = this;
    Object.values(this.textures).forEach(({ id }) => gl.deleteTexture(id));
    [this.stripes, this.marks].forEach(({ program }) => gl.deleteProgram(program));
    gl.deleteVertexArray(this.nothing);
    this.textures = {};
  }
}
