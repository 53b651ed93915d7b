// Binary glTF 2.0: reads the triangles of all meshes with the transforms of the scene's nodes, and writes a
// mesh with texture coordinates. Attributes become arrays as in the library's own reader. It is in JavaScript,
// because a JSON parser would add 60 kB to the module.
import { BrindleError } from './error.js';

const kinds = { 5120: Int8Array, 5121: Uint8Array, 5122: Int16Array, 5123: Uint16Array,
                5125: Uint32Array, 5126: Float32Array };
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function times(a, b) {
  const c = new Array(16);
  for (let i = 0; i < 16; ++i) {
    const row = i % 4, column = i - row;
    c[i] = a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] +
      a[row + 12] * b[column + 3];
  }
  return c;
}

function matrixOf(node) {
  if (node.matrix) return node.matrix;
  const [tx, ty, tz] = node.translation ?? [0, 0, 0];
  const [x, y, z, w] = node.rotation ?? [0, 0, 0, 1];
  const [sx, sy, sz] = node.scale ?? [1, 1, 1];
  return [sx * (1 - 2 * (y * y + z * z)), sx * 2 * (x * y + z * w), sx * 2 * (x * z - y * w), 0,
          sy * 2 * (x * y - z * w), sy * (1 - 2 * (x * x + z * z)), sy * 2 * (y * z + x * w), 0,
          sz * 2 * (x * z + y * w), sz * 2 * (y * z - x * w), sz * (1 - 2 * (x * x + y * y)), 0,
          tx, ty, tz, 1];
}

// Of the upper left 3 x 3 part of a matrix.
function determinant(m) {
  return m[0] * (m[5] * m[10] - m[9] * m[6]) - m[4] * (m[1] * m[10] - m[9] * m[2]) + m[8] * (m[1] * m[6] - m[5] * m[2]);
}

// The normal matrix: the inverse's transpose, up to a factor.
function cofactors(m) {
  const minor = (r, c) => {
    const [i, j] = [0, 1, 2].filter((k) => k !== r), [k, l] = [0, 1, 2].filter((n) => n !== c);
    return (m[i + 4 * k] * m[j + 4 * l] - m[i + 4 * l] * m[j + 4 * k]) * ((r + c) % 2 ? -1 : 1);
  };
  const sign = Math.sign(determinant(m)) || 1;
  return [0, 1, 2].map((row) => [0, 1, 2].map((column) => sign * minor(row, column)));
}

// The first three of every `width` numbers, transformed by three rows and normalised.
function turn(numbers, width, rows) {
  for (let i = 0; i < numbers.length; i += width) {
    const turned = rows.map((row) => row[0] * numbers[i] + row[1] * numbers[i + 1] + row[2] * numbers[i + 2]);
    const length = Math.hypot(...turned) || 1;
    turned.forEach((value, axis) => { numbers[i + axis] = value / length; });
  }
}

// "normal", "uv", "uv_1", or "speed" for "_SPEED": the format suggests upper case.
function arrayName(semantic) {
  for (const [prefix, name] of [['TEXCOORD_', 'uv'], ['COLOR_', 'color']]) {
    if (semantic.startsWith(prefix)) return semantic === `${prefix}0` ? name : `${name}_${semantic.slice(prefix.length)}`;
  }
  const name = semantic.replace(/^_/, '');
  return /[a-z]/.test(semantic) ? name : name.toLowerCase();
}

