// The package in node: what its functions give, refuse and say. BRINDLE_PACKAGE is the package's folder.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { box, objOf } from './box.mjs';

const folder = process.env.BRINDLE_PACKAGE;
const load = (name) => import(pathToFileURL(join(folder, name)));
const { createBrindle, BrindleError } = await load('index.js');
const brindle = await createBrindle();

const square = { positions: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], triangles: [0, 1, 2, 0, 2, 3] };
const refused = (work, pattern) => assert.throws(work, (error) => error instanceof BrindleError && pattern.test(error.message));

test('the version is that of the package', () => {
  const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  assert.equal(brindle.version, version);
});

test('numbers of every type make the same surface', () => {
  const reference = brindle.surface(square);
  for (const Positions of [Array, Float32Array, Float64Array]) {
    for (const Corners of [Array, Int32Array, Uint32Array, Uint16Array, Uint8Array]) {
      const surface = brindle.surface({ positions: Positions.from(square.positions), triangles: Corners.from(square.triangles) });
      assert.deepEqual(surface.positions(), reference.positions());
      assert.deepEqual(surface.triangles(), reference.triangles());
      surface.dispose();
    }
  }
  assert.equal(reference.vertexCount, 4);
  assert.equal(reference.triangleCount, 2);
});

test('bad surfaces are refused by name, and repaired where that is asked for', () => {
  refused(() => brindle.surface({ ...square, triangles: [0, 1, 7] }), /corner 7/);
  refused(() => brindle.surface({ ...square, positions: [0, 0, NaN, 1, 0, 0, 1, 1, 0, 0, 1, 0] }), /vertex 0/);
  refused(() => brindle.surface({ ...square, triangles: [0, 1, 1.5] }), /whole/);
  refused(() => brindle.surface({ ...square, triangles: [0, 1] }), /row|three|column/);
  refused(() => brindle.surface({ positions: 'abc', triangles: [] }), /typed array/);
  refused(() => brindle.surface(square, { join: true }), /no option 'join'/);
  const twice = { positions: [...square.positions, 1, 0, 0], triangles: [0, 1, 2, 0, 2, 3, 0, 4, 2, 0, 0, 1] };
  const repaired = brindle.surface(twice, { repair: true });
  assert.equal(repaired.triangleCount, 2);
  assert.deepEqual([...repaired.vertexOfRow()], [0, 1, 2, 3, 1]);
  assert.ok(repaired.notes.length > 0);
});

test('files are read by the library, and damaged ones refused with name and line', () => {
  const read = (text, name) => brindle.readSurface(new TextEncoder().encode(text), name);
  const surface = read('v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n', 'square.obj');
  assert.equal(surface.triangleCount, 2);
  refused(() => read('v 0 0 0\nv 1 x 0\n', 'folder/bad.obj'), /^bad\.obj:2: /);
  refused(() => read('solid', 'bad.xyz'), /xyz/);
  refused(() => read('', 'empty.ply'), /empty/);
  refused(() => brindle.readSurface('text', 'a.obj'), /Uint8Array/);
});

test('numbers in files are read to the last bit', () => {
  const one = ['0.1', '1e-3', '1.17549435e-38', '-.5', '2.', '0.30000001192092896', '16777217', '0.100000001490116119384765625001'];
  const kept = `${one.map((n) => `v ${n} 0 0\n`).join('')}v 0 1 0\nv 0 0 1\nf 1 ${one.length + 1} ${one.length + 2}\n`;
  const positions = brindle.readSurface(new TextEncoder().encode(kept), 'numbers.obj').positions();
  one.forEach((n, i) => assert.equal(positions[3 * i], Math.fround(Number(n)), n));
});

test('a plane has straight stripes, as many as were asked for, and no branch', () => {
  const plane = brindle.shape('plane');
  const pattern = plane.stripes(plane.projectedField([1, 0, 0]), { stripes: 20 });
  assert.equal(pattern.branches, 0);
  assert.ok(pattern.energy < 1e-4);
  assert.ok(pattern.phases().every((c) => Math.abs(c) <= 1.0001));
  const frequency = pattern.frequencies()[0];
  assert.ok(Math.abs(frequency * plane.diagonal - 20) < 1e-4);
  const { points, offsets, closed, ends } = pattern.curves();
  assert.equal(ends.length, 2 * closed.length);
  assert.equal(offsets[closed.length], points.length / 3);
  for (let line = 0; line < closed.length; ++line) {
    for (let i = offsets[line]; i < offsets[line + 1]; ++i) {
      assert.ok(Math.abs(points[3 * i] - points[3 * offsets[line]]) < 0.02 / frequency);
    }
  }
});

