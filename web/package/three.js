// Stripes on materials of three.js, for its WebGLRenderer. Any material with a colour works: light, shadows
// and fog stay three's own. The phase is computed per pixel by the library's own shaders.
import { BufferAttribute, BufferGeometry, Color, DataTexture, FloatType, NearestFilter, RGBAFormat,
         RGBAIntegerFormat, UnsignedIntType, Vector2, Vector3, Vector4 } from 'three';
import { patternBuffers } from './draw.js';
import { BrindleError } from './error.js';
import { patternFragment } from './shaders.js';

// three sets these two by name.
const fragment = patternFragment
  .replace('uniform mat4 view_from_world;', 'uniform mat4 modelViewMatrix;\n#define view_from_world modelViewMatrix')
  .replace('uniform mat4 clip_from_view;', 'uniform mat4 projectionMatrix;\n#define clip_from_view projectionMatrix');

const textureWidth = 2048;

function textureOf(numbers, format, type, internalFormat) {
  const height = Math.max(1, Math.ceil(numbers.length / (4 * textureWidth)));
  const padded = new numbers.constructor(4 * textureWidth * height);
  padded.set(numbers);
  const texture = new DataTexture(padded, textureWidth, height, format, type);
  texture.internalFormat = internalFormat;
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return texture;
}

// Materials whose shaders have the chunks that stripes are inserted into.
const painted = /^Mesh(Basic|Lambert|Matcap|Phong|Physical|Standard|Toon)Material$/;
const inserted = (text, place, added) => text.replace(place, `${place}\n${added}`);

// At seams, three's sines and cosines differ by rounding errors: points within a few millionths of the size
// are at one position.
function snapped(positions) {
  const largest = positions.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  const step = 2 ** (Math.ceil(Math.log2(largest)) - 20);
  return largest > 0 && Number.isFinite(step) ? positions.map((x) => Math.round(x / step) * step) : positions;
}

/** Input of `brindle.surface` from indexed or plain triangles; pass `repair: true` to join vertices. */
export function surfaceInput(geometry) {
  const position = geometry.getAttribute('position');
  if (!position) throw new BrindleError("the geometry has no attribute 'position'");
  const positions = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; ++i) positions.set([position.getX(i), position.getY(i), position.getZ(i)], 3 * i);
  const index = geometry.getIndex();
  const triangles = Uint32Array.from({ length: index ? index.count : position.count }, (_, i) => (index ? index.getX(i) : i));
  if (triangles.length % 3 !== 0) throw new BrindleError(`${triangles.length} corners are no list of triangles`);
  return { positions: snapped(positions), triangles };
}

// Frames may move its vertices.
const ownSurface = ({ positions, normals, triangles }) =>
  ({ positions: Float32Array.from(positions), normals: Float32Array.from(normals), triangles });

export class Stripes {
  #surface;
  #uniforms;