class Reader {
  constructor(bytes, name) {
    this.name = name;
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < 20 || view.getUint32(0, true) !== 0x46546c67) {
      this.fail('is no binary glTF; a .gltf must be exported as .glb');
    }
    if (view.getUint32(4, true) !== 2) this.fail('is glTF of another version than 2; export it again');
    const length = view.getUint32(12, true);
    if (20 + length > bytes.length) this.fail('ends too early: it is truncated; copy or export it again');
    try {
      this.json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
    } catch (error) {
      this.fail(`has damaged JSON: ${error.message}; export it again`);
    }
    const start = 28 + length;
    this.binary = bytes.subarray(Math.min(start, bytes.length));
    const unknown = (this.json.extensionsRequired ?? []).filter((e) => e !== 'KHR_mesh_quantization');
    if (unknown.length > 0) this.fail(`needs ${unknown.join(', ')}; export it without`);
  }

  fail(message) {
    throw new BrindleError(`${this.name}: ${message}`);
  }

  entry(list, number, what) {
    return this.json[list]?.[number] ?? this.fail(`names ${what} ${number}, which it has not; export it again`);
  }

  // All numbers of an accessor; normalised ones, or `most` as 1, are scaled.
  numbers(number, most) {
    const accessor = this.entry('accessors', number, 'accessor');
    const type = kinds[accessor.componentType], width = widths[accessor.type];
    if (!type || !width || accessor.sparse || accessor.bufferView === undefined) {
      this.fail(`has an accessor ${number} that is sparse or of an unknown type; export it without`);
    }
    const block = this.entry('bufferViews', accessor.bufferView, 'buffer view');
    if (this.entry('buffers', block.buffer, 'buffer').uri !== undefined) {
      this.fail('keeps data in other files; export it as one .glb');
    }
    const size = type.BYTES_PER_ELEMENT, stride = block.byteStride ?? size * width;
    const first = (block.byteOffset ?? 0) + (accessor.byteOffset ?? 0), { count } = accessor;
    if (first + stride * (count - 1) + size * width > this.binary.length) {
      this.fail('ends too early: it is truncated; copy or export it again');
    }
    const view = new DataView(this.binary.buffer, this.binary.byteOffset);
    const read = `get${type.name.replace('Array', '')}`;
    most ??= accessor.normalized ? this.largest(accessor) : 1;
    const result = new Float64Array(count * width);
    for (let i = 0; i < count; ++i) {
      for (let c = 0; c < width; ++c) {
        const value = view[read](first + i * stride + c * size, true);
        result[i * width + c] = most === 1 ? value : Math.max(value / most, -1);
      }
    }
    return result;
  }

  largest({ componentType }) {
    const { name, BYTES_PER_ELEMENT } = kinds[componentType];
    return name.startsWith('F') ? 1 : 2 ** (8 * BYTES_PER_ELEMENT - (name.startsWith('U') ? 0 : 1)) - 1;
  }

  // A primitive's vertex arrays, without positions and skinning data.
  arraysOf(attributes, count, matrix) {
    const arrays = new Map();
    for (const [semantic, number] of Object.entries(attributes)) {
      if (/^(POSITION$|JOINTS_|WEIGHTS_)/.test(semantic)) continue;
      const accessor = this.entry('accessors', number, 'accessor'), width = widths[accessor.type];
      if (!width || !kinds[accessor.componentType] || accessor.sparse) continue;
      // Columns of narrow integer matrices are padded; such arrays are left out.
      if (accessor.bufferView === undefined || (accessor.type.startsWith('MAT') && accessor.componentType !== 5126)) continue;
      const isDirection = semantic === 'NORMAL' || semantic === 'TANGENT', isPlace = semantic.startsWith('TEXCOORD_');
      const isAny = isPlace && (this.json.extensionsUsed ?? []).includes('KHR_mesh_quantization');
      const most = isAny ? undefined : isDirection || isPlace ? this.largest(accessor) : 1;
      const numbers = Float32Array.from(this.numbers(number, most), (value, i) => (isPlace && i % width === 1 ? 1 - value : value));
      if (numbers.length !== width * count) this.fail(`has not a ${semantic} for each vertex; export it again`);
      const columns = [0, 1, 2].map((row) => [0, 4, 8].map((column) => matrix[row + column]));
      if (isDirection && matrix !== identity) turn(numbers, width, semantic === 'NORMAL' ? cofactors(matrix) : columns);
      arrays.set(arrayName(semantic), { components: width, numbers: [numbers] });
    }
    return arrays;
  }

  // Those that all primitives have, with equal numbers of components.
  addArrays(arrays, result) {
    if (!result.arrays) {
      result.arrays = arrays;
      return;
    }
    for (const [name, array] of result.arrays) {
      const more = arrays.get(name);
      if (more?.components === array.components) array.numbers.push(...more.numbers);
      else result.arrays.delete(name);
    }
  }

  addPrimitive(primitive, matrix, result) {
    const mode = primitive.mode ?? 4;
    if (mode < 4) return;
    const places = this.numbers(primitive.attributes?.POSITION ?? this.fail('has a mesh without positions'));
    const first = result.positions.length / 3;
    for (let i = 0; i + 2 < places.length; i += 3) {
      for (let axis = 0; axis < 3; ++axis) {
        result.positions.push(matrix[axis] * places[i] + matrix[axis + 4] * places[i + 1] +
          matrix[axis + 8] * places[i + 2] + matrix[axis + 12]);
      }
    }
    this.addArrays(this.arraysOf(primitive.attributes, places.length / 3, matrix), result);
    const mirrored = determinant(matrix) < 0;
    const corners = primitive.indices === undefined ? Array.from({ length: places.length / 3 }, (_, i) => i)
      : this.numbers(primitive.indices);
    for (let i = 0; i + 2 < corners.length; i += mode === 4 ? 3 : 1) {
      const a = mode === 6 ? 0 : i, swap = (mode === 5 && i % 2 === 1) !== mirrored;
      result.triangles.push(first + corners[a], first + corners[swap ? i + 2 : i + 1],
                            first + corners[swap ? i + 1 : i + 2]);
    }
  }

  addNode(number, outer, result, above) {
    if (above.includes(number)) this.fail('has nodes that are their own parents; export it again');
    const node = this.entry('nodes', number, 'node');
    const matrix = times(outer, matrixOf(node));
    if (node.mesh !== undefined) {
      for (const primitive of this.entry('meshes', node.mesh, 'mesh').primitives ?? []) {
        this.addPrimitive(primitive, matrix, result);
      }
    }
    for (const child of node.children ?? []) this.addNode(child, matrix, result, [...above, number]);
  }
}

