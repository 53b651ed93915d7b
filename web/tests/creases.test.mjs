// Sharp edges: a wave for every face of a part, from every source of surfaces. BRINDLE_PACKAGE is the package's folder.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { box, objOf } from './box.mjs';

const load = (name) => import(pathToFileURL(join(process.env.BRINDLE_PACKAGE, name)));
const { createBrindle, BrindleError } = await load('index.js');
const { patternBuffers } = await load('draw.js');
const brindle = await createBrindle(), small = await (await load('stripes.js')).createBrindle();

const n = 8, oblique = [3, 1, 2], stripes = 16;
const onEdges = 4 * (3 + 2 + 1) * n - 12 + 8;  // vertices
const copies = onEdges + 8;                    // one more of each, and two of corners
const read = (text, name, options) => brindle.readSurface(new TextEncoder().encode(text), name, options);
const striped = (surface) => surface.stripes(surface.projectedField(oblique), { stripes });

test('an oblique direction has straight stripes on every face of a box', () => {
  const one = striped(brindle.surface(box(n))), surface = brindle.surface(box(n), { creaseAngle: 40 });
  const faces = striped(surface);
  assert.ok(one.branches > 20, `${one.branches} branches with one wave a vertex`);
  assert.equal(faces.branches, 0);
  assert.ok(faces.energy < 0.1 * one.energy, `${faces.energy} for ${one.energy}`);
  assert.ok(faces.creaseSlipMean > 0 && faces.creaseSlipMean < 180 && faces.creaseSlipShare > 0 && faces.creaseSlipShare < 1);
  assert.deepEqual([one.creaseSlipMean, one.creaseSlipShare], [undefined, undefined]);
  const ends = faces.curves().ends;
  assert.ok(ends.includes(6) && !ends.includes(4));
  assert.deepEqual([surface.notes, faces.warnings], [[], []]);
});

test('copies stand behind all vertices, where the vertices are that they are copies of', () => {
  const surface = brindle.surface(box(n), { creaseAngle: 40 }), own = brindle.surface(box(n));
  const of = surface.creaseVertices(), positions = surface.positions(), normals = surface.normals();
  assert.equal(of.length, copies);
  assert.equal(surface.vertexCount, own.vertexCount + copies);
  assert.deepEqual(positions.subarray(0, 3 * own.vertexCount), own.positions());
  of.forEach((vertex, i) => {
    const copy = own.vertexCount + i;
    for (let axis = 0; axis < 3; ++axis) assert.equal(positions[3 * copy + axis], positions[3 * vertex + axis]);
  });
  for (let i = 0; i < normals.length; i += 3) assert.equal(Math.max(...normals.subarray(i, i + 3).map(Math.abs)), 1, 'of one face');
});

test('180 degrees are one wave a vertex, which arrays of your own have by default', () => {
  const phases = striped(brindle.surface(box(n))).phases();
  assert.equal(brindle.surface(box(n)).creaseVertices().length, 0);
  for (const surface of [brindle.surface(box(n), { creaseAngle: 180 }), read(objOf(box(n)), 'box.obj', { creaseAngle: 180 })]) {
    assert.deepEqual(striped(surface).phases(), phases);
  }
  const round = [40, 180].map((creaseAngle) => brindle.shape('torus', { creaseAngle }));
  assert.deepEqual(striped(round[0]).phases(), striped(round[1]).phases());
});

test('files and shapes have creases by default', () => {
  assert.equal(read(objOf(box(n)), 'box.obj').creaseVertices().length, copies);
  assert.ok(brindle.shape('box,fillet=0.01').creaseVertices().length > 0);
});