test('options that are unknown, of another type or exclude each other are refused', () => {
  const torus = brindle.shape('torus,resolution=24');
  const field = torus.smoothField();
  refused(() => torus.stripes(field, { strips: 10 }), /no option 'strips'/);
  refused(() => torus.stripes(field, { slack: '1' }), /finite number/);
  refused(() => torus.stripes(field, { stripes: 10, frequency: 2 }), /exclude/);
  refused(() => torus.stripes(field, { spacing: 0.1, frequency: 10 }), /exclude/);
  refused(() => torus.stripes(field, { spacing: 0 }), /above 0/);
  refused(() => torus.stripes(field, { stripes: 0 }), /above 0/);
  refused(() => torus.stripes(field.slice(3)), /must have \d+ numbers/);
  refused(() => torus.stripes(field, { slack: -1 }), /slack/);
  refused(() => torus.smoothField({ symmetry: 0 }), /symmetry/);
  refused(() => torus.smoothField({ curvatureDirection: 'up' }), /max or min/);
  refused(() => brindle.shape('tours'), /torus/);
  refused(() => torus.smoothField({ strokes: [{ points: [0, 0, 0], radius: 1 }] }), /stroke/);
});

test('a spacing is the inverse of a frequency', () => {
  const torus = brindle.shape('torus,resolution=24');
  const phases = (options) => torus.stripes(torus.smoothField(), options).phases();
  assert.deepEqual(phases({ spacing: 0.08 }), phases({ frequency: 12.5 }));
});

test('what was disposed of says so, and disposing twice does no harm', () => {
  const torus = brindle.shape('torus,resolution=16');
  const pattern = torus.stripes(torus.smoothField());
  torus.dispose();
  torus.dispose();
  assert.ok(torus.isDisposed);
  refused(() => torus.positions(), /this surface was disposed of/);
  // A pattern keeps what it needs.
  assert.ok(pattern.curves().points.length > 0);
});

test('slack leaves fewer branches, and says how far frequencies went', () => {
  const vessels = brindle.shape('vessels,resolution=40');
  const field = vessels.projectedField([0.3, 1, 0.2]);
  const strict = vessels.stripes(field, { stripes: 40 });
  const slack = vessels.stripes(field, { stripes: 40, slack: 0.5 });
  assert.ok(slack.branches < strict.branches, `${slack.branches} of ${strict.branches}`);
  assert.ok(slack.frequencyChange.ratioMax > 1 && slack.frequencyChange.ratioMax < 1.8);
  assert.equal(slack.triangleKinds().filter((kind) => kind === 1 || kind === 2).length, slack.branches);
});

test('patterns and textures warn of stripes that are too fine, with a remedy', () => {
  const ball = brindle.shape('sphere,resolution=8'), field = ball.smoothField();
  for (const make of ['stripes', 'texture']) {
    assert.deepEqual(ball[make](field, { stripes: 4 }).warnings, [], make);
    const { warnings } = ball[make](field, { stripes: 200 });
    assert.equal(warnings.length, 1, make);
    assert.match(warnings[0], /% of the area; take fewer stripes, .*; or subdivide the mesh, times: 4$/);
    // In all, where the surface was subdivided already.
    const finer = ball.subdivided(1);
    assert.match(finer[make](finer.smoothField(), { stripes: 400 }).warnings[0], /times: 5$/);
  }
});

test('subdivided surfaces have four times the triangles, and the arrays of the file', () => {
  const file = brindle.readSurface(new TextEncoder().encode(objOf(box(2))), 'box.obj');
  const once = file.subdivided(1), twice = file.subdivided(2);
  assert.equal(once.triangleCount, 4 * file.triangleCount);
  assert.deepEqual(twice.positions(), once.subdivided(1).positions());
  assert.equal(file.subdivided(0).vertexCount, file.vertexCount);
  // Creases of a box stay: as many copies as at its corners and edges, finer.
  assert.ok(once.creaseVertices().length > file.creaseVertices().length && file.creaseVertices().length > 0);
  assert.ok(Math.abs(once.diagonal - file.diagonal) < 1e-6);
  for (const times of [-1, 0.5, 11, '2', undefined]) refused(() => file.subdivided(times), /subdivided: expected a whole number from 0 to 10/);
});

test('the same input gives the same bits', () => {
  const results = [0, 1].map(() => {
    const shape = brindle.shape('trefoil');
    return shape.stripes(shape.smoothField()).phases();
  });
  assert.deepEqual(results[0], results[1]);
});

test('a stroke turns the field along itself', () => {
  const plane = brindle.shape('plane');
  const stroke = { points: [-0.2, 0, 0, 0.2, 0, 0], radius: 0.3, strength: 50 };
  const positions = plane.positions();
  const flat = [0, 1, 2].find((axis) => positions.every((c, i) => i % 3 !== axis || c === 0));
  assert.notEqual(flat, 0);
  const field = plane.smoothField({ strokes: [stroke] });
  let nearest = 0;
  for (let i = 0; i < plane.vertexCount; ++i) {
    if (Math.hypot(...positions.slice(3 * i, 3 * i + 3)) < Math.hypot(...positions.slice(3 * nearest, 3 * nearest + 3))) nearest = i;
  }
  assert.ok(Math.abs(field[3 * nearest]) > 0.95);
});

