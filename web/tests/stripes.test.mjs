// The small module of stripes in real time: the bits of the whole one. BRINDLE_PACKAGE is the package's folder.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

const folder = process.env.BRINDLE_PACKAGE;
const load = (name) => import(pathToFileURL(join(folder, name)));
const whole = await (await load('index.js')).createBrindle();
const { createBrindle, BrindleError } = await load('stripes.js');
const small = await createBrindle();

// A surface of both.
function both(spec) {
  const shape = whole.shape(spec), arrays = { positions: shape.positions(), triangles: shape.triangles() };
  return [whole, small].map((library) => library.surface(arrays));
}
const pair = (of, work) => of.map((surface, i) => work(surface, i));
const same = ([a, b]) => assert.deepEqual(b, a);

test('its version is that of the whole', () => assert.equal(small.version, whole.version));

test('it has the functions of the whole, less those that it leaves out, and no other', () => {
  const methods = (object) => {
    const names = new Set();
    for (let p = Object.getPrototypeOf(object); p !== Object.prototype; p = Object.getPrototypeOf(p)) {
      Object.getOwnPropertyNames(p).forEach((name) => names.add(name));
    }
    return names;
  };
  const [big, little] = both('torus,resolution=16');
  for (const [has, less] of [[big, little], [big.stripes(big.smoothField()), little.stripes(little.smoothField())], [whole, small]]) {
    const all = methods(has);
    for (const name of methods(less)) assert.ok(all.has(name), name);
  }
  for (const name of ['texture', 'crosses', 'textureAnimator', 'camera', 'array', 'measuredField']) assert.equal(little[name], undefined, name);
});

for (const spec of ['trefoil', 'vessels,resolution=40', 'hemisphere']) {
  test(`${spec}: surfaces, fields, patterns and frames are the same, bit for bit`, () => {
    const surfaces = both(spec);
    for (const of of ['positions', 'normals', 'triangles', 'vertexOfRow']) same(pair(surfaces, (s) => s[of]()));
    same(pair(surfaces, (s) => [s.diagonal, s.origin, s.notes]));
    const [x, y, z, X, Y, Z] = surfaces[0].positions();
    const stroke = { points: [x, y, z, X, Y, Z], radius: surfaces[0].diagonal / 8, strength: 20 };
    const fields = [(s) => s.smoothField({ curvature: 0.1 }), (s) => s.smoothField({ strokes: [stroke], features: 1 }),
                    (s) => s.curvatureField({ direction: 'min' }), (s) => s.projectedField([0.3, 1, 0.2], { rotate: 30 })];
    const made = fields.map((make) => pair(surfaces, make));
    made.forEach(same);
    same(pair(surfaces, (s) => s.tangentField(s.normals().map((c, i, all) => all[i - i % 3 + (i + 1) % 3]))));
    for (const slack of [0, 0.2]) {
      const patterns = pair(surfaces, (s) => s.stripes(made[0][0], { stripes: 30, slack }));
      for (const of of ['phases', 'directions', 'frequencies', 'triangleKinds']) same(pair(patterns, (p) => p[of]()));
      same(pair(patterns, ({ energy, branches, angleErrorMean, frequencyChange, warnings }) => [energy, branches, angleErrorMean, frequencyChange, warnings]));
      const animators = pair(surfaces, (s) => s.animator({ slack }));
      for (const step of [0, 1, 2]) {
        const directions = surfaces[0].rotatedField(made[0][0], 2 * step);
        const positions = surfaces[0].positions().map((c) => c * (1 + 0.01 * step));
        const normals = surfaces[0].normals();
        same(pair(animators, (a) => {
          const { milliseconds, ...frame } = a.frame({ directions, positions, normals, stripes: 30, vertices: true, corners: true });
          assert.ok(milliseconds >= 0);
          return frame;
        }));
      }
      same(pair(animators, (a) => a.energy()));
    }
  });
}

test('what is wrong is refused as the whole refuses it', () => {
  const surfaces = both('torus,resolution=24'), field = surfaces[0].smoothField();
  const wrong = [(s) => s.stripes(field, { strips: 10 }), (s) => s.stripes(field, { slack: -1 }), (s) => s.stripes(field.slice(3)),
                 (s) => s.stripes(field.map((c, i) => (i === 5 ? NaN : c))), (s) => s.stripes(field, { stripes: 1e6 }),
                 (s) => s.smoothField({ symmetry: 0 }), (s) => s.smoothField({ strokes: [{ points: [0, 0, 0], radius: 1 }] }),
                 (s, i) => [whole, small][i].surface({ positions: [0, 0, NaN], triangles: [0, 0, 0] }),
                 (s, i) => [whole, small][i].surface({ positions: [1e30, 0, 0], triangles: [0, 0, 7] })];
  for (const work of wrong) {
    const [said, says] = pair(surfaces, (s, i) => {
      try {
        work(s, i);
      } catch (error) {
        return error;
      }
      return null;
    });
    assert.ok(says instanceof BrindleError, String(work));
    assert.equal(says.message, said.message);
  }
  surfaces[1].dispose();
  assert.throws(() => surfaces[1].positions(), /disposed of/);
});

test('repairs are told, and bytes or a compiled module do as well as what is inside', async () => {
  const twice = { positions: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0], triangles: [0, 1, 2, 0, 2, 3, 0, 4, 2, 0, 0, 1] };
  const [a, b] = [whole, small].map((library) => library.surface(twice, { repair: true }));
  assert.deepEqual([b.notes, b.vertexOfRow()], [a.notes, a.vertexOfRow()]);
  const bytes = readFileSync(join(folder, 'stripes.wasm'));
  for (const wasm of [bytes, await WebAssembly.compile(bytes)]) {
    const library = await createBrindle({ wasm });
    assert.equal(library.surface(twice, { repair: true }).triangleCount, 2);
  }
});