/** Positions, triangles and vertex arrays of a .glb's scene. */
export function readGLB(bytes, name = 'the file') {
  const reader = new Reader(bytes, name), { json } = reader;
  const result = { positions: [], triangles: [] };
  const scene = json.scenes?.[json.scene ?? 0];
  const children = new Set((json.nodes ?? []).flatMap((node) => node.children ?? []));
  const roots = scene?.nodes ?? (json.nodes ?? []).map((_, i) => i).filter((i) => !children.has(i));
  for (const root of roots) reader.addNode(root, identity, result, []);
  if (result.triangles.length === 0) reader.fail('has no triangles');
  const arrays = [...result.arrays].map(([of, { components, numbers }]) => {
    const all = new Float32Array(numbers.reduce((sum, part) => sum + part.length, 0));
    numbers.reduce((at, part) => (all.set(part, at), at + part.length), 0);
    return { name: of, components, numbers: all };
  });
  return { positions: Float64Array.from(result.positions), triangles: Uint32Array.from(result.triangles), arrays };
}

/** A mesh with texture coordinates (V upwards) as a .glb. */
export function writeGLB({ positions, normals, uvs, triangles }) {
  const flipped = uvs.map((value, i) => (i % 2 === 0 ? value : 1 - value));
  const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    lower[i % 3] = Math.min(lower[i % 3], value);
    upper[i % 3] = Math.max(upper[i % 3], value);
  });
  const parts = [[positions, 'VEC3', 3, 34962], [normals, 'VEC3', 3, 34962], [flipped, 'VEC2', 2, 34962],
                 [triangles, 'SCALAR', 1, 34963]];
  let offset = 0;
  const bufferViews = parts.map(([array, , , target]) => {
    const view = { buffer: 0, byteOffset: offset, byteLength: array.byteLength, target };
    offset += array.byteLength;
    return view;
  });
  const accessors = parts.map(([array, type, width], i) => ({
    bufferView: i, componentType: i === 3 ? 5125 : 5126, count: array.length / width, type,
    ...(i === 0 ? { min: lower, max: upper } : {}) }));
  const json = { asset: { version: '2.0', generator: 'brindle' }, scene: 0, scenes: [{ nodes: [0] }],
                 nodes: [{ mesh: 0 }],
                 meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3 }] }],
                 accessors, bufferViews, buffers: [{ byteLength: offset }] };
  let text = new TextEncoder().encode(JSON.stringify(json));
  const padded = new Uint8Array(Math.ceil(text.length / 4) * 4).fill(0x20);
  padded.set(text);
  text = padded;
  const bytes = new Uint8Array(28 + text.length + offset);
  const header = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, text.length, 0x4e4f534a].forEach((n, i) => header.setUint32(4 * i, n, true));
  bytes.set(text, 20);
  header.setUint32(20 + text.length, offset, true);
  header.setUint32(24 + text.length, 0x004e4942, true);
  parts.forEach(([array], i) => bytes.set(
    new Uint8Array(array.buffer, array.byteOffset, array.byteLength), 28 + text.length + bufferViews[i].byteOffset));
  return bytes;
}