test('surfaces far from zero keep their shape, and strokes their places', () => {
  const near = brindle.shape('sphere,resolution=16'), far = [5e6, -3e6, 2e6];
  const positions = Float64Array.from(near.positions(), (c, i) => c + far[i % 3]);
  const there = brindle.surface({ positions, triangles: near.triangles() });
  assert.ok(there.origin.some((c) => c !== 0));
  assert.ok(Math.abs(there.diagonal - near.diagonal) < 1e-6);
  const [x, y, z] = there.positions();
  const stroke = { points: [x, y, z, x + 0.05, y + 0.05, z], radius: 0.3, strength: 20 };
  assert.equal(there.smoothField({ strokes: [stroke] }).length, 3 * there.vertexCount);
  refused(() => there.smoothField({ strokes: [{ ...stroke, points: stroke.points.map((c, i) => c + far[i % 3]) }] }), /stroke/);
});

test('frames follow, and an unchanged frame says so', () => {
  const torus = brindle.shape('torus');
  const animator = torus.animator();
  const field = torus.smoothField();
  const first = animator.frame({ directions: field, stripes: 30 });
  assert.equal(animator.frame({ directions: field, stripes: 30 }).unchanged, true);
  const turned = animator.frame({ directions: torus.rotatedField(field, 2), stripes: 30 });
  assert.equal(turned.phases.length, first.phases.length);
  assert.ok(turned.phaseStep > 0 && turned.phaseStep < 1);
  assert.ok(animator.energy() > 0);
  refused(() => animator.frame({ directions: field.slice(3) }), /must have/);
});

test('frames are drawn as fresh patterns are, bit for bit, where vertices move', async () => {
  const { patternBuffers } = await load('draw.js');
  const torus = brindle.shape('torus,resolution=30'), triangles = torus.triangles(), rest = torus.positions();
  for (const slack of [0, 0.3]) {
    const animator = torus.animator({ slack });
    const vertices = new Float32Array(12 * torus.vertexCount);
    for (const step of [0, 1, 1, 2, 0]) {
      const positions = rest.map((c, i) => c * (1 + 0.05 * Math.sin(4 * rest[i - i % 3] + step)));
      const there = brindle.surface({ positions, triangles });
      const directions = there.projectedField([0.31, 0.9, 0.27]);
      const frame = animator.frame({ directions, positions, stripes: 14, vertices, corners: true });
      assert.equal(frame.vertices, vertices);
      const pattern = { directions, phases: frame.phases, frequencies: frame.frequencies ?? torus.frequencies({ stripes: 14 }) };
      assert.equal(frame.frequencies !== undefined, slack > 0);
      assert.deepEqual(vertices, patternBuffers({ positions, normals: there.normals(), triangles }, pattern).vertices);
      // A corner has its vertex's phase, or that of the same wave running the other way.
      assert.equal(frame.corners.length, triangles.length);
      const lifted = [...frame.corners.keys()].filter((corner) => !Number.isNaN(frame.corners[corner]));
      assert.ok(lifted.length > 0.9 * triangles.length);
      for (const corner of lifted) {
        const [re, im] = [Math.cos(frame.corners[corner]), Math.sin(frame.corners[corner])], vertex = 2 * triangles[corner];
        assert.ok(Math.abs(im - frame.phases[vertex + 1]) < 1e-4 && Math.abs(Math.abs(re) - Math.abs(frame.phases[vertex])) < 1e-4);
      }
      there.dispose();
    }
    animator.dispose();
  }
  const animator = torus.animator(), directions = torus.smoothField();
  assert.equal(animator.frame({ directions }).vertices, undefined);
  refused(() => animator.frame({ directions, vertices: new Float32Array(3) }), /vertices must be true or a Float32Array of/);
  refused(() => animator.frame({ directions, corners: [] }), /corners must be true/);
});

test('texture coordinates at corners and at vertices agree up to whole tiles', () => {
  const sphere = brindle.shape('sphere');
  const texture = sphere.texture(sphere.smoothField(), { stripes: 12 });
  const corners = texture.cornerUVs();
  assert.equal(corners.length, 6 * sphere.triangleCount);
  assert.ok(corners.some((c) => Number.isNaN(c)), 'a sphere has singularities');
  const mesh = texture.mesh();
  assert.equal(mesh.uvs.length / 2, mesh.positions.length / 3);
  assert.equal(mesh.normals.length, mesh.positions.length);
  const back = brindle.readSurface(texture.glb(), 'sphere.glb');
  assert.equal(back.triangleCount, mesh.triangles.length / 3);
  assert.ok(Math.abs(back.diagonal - sphere.diagonal) < 1e-5);
});