  /**
   * `surface` and `pattern` are arrays of Surface, Pattern and frames: positions, normals and
   * triangles; directions, frequencies and phases.
   */
  constructor(surface, pattern, { color = '#1c325a', width = 0.5 } = {}) {
    this.#surface = ownSurface(surface);
    const { vertices, triangles } = patternBuffers(surface, pattern);
    this.#uniforms = {
      pattern_vertices: { value: textureOf(vertices, RGBAFormat, FloatType, 'RGBA32F') },
      pattern_triangles: { value: textureOf(triangles, RGBAIntegerFormat, UnsignedIntType, 'RGBA32UI') },
      pattern_viewport: { value: new Vector4() },
      target_size: { value: new Vector2() },
      origin: { value: new Vector3() },
      smooth_normals: { value: true },
      stripe_color: { value: new Color(color) },
      stripe_width: { value: width },
    };
    /** Separate vertices for each triangle: shaders identify triangles by number. */
    this.geometry = new BufferGeometry();
    this.#fillGeometry();
  }

  get color() {
    return this.#uniforms.stripe_color.value;
  }
  get width() {
    return this.#uniforms.stripe_width.value;
  }
  set width(share) {
    this.#uniforms.stripe_width.value = share;
  }

  /** Another pattern of the same surface, such as a frame. `moved`: its changed positions and normals. */
  setPattern(pattern, moved = {}) {
    this.#surface = ownSurface({ ...this.#surface, ...moved });
    const texture = this.#uniforms.pattern_vertices.value;
    texture.image.data.set(patternBuffers({ ...this.#surface, triangles: [] }, pattern).vertices);
    texture.needsUpdate = true;
    if (moved.positions) this.#fillGeometry();
  }

  /** A frame's `vertices`: its pattern and its positions. */
  setVertices(vertices) {
    const { positions, normals } = this.#surface;
    if (vertices.length !== 4 * positions.length) {
      throw new BrindleError(`vertices must have ${4 * positions.length} numbers, not ${vertices.length}`);
    }
    const texture = this.#uniforms.pattern_vertices.value;
    texture.image.data.set(vertices);
    texture.needsUpdate = true;
    let moved = false;
    for (let i = 0; i < positions.length; ++i) {
      const from = 12 * Math.floor(i / 3) + i % 3;
      moved ||= positions[i] !== vertices[from];
      positions[i] = vertices[from];
      normals[i] = vertices[from + 8];
    }
    if (moved) this.#fillGeometry();
  }

  /** Adds stripes to a material, and returns it. Use it only with `geometry`. */
  paint(material) {
    if (!painted.test(material?.type)) {
      throw new BrindleError(`${material?.type ?? material} cannot take stripes; use one of three's materials of meshes, such as ` +
                             'MeshStandardMaterial, or put the shaders of brindle/shaders into your own');
    }
    const uniforms = this.#uniforms, before = { compile: material.onBeforeCompile, render: material.onBeforeRender };
    material.onBeforeCompile = function (shader, renderer) {
      before.compile.call(this, shader, renderer);
      Object.assign(shader.uniforms, uniforms);
      shader.vertexShader = `flat out uint pattern_triangle_here;\n${
        inserted(shader.vertexShader, '#include <begin_vertex>', 'pattern_triangle_here = uint(gl_VertexID) / 3u;')}`;
      shader.fragmentShader = inserted(shader.fragmentShader, '#include <color_fragment>', `{
  vec2 place = gl_FragCoord.xy - pattern_viewport.xy;
  diffuseColor.rgb = with_pattern(diffuseColor.rgb, surface_point(surface_triangle(pattern_triangle_here), place, place));
}`);
      shader.fragmentShader = shader.fragmentShader.replace('void main()', `precision highp usampler2D;
flat in uint pattern_triangle_here;
uniform vec4 pattern_viewport;
${fragment}
void main()`);
    };
    const key = material.customProgramCacheKey.bind(material);
    material.customProgramCacheKey = () => `brindle ${key()}`;
    material.onBeforeRender = function (renderer, ...others) {
      before.render?.call(this, renderer, ...others);
      const { x, y, z, w } = renderer.getCurrentViewport(uniforms.pattern_viewport.value);
      uniforms.pattern_viewport.value.set(x, y, z, w);
      uniforms.target_size.value.set(z, w);
    };
    return material;
  }

  /** Frees geometry and textures; dispose of materials yourself. */
  dispose() {
    this.geometry.dispose();
    this.#uniforms.pattern_vertices.value.dispose();
    this.#uniforms.pattern_triangles.value.dispose();
  }

  #fillGeometry() {
    const { triangles } = this.#surface;
    for (const [name, numbers] of [['position', this.#surface.positions], ['normal', this.#surface.normals]]) {
      let attribute = this.geometry.getAttribute(name);
      if (!attribute) {
        attribute = new BufferAttribute(new Float32Array(3 * triangles.length), 3);
        this.geometry.setAttribute(name, attribute);
      }
      for (let corner = 0; corner < triangles.length; ++corner) {
        for (let axis = 0; axis < 3; ++axis) attribute.array[3 * corner + axis] = numbers[3 * triangles[corner] + axis];
      }
      attribute.needsUpdate = true;
    }
    this.geometry.computeBoundingBox();
    this.geometry.computeBoundingSphere();
  }
}