test('vertices are joined before creases are found', () => {
  const split = brindle.surface(box(n, true), { creaseAngle: 40 });
  assert.equal(split.creaseVertices().length, 0);
  assert.match(split.notes.join('\n'), /boundary edges stand exactly where others do/);
  const joined = brindle.surface(box(n, true), { repair: true, creaseAngle: 40 });
  assert.equal(joined.creaseVertices().length, copies);
  assert.equal(joined.vertexOfRow().length, joined.vertexCount - copies);
  assert.doesNotMatch(joined.notes.join('\n'), /boundary/);
  assert.equal(striped(joined).branches, 0);
});

test('arrays of files have rows for copies', () => {
  const { positions, triangles } = box(n), count = positions.length / 3;
  const polygons = Array.from({ length: triangles.length / 3 }, (_, i) => `3 ${triangles.slice(3 * i, 3 * i + 3).join(' ')}`);
  const surface = read(`# vtk DataFile Version 3.0\ndata\nASCII\nDATASET POLYDATA\nPOINTS ${count} float\n${positions.join(' ')}\n` +
    `POLYGONS ${polygons.length} ${4 * polygons.length}\n${polygons.join('\n')}\nPOINT_DATA ${count}\nSCALARS load float 1\n` +
    `LOOKUP_TABLE default\n${[...Array(count).keys()].join(' ')}\nVECTORS flow float\n${(`${oblique.join(' ')}\n`).repeat(count)}`, 'box.vtk');
  const load = surface.array('load');
  assert.deepEqual([...load], [...Array(count).keys(), ...surface.creaseVertices()]);
  assert.equal(surface.stripes(surface.arrayField('flow'), { stripes }).branches, 0);
  const one = brindle.surface(box(n)), glb = one.texture(one.projectedField(oblique), { stripes }).glb();
  const textured = brindle.readSurface(glb, 'box.glb'), uv = textured.array('uv'), of = textured.creaseVertices();
  assert.equal(of.length, copies);
  assert.equal(uv.length, 2 * textured.vertexCount);
  of.forEach((vertex, i) => assert.equal(uv[2 * (textured.vertexCount - copies + i)], uv[2 * vertex]));
});

test('frames are of all vertices, and drawn as patterns are', () => {
  const surface = brindle.surface(box(n), { creaseAngle: 40 }), directions = surface.projectedField(oblique);
  const [positions, normals, triangles] = [surface.positions(), surface.normals(), surface.triangles()];
  const { phases, vertices } = surface.animator().frame({ directions, stripes, vertices: true });
  const pattern = { directions, phases, frequencies: surface.frequencies({ stripes }) };
  assert.deepEqual(vertices, patternBuffers({ positions, normals, triangles }, pattern).vertices);
});

test('the small module has the bits of the whole one', () => {
  const [whole, little] = [brindle, small].map((library) => library.surface(box(n), { creaseAngle: 40 }));
  for (const of of ['positions', 'normals', 'triangles', 'creaseVertices']) assert.deepEqual(little[of](), whole[of]());
  assert.deepEqual(little.smoothField(), whole.smoothField());
  const [a, b] = [whole, little].map(striped);
  assert.deepEqual(b.phases(), a.phases());
  assert.deepEqual([b.creaseSlipMean, b.creaseSlipShare], [a.creaseSlipMean, a.creaseSlipShare]);
});

test('an angle that is none is refused wherever it is given', () => {
  const makers = [(o) => brindle.surface(box(1), o), (o) => small.surface(box(1), o), (o) => brindle.shape('box', o),
                  (o) => read(objOf(box(1)), 'box.obj', o)];
  for (const make of makers) {
    for (const creaseAngle of [-1, 180.5]) {
      assert.throws(() => make({ creaseAngle }), (error) => error instanceof BrindleError &&
        error.message === `creaseAngle: expected a number from 0 to 180, got '${creaseAngle}'`);
    }
    for (const creaseAngle of [NaN, '40', null]) assert.throws(() => make({ creaseAngle }), /: 'creaseAngle' must be a finite number/);
    assert.throws(() => make({ crease: 40 }), /no option 'crease'/);
  }
});