test('textures have what shaders draw, and metrics that branches cut', () => {
  assert.deepEqual(brindle.tiles().slice(0, 3), ['stripes', 'checker', 'dots']);
  const { side, distances } = brindle.tile('dots');
  assert.equal(distances.length, side * side);
  // A disc in the middle, as dark as its area.
  assert.ok(Math.abs(distances.filter((d) => d < 0).length / distances.length - Math.PI * 0.29 ** 2) < 0.001);
  assert.ok(distances[side / 2 * (side + 1)] < -0.28 && distances[0] > 0.4);
  refused(() => brindle.tile('stars'), /no tile 'stars'; there are stripes\|checker/);
  const sphere = brindle.shape('sphere,resolution=20');
  const texture = sphere.texture(sphere.smoothField(), { stripes: 12 });
  const { u, v } = texture.waves(), kinds = texture.triangleKinds();
  assert.equal(u.length, 18 * sphere.triangleCount);
  assert.equal(v.length, u.length);
  for (let corner = 0; corner < u.length; corner += 6) {
    // V runs across U, and phases are numbers of length 1, as at vertices.
    assert.ok(Math.abs(u[corner] * v[corner] + u[corner + 1] * v[corner + 1] + u[corner + 2] * v[corner + 2]) < 1e-5);
    assert.ok(Math.abs(Math.hypot(u[corner + 4], u[corner + 5]) - 1) < 1e-4);
  }
  assert.ok(texture.branches > 0 && kinds.some((kind) => kind === 1 || kind === 2));
  const { words, layout, split } = texture.brokenTiles('dots');
  assert.ok(words.length > sphere.triangleCount && layout === 0 && !split);
  assert.ok(words.subarray(0, sphere.triangleCount).some((word) => word === 0));
  assert.equal(texture.brokenTiles('checker').words.length, 0);
  assert.deepEqual([texture.brokenTiles('bricks').layout, texture.brokenTiles('bricks').split], [2, true]);
  refused(() => texture.brokenTiles('stars'), /no tile 'stars'/);
  refused(() => texture.brokenTiles(), /name a tile/);
  const dotted = sphere.texture(sphere.smoothField(), { stripes: 12, tile: 'dots' });
  assert.deepEqual([dotted.tile, dotted.brokenTiles()], ['dots', texture.brokenTiles('dots')]);
  refused(() => sphere.texture(sphere.smoothField(), { tile: 'stars' }), /tile must be stripes or checker/);
});

test('textures follow a field that turns, and stay as a frame has them', () => {
  const torus = brindle.shape('torus'), field = torus.smoothField();
  const solved = torus.texture(field, { stripes: 24 });
  const animator = torus.textureAnimator({ tile: 'dots' });
  animator.follow(solved);
  const first = animator.frame({ directions: field, stripes: 24 });
  // The mean angle between phases at corners that run the same way in both.
  const apart = (a, b) => {
    let sum = 0, count = 0;
    for (let i = 0; i < a.length; i += 6) {
      if (a[i] * b[i] + a[i + 1] * b[i + 1] + a[i + 2] * b[i + 2] < 0.5) continue;
      sum += Math.acos(Math.max(-1, Math.min(1, a[i + 4] * b[i + 4] + a[i + 5] * b[i + 5])));
      ++count;
    }
    return [sum / count, 6 * count / a.length];
  };
  const [step, alike] = apart(first.waves.u, solved.waves().u);
  assert.ok(step < 0.2 && alike > 0.4, `${step} of ${alike}`);
  assert.equal(animator.frame({ directions: field, stripes: 24 }).unchanged, true);
  const directions = torus.rotatedField(field, 2);
  const turned = animator.frame({ directions, stripes: 24 });
  assert.equal(turned.unchanged, false);
  const [moved, kept] = apart(turned.waves.u, first.waves.u);
  assert.ok(moved < 0.5 && kept > 0.99, `${moved} of ${kept}: triangles go on running as they ran`);
  const texture = animator.texture({ directions, stripes: 24 });
  assert.deepEqual(texture.waves(), turned.waves);
  assert.deepEqual(texture.triangleKinds(), turned.triangleKinds);
  assert.deepEqual(texture.brokenTiles('dots'), turned.broken);
  assert.deepEqual([texture.branches, texture.energy], [turned.branches, turned.energy]);
  assert.equal(texture.cornerUVs().length, 6 * torus.triangleCount);
  animator.restart();
  const afresh = animator.frame({ directions: field, stripes: 24 });
  assert.ok(Math.abs(afresh.energy - solved.energy) < 0.1 * solved.energy, `${afresh.energy} for ${solved.energy}`);
  refused(() => animator.frame({ directions, stripes: 24, positions: torus.positions() }), /need 'normals'/);
  refused(() => animator.frame({ directions, vertices: true }), /no option 'vertices'/);
  refused(() => torus.textureAnimator({ tile: 'stars' }), /no tile 'stars'/);
  refused(() => torus.textureAnimator({ lambda: -1 }), /lambda/);
  refused(() => animator.follow(brindle.shape('torus,resolution=16').texture(brindle.shape('torus,resolution=16').smoothField())), /phases/);
});

test('textures point along vectors, frame by frame, where vertices move', () => {
  const plane = brindle.shape('plane'), along = plane.projectedField([1, 0, 0]);
  const animator = plane.textureAnimator({ oriented: true });
  const normals = plane.normals(), rest = plane.positions();
  for (const [sense, step] of [[1, 0], [1, 1], [-1, 1]]) {
    const positions = rest.map((c) => c * (1 + 0.02 * step));
    const { waves, branches, broken } = animator.frame({ directions: along.map((c) => sense * c), positions, normals, stripes: 12 });
    assert.equal(branches, 0);
    assert.equal(broken.words.length, 0);
    for (let i = 0; i < waves.u.length; i += 6) assert.ok(Math.abs(waves.u[i] - sense) < 1e-5, 'U is that of the vectors');
  }
});

test('crosses: turned by a quarter they are the same, and their texture is drawn on a surface that fits', () => {
  const sphere = brindle.shape('sphere,resolution=30'), field = sphere.smoothField({ symmetry: 4 });
  const crosses = sphere.crosses(field, { stripes: 16 });
  const mixed = field.slice(), quarter = sphere.rotatedField(field, 90);
  for (let i = 0; i < mixed.length; ++i) if (Math.floor(i / 3) % 3 === 1) mixed[i] = quarter[i];
  const same = sphere.crosses(mixed, { stripes: 16 });
  assert.ok(Math.abs(same.energy - crosses.energy) < 1e-3, `${same.energy} for ${crosses.energy}`);
  const drawn = crosses.surface();
  // Eight singularities of a cross field on a sphere at least, a triangle each in the place of which there are three.
  assert.ok(drawn.triangleCount >= sphere.triangleCount + 16 && (drawn.triangleCount - sphere.triangleCount) % 2 === 0);
  assert.equal(crosses.waves().u.length, 18 * drawn.triangleCount);
  assert.equal(crosses.triangleKinds().length, drawn.triangleCount);
  assert.ok(crosses.brokenTiles('plus').words.length > 0 && crosses.branches > 0);
  assert.ok(crosses.mesh().positions.length >= 3 * drawn.vertexCount);
  refused(() => sphere.crosses(field, { oriented: true }), /no option 'oriented'/);
  const torus = brindle.shape('torus'), along = torus.projectedField([0, 0, 1]);
  assert.equal(torus.texture(along).surface().triangleCount, torus.triangleCount);
});

test("a camera is the tool's", () => {
  const sphere = brindle.shape('sphere,resolution=16');
  const { viewFromWorld, clipFromView, up, width, height } = sphere.camera({ azimuth: 90, elevation: 0, up: 'z', width: 300, height: 200 });
  assert.deepEqual([width, height, viewFromWorld.length, clipFromView.length], [300, 200, 16, 16]);
  // From -y and a quarter counter-clockwise: from +x, with z up.
  assert.ok(Math.abs(viewFromWorld[2] - 1) < 1e-6 && Math.abs(viewFromWorld[9] - 1) < 1e-6 && Math.abs(up[1] - 1) < 1e-6);
  assert.ok(sphere.camera({ zoom: 2 }).clipFromView[0] / sphere.camera().clipFromView[0] - 2 < 1e-6);
  const top = sphere.camera({ side: 'top', projection: 'orthographic' });
  assert.deepEqual(top.rotation, sphere.camera({ azimuth: 0, elevation: 90 }).rotation);
  assert.deepEqual([top.projection, top.clipFromView[15]], ['orthographic', 1]);
  assert.equal(sphere.camera().clipFromView[15], 0);
  refused(() => sphere.camera({ side: '30,20' }), /side must be one of front, back, left, right, top, bottom, not '30,20'/);
  refused(() => sphere.camera({ side: 'top', azimuth: 0 }), /side excludes azimuth and elevation/);
  refused(() => sphere.camera({ projection: 'flat' }), /projection must be perspective or orthographic, not 'flat'/);
  refused(() => sphere.camera({ elevation: 91 }), /elevation must be/);
  refused(() => sphere.camera({ up: 'w' }), /up must be one of x, y, z, -x, -y, -z, not 'w'/);
  refused(() => sphere.camera({ width: 0 }), /above 0/);
});

// A .glb of parts: each has attributes [array, type, componentType], corners, and its node's transform.
function glbOf(parts) {
  const json = { asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: parts.map((_, i) => i) }], nodes: [], meshes: [], accessors: [], bufferViews: [] };
  const blocks = [];
  let size = 0;
  const put = ([array, type, componentType, normalized = false]) => {
    const width = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type];
    json.bufferViews.push({ buffer: 0, byteOffset: size, byteLength: array.byteLength });
    json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType, normalized, count: array.length / width, type,
                          ...(type === 'VEC3' ? { min: [0, 0, 0], max: [1, 1, 1] } : {}) });
    blocks.push([size, array]);
    size += Math.ceil(array.byteLength / 4) * 4;
    return json.accessors.length - 1;
  };
  for (const { attributes, corners, node = {} } of parts) {
    json.nodes.push({ mesh: json.meshes.length, ...node });
    json.meshes.push({ primitives: [{ attributes: Object.fromEntries(Object.entries(attributes).map(([name, a]) => [name, put(a)])),
                                      indices: put([corners, 'SCALAR', 5125]) }] });
  }
  json.buffers = [{ byteLength: size }];
  const text = JSON.stringify(json), words = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
  const bytes = new Uint8Array(28 + words.length + size), view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, words.length, 0x4e4f534a].forEach((n, i) => view.setUint32(4 * i, n, true));
  bytes.set(words, 20);
  view.setUint32(20 + words.length, size, true);
  view.setUint32(24 + words.length, 0x004e4942, true);
  for (const [at, array] of blocks) bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), 28 + words.length + at);
  return bytes;
}

test('attributes of glTF are arrays, as the library reads them', () => {
  const f = (...numbers) => Float32Array.of(...numbers), corners = Uint32Array.of(0, 1, 2);
  const positions = [f(0, 0, 0, 1, 0, 0, 0, 1, 0), 'VEC3', 5126];
  const part = (more, node) => ({ attributes: { POSITION: positions, ...more }, corners, node });
  const first = { _FLOW: [f(1, 2, 3, 4, 5, 6, 7, 8, 9), 'VEC3', 5126], _Load: [Uint8Array.of(1, 2, 255), 'SCALAR', 5121, true],
                  TEXCOORD_0: [f(0, 0, 0.25, 1, 1, 0.75), 'VEC2', 5126], COLOR_0: [new Uint8Array(12).fill(7), 'VEC4', 5121, true],
                  NORMAL: [f(0, 0, 1, 0, 0, 1, 0.6, 0, 0.8), 'VEC3', 5126], JOINTS_0: [new Uint8Array(12), 'VEC4', 5121] };
  const one = brindle.readSurface(glbOf([part(first)]), 'one.glb');
  const names = (surface) => surface.arrays.map(({ name, of, components }) => `${name} ${of} ${components}`).sort();
  assert.deepEqual(names(one), ['Load points 1', 'color points 4', 'flow points 3', 'normal points 3', 'uv points 2']);
  assert.deepEqual([...one.array('flow')], [1, 2, 3, 4, 5, 6, 7, 8, 9]);
  assert.deepEqual([...one.array('Load')], [1, 2, 255]);
  assert.deepEqual([...one.array('uv')], [0, 1, 0.25, 0, 1, 0.25]);
  assert.equal(one.array('color')[11], 7);
  assert.deepEqual(one.arrayField('flow'), one.tangentField([1, 2, 3, 4, 5, 6, 7, 8, 9]));
  // Of several parts what all have; mirrored parts keep their outside.
  const second = { _FLOW: [f(9, 8, 7, 6, 5, 4, 3, 2, 1), 'VEC3', 5126], NORMAL: first.NORMAL };
  const both = brindle.readSurface(glbOf([part(first), part(second, { translation: [5, 0, 0], scale: [-2, 1, 1] })]), 'both.glb');
  assert.deepEqual(names(both), ['flow points 3', 'normal points 3']);
  assert.deepEqual([...both.array('flow').subarray(9)], [9, 8, 7, 6, 5, 4, 3, 2, 1]);
  assert.ok(both.normals().every((c, i) => Math.abs(c - (i % 3 === 2 ? 1 : 0)) < 1e-6), 'both face up');
  const [x, , z] = both.array('normal').subarray(15);
  assert.ok(Math.abs(x / z + 0.3 / 0.8) < 1e-5 && Math.abs(Math.hypot(x, z) - 1) < 1e-6, 'a normal leans less where x is wider');
  const short = part({ _FLOW: [f(1, 2, 3), 'VEC3', 5126] });
  refused(() => brindle.readSurface(glbOf([short]), 'short.glb'), /^short\.glb: has not a _FLOW for each vertex/);
});

test('damaged glTF is refused', () => {
  const sphere = brindle.shape('sphere,resolution=8');
  const glb = sphere.texture(sphere.smoothField(), { stripes: 5 }).glb();
  refused(() => brindle.readSurface(glb.slice(0, 200), 'cut.glb'), /^cut\.glb: .*export/);
  refused(() => brindle.readSurface(glb.slice(0, glb.length - 400), 'cut.glb'), /^cut\.glb: .*truncated/);
  refused(() => brindle.readSurface(new Uint8Array(100), 'no.glb'), /no binary glTF/);
});

test('samples of two patterns lie on the surface', () => {
  const sphere = brindle.shape('sphere');
  const field = sphere.projectedField([0, 0, 1]);
  const u = sphere.stripes(field, { stripes: 12 });
  const v = sphere.stripes(sphere.rotatedField(field, 90), { stripes: 12 });
  const { positions, normals } = u.samplesWith(v);
  assert.ok(positions.length > 60);
  for (let i = 0; i < positions.length; i += 3) {
    const along = positions[i] * normals[i] + positions[i + 1] * normals[i + 1] + positions[i + 2] * normals[i + 2];
    assert.ok(along > 0.9 * Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
  }
});

test('arrays of files are fields', () => {
  const text = `# vtk DataFile Version 3.0
data
ASCII
DATASET POLYDATA
POINTS 4 float
0 0 0  1 0 0  1 1 0  0 1 0
POLYGONS 2 8
3 0 1 2  3 0 2 3
CELL_DATA 2
SCALARS load double 1
LOOKUP_TABLE default
1 3
POINT_DATA 4
VECTORS flow float
2 0 1  0 3 0  nan nan nan  0 0 0
`;
  const surface = brindle.readSurface(new TextEncoder().encode(text), 'data.vtk');
  assert.deepEqual(surface.arrays, [{ name: 'flow', of: 'points', components: 3 }, { name: 'load', of: 'cells', components: 1 }]);
  const flow = surface.array('flow');
  assert.deepEqual([...flow.slice(0, 6)], [2, 0, 1, 0, 3, 0]);
  const field = surface.arrayField('flow');
  assert.deepEqual([...field], [1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]);
  assert.deepEqual(surface.arrayField('flow', { rotate: 90 }), surface.rotatedField(field, 90));
  const finer = surface.subdivided(1);
  assert.deepEqual([...finer.array('load')].slice(0, 4).map(Math.round), [2, 1, 2, 3]);
  assert.equal(finer.array('flow').length, 3 * finer.vertexCount);
  const load = surface.array('load');
  assert.deepEqual([load.length, load[1], load[3]], [4, 1, 3]);
  assert.ok(load[0] > 1 && load[0] < 3);
  refused(() => surface.array('wind'), /no array 'wind'; there are flow, load/);
  refused(() => surface.arrayField('load'), /load/);
  assert.deepEqual(brindle.shape('torus').arrays, []);
  refused(() => brindle.shape('torus').array('wind'), /there are none/);
});

test('vectors that face each other are lines, or cancel where they are oriented', () => {
  const text = `# vtk DataFile Version 3.0
data
ASCII
DATASET POLYDATA
POINTS 4 float
0 0 0  1 0 0  1 1 0  0 1 0
POLYGONS 2 8
3 0 1 2  3 0 2 3
CELL_DATA 2
VECTORS wind float
1 0 0  -1 0 0
`;
  const surface = brindle.readSurface(new TextEncoder().encode(text), 'wind.vtk');
  const [line, vector] = [false, true].map((oriented) => surface.arrayField('wind', { oriented }));
  assert.deepEqual(surface.arrayField('wind'), line);
  assert.ok(Math.abs(Math.abs(line[0]) - 1) < 1e-6, 'a line along x');
  assert.deepEqual([...vector.subarray(0, 3)], [0, 0, 0]);
  assert.deepEqual([...vector.subarray(3, 6)], [1, 0, 0]);
  refused(() => surface.arrayField('wind', { oriented: 1 }), /true or false/);
});

test('measured fields are filled and smoothed', () => {
  const torus = brindle.shape('torus');
  const vectors = torus.smoothField();
  for (let i = 0; i < 30; ++i) vectors[i] = NaN;
  const { directions, coherence } = torus.measuredField(vectors, { stripes: 20 });
  assert.equal(coherence.length, torus.vertexCount);
  assert.ok(Math.hypot(directions[0], directions[1], directions[2]) > 0.9);
});

test('curves and drawings are files of the library', () => {
  const torus = brindle.shape('torus');
  const pattern = torus.stripes(torus.smoothField(), { stripes: 15 });
  const obj = new TextDecoder().decode(pattern.curvesFile('obj'));
  assert.match(obj, /^v -?[\d.e+-]+ -?[\d.e+-]+ -?[\d.e+-]+$/m);
  assert.match(obj, /^l \d+ \d+/m);
  const svg = new TextDecoder().decode(pattern.svg({ camera: { width: 400, height: 300 } }));
  assert.match(svg, /<svg[^>]*400/);
  assert.match(svg, /<path/);
  // As the camera sees it: --camera's, or any rotation.
  const drawn = (camera) => new TextDecoder().decode(pattern.svg({ camera }));
  const camera = torus.camera({ azimuth: 70, elevation: -10, up: '-x', zoom: 2, width: 400, height: 300 });
  const { rotation, zoom, width, height } = camera;
  assert.equal(drawn(camera), drawn({ rotation: [...rotation], zoom, width, height }));
  assert.equal(drawn(torus.camera()), drawn(undefined));
  assert.notEqual(drawn(camera), drawn(torus.camera({ width, height })));
  assert.notEqual(drawn(camera), drawn({ ...camera, projection: 'orthographic' }));
  refused(() => pattern.svg({ camera: { azimuth: 70 } }), /camera of svg knows no option 'azimuth'/);
  refused(() => pattern.svg({ camera: { rotation: [1, 2] } }), /rotation must have 4 numbers/);
  for (const format of ['ply', 'vtp', 'csv']) assert.ok(pattern.curvesFile(format).length > 1000, format);
  for (const format of ['xyz', 'curves.obj', undefined]) refused(() => pattern.curvesFile(format), /format must be obj or ply or vtp or csv/);
});

/** By how much a curve turns at most of its points, radians. */
function typicalTurn({ points, offsets, closed }) {
  const turns = [];
  for (let line = 0; line < closed.length; ++line) {
    for (let i = offsets[line] + 1; i + 1 < offsets[line + 1]; ++i) {
      const way = (from, to) => [0, 1, 2].map((k) => points[3 * to + k] - points[3 * from + k]);
      const [a, b] = [way(i - 1, i), way(i, i + 1)];
      const dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      turns.push(Math.acos(Math.min(1, dot / (Math.hypot(...a) * Math.hypot(...b)))));
    }
  }
  return turns.sort((x, y) => x - y)[Math.floor(0.99 * turns.length)];
}

test('curves lose their kinks, and those that are joined run together', () => {
  const sphere = brindle.shape('sphere,resolution=12');
  const pattern = sphere.stripes(sphere.smoothField(), { stripes: 24 });
  const traced = pattern.curves();
  const faired = pattern.curves({ fair: 0.25 });
  assert.deepEqual(pattern.curves({ trim: 0.6 }), traced);
  assert.notDeepEqual(pattern.curves({ trim: 0 }).points, traced.points);
  assert.deepEqual(faired.closed, traced.closed);
  assert.ok(typicalTurn(faired) < 0.6 * typicalTurn(traced));
  assert.ok(pattern.curves({ join: true, fair: 0.25 }).points.length > 0);
  const drawn = (options) => new TextDecoder().decode(pattern.svg({ camera: { width: 400, height: 300 }, ...options }));
  assert.notEqual(drawn({ fair: 0.25 }), drawn({}));
  refused(() => pattern.curves({ fair: 2 }), /share of the spacing/);
  refused(() => pattern.curves({ join: true, trim: 0.6 }), /join/);
  refused(() => pattern.curves({ trim: '0.6' }), /trim/);
});

test('buffers for shaders have the layout of the library, and refuse what does not fit', async () => {
  const { patternBuffers } = await load('draw.js');
  const surface = { positions: [1, 2, 3], normals: [0, 0, 1], triangles: [0, 0, 0] };
  const pattern = { directions: [1, 0, 0], frequencies: [7], phases: [0.6, -0.8] };
  const { vertices, triangles } = patternBuffers(surface, pattern, Uint8Array.of(2));
  assert.deepEqual(vertices, Float32Array.of(1, 2, 3, 7, 1, 0, 0, 0.6, 0, 0, 1, -0.8));
  assert.deepEqual(triangles, Uint32Array.of(0, 0, 0, 2));
  refused(() => patternBuffers(surface, { ...pattern, phases: [1] }), /phases must have 2 numbers for 1 vertices, not 1/);
});

test('./slim takes bytes and compiled modules', async () => {
  const slim = await load('slim.js');
  const bytes = readFileSync(join(folder, 'brindle.wasm'));
  for (const wasm of [bytes, await WebAssembly.compile(bytes)]) {
    const library = await slim.createBrindle({ wasm });
    assert.equal(library.shape('torus').vertexCount, brindle.shape('torus').vertexCount);
  }
});

test('the worker gives the same results, in order, and its errors', async () => {
  const { serve } = await load('serve.js');
  const remote = await load('worker.js');
  const { port1, port2 } = new MessageChannel();
  serve(port1, createBrindle);
  const library = await remote.createBrindle({ worker: port2 });
  assert.equal(library.version, brindle.version);
  const there = await library.shape('trefoil'), here = brindle.shape('trefoil');
  assert.equal(there.vertexCount, here.vertexCount);
  assert.deepEqual(await there.creaseVertices(), here.creaseVertices());
  const field = here.smoothField();
  assert.deepEqual(await there.smoothField(), field);
  const pattern = await there.stripes(field, { stripes: 25 });
  assert.equal(pattern.energy, here.stripes(field, { stripes: 25 }).energy);
  const other = await there.stripes(await there.rotatedField(field, 90), { stripes: 25 });
  assert.ok((await pattern.samplesWith(other)).positions.length > 0);
  await assert.rejects(there.stripes(field, { strips: 1 }), (error) => error instanceof remote.BrindleError);
  await there.dispose();
  library.terminate();
  port1.close();
});
