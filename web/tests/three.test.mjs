// Stripes on materials of three.js, in a real browser: what they show is what brindle/draw shows.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { serve } from '../serve.mjs';
import { complaintsOf, openBrowser } from './browser.mjs';

const folder = process.env.BRINDLE_PACKAGE, shots = process.env.BRINDLE_SHOTS;
const side = 320;
const scratch = mkdtempSync(join(tmpdir(), 'brindle-three-'));
let server, address, browser, close, page, complaints;

const program = `
import createBrindle from 'brindle';
import { StripeDrawing } from 'brindle/draw';
import { Stripes, surfaceInput } from 'brindle/three';
import * as THREE from 'three';

const brindle = await createBrindle();
const arraysOf = (surface) => ({ positions: surface.positions(), normals: surface.normals(), triangles: surface.triangles() });
const wavesOf = (pattern) => ({ directions: pattern.directions(), frequencies: pattern.frequencies(), phases: pattern.phases() });
const torus = brindle.shape('torus,resolution=40');
const pattern = torus.stripes(torus.projectedField([0.3, 1, 0.2]), { stripes: 24 });

const side = ${side};
const canvas = () => document.body.appendChild(Object.assign(document.createElement('canvas'), { width: side, height: side }));
const camera = new THREE.PerspectiveCamera(35, 1, 0.1, 100);
camera.position.set(1, 3.4, 3.2);
camera.lookAt(0, 0, 0);
camera.updateMatrixWorld();
const renderer = new THREE.WebGLRenderer({ canvas: canvas(), preserveDrawingBuffer: true, antialias: false });
renderer.setSize(side, side, false);

function pixels(gl) {
  const bytes = new Uint8Array(4 * side * side);
  gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return Array.from({ length: side * side }, (_, i) => bytes[4 * i + 1]);
}

/** Of a material in white, on red: the share of green, which only the surface has. */
function drawn(stripes, material, lights = []) {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color('red');
  scene.add(new THREE.Mesh(stripes.geometry, stripes.paint(material)), ...lights);
  renderer.setRenderTarget(null);
  renderer.render(scene, camera);
  return pixels(renderer.getContext());
}

function drawnByBrindle() {
  const gl = canvas().getContext('webgl2', { preserveDrawingBuffer: true, antialias: false });
  gl.clearColor(1, 0, 0, 1);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  const drawing = new StripeDrawing(gl);
  drawing.setSurface(arraysOf(torus));
  drawing.setPattern(wavesOf(pattern));
  const view = camera.matrixWorldInverse.clone().multiply(new THREE.Matrix4().makeTranslation(...drawing.center));
  drawing.draw({ viewFromWorld: view.elements, clipFromView: camera.projectionMatrix.elements, width: side, height: side,
                 baseColor: [1, 1, 1], stripeColor: [0, 0, 0] });
  return pixels(gl);
}

const make = (options = { color: 'black' }) => new Stripes(arraysOf(torus), wavesOf(pattern), options);
const share = (list, condition) => list.filter(condition).length / list.length;

window.tests = {
  // Where light does not tell which it is, nothing is compared.
  agreement() {
    const flat = drawn(make(), new THREE.MeshBasicMaterial({ color: 'white' })), lit = drawnByBrindle();
    const pairs = flat.map((value, i) => [value, lit[i]]).filter(([value, other]) => (value < 30 || value > 225) && (other < 12 || other > 90));
    return { compared: pairs.length / flat.length, differ: share(pairs, ([value, other]) => (value > 128) !== (other > 50)),
             white: share(flat, (value) => value > 225), black: share(flat, (value) => value < 30) };
  },
  target() {
    const stripes = make(), scene = new THREE.Scene(), half = side / 2;
    scene.add(new THREE.Mesh(stripes.geometry, stripes.paint(new THREE.MeshBasicMaterial({ color: 'white' }))));
    const target = new THREE.WebGLRenderTarget(side, side);
    target.viewport.set(half, 0, half, half);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const inside = new Uint8Array(4 * half * half), direct = new Uint8Array(4 * half * half);
    renderer.readRenderTargetPixels(target, half, 0, half, half, inside);
    const small = new THREE.WebGLRenderTarget(half, half);
    renderer.setRenderTarget(small);
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(small, 0, 0, half, half, direct);
    renderer.setRenderTarget(null);
    return { differ: share([...inside], (value, i) => Math.abs(value - direct[i]) > 8), seen: share([...direct], (value) => value > 128) };
  },
  materials() {
    const lights = () => [new THREE.DirectionalLight('white', 2), new THREE.AmbientLight('white', 0.4)];
    return ['MeshLambertMaterial', 'MeshPhongMaterial', 'MeshStandardMaterial', 'MeshPhysicalMaterial', 'MeshToonMaterial'].map((name) => {
      const stripes = make();
      const striped = drawn(stripes, new THREE[name]({ color: 'white' }), lights());
      stripes.width = 0;
      return { name, changed: share(drawn(stripes, new THREE[name]({ color: 'white' }), lights()), (value, i) => Math.abs(value - striped[i]) > 40) };
    });
  },
  changes() {
    const stripes = make(), material = new THREE.MeshBasicMaterial({ color: 'white' });
    const first = drawn(stripes, material);
    stripes.width = 0.2;
    const narrow = drawn(stripes, material);
    stripes.width = 0.5;
    const animator = torus.animator();
    const input = { directions: pattern.directions(), frequencies: pattern.frequencies().map((f) => 1.5 * f) };
    const frame = animator.frame(input);
    stripes.setPattern({ ...input, phases: frame.phases ?? frame });
    const denser = drawn(stripes, material);
    const lifted = torus.positions().map((x, i) => (i % 3 === 1 ? x + 0.4 : x));
    stripes.setPattern({ ...input, phases: frame.phases ?? frame }, { positions: lifted, normals: torus.normals() });
    const moved = drawn(stripes, material);
    const { vertices } = animator.frame({ ...input, positions: lifted.map((x, i) => (i % 3 === 1 ? x - 0.4 : x)), vertices: true });
    stripes.setVertices(vertices);
    const back = drawn(stripes, material);
    stripes.setVertices(animator.frame({ ...input, positions: lifted, vertices: true }).vertices);
    const again = drawn(stripes, material);
    const differ = (a, b) => share(a, (value, i) => Math.abs(value - b[i]) > 128);
    return { narrow: share(narrow, (v) => v > 128) / share(first, (v) => v > 128), denser: differ(first, denser), moved: differ(denser, moved), back: differ(denser, back), again: differ(moved, again) };
  },
  geometry() {
    const indexed = new THREE.SphereGeometry(1, 24, 16);
    const loose = indexed.toNonIndexed();
    const counts = [indexed, loose].map((geometry) => {
      const surface = brindle.surface(surfaceInput(geometry), { repair: true });
      return [new Set(surface.triangles()).size, surface.triangles().length / 3];
    });
    const refused = [];
    for (const attempt of [() => surfaceInput(new THREE.BufferGeometry()), () => make().paint(new THREE.PointsMaterial()), () => make().paint(new THREE.ShaderMaterial()),
                           () => new Stripes(arraysOf(torus), { ...wavesOf(pattern), phases: new Float32Array(2) })]) {
      try { attempt(); refused.push(null); } catch (error) { refused.push(\`\${error.name}: \${error.message}\`); }
    }
    return { counts, refused };
  },
};
`;

before(async () => {
  await build({
    stdin: { contents: program, resolveDir: fileURLToPath(new URL('.', import.meta.url)) },
    alias: { brindle: folder }, nodePaths: [fileURLToPath(new URL('../node_modules', import.meta.url))], bundle: true, format: 'esm', outfile: join(scratch, 'program.js'), logLevel: 'error',
  });
  writeFileSync(join(scratch, 'index.html'), '<!doctype html><link rel="icon" href="data:,"><script type="module" src="program.js"></script>');
  ({ server, address } = await serve(scratch));
  ({ browser, close } = await openBrowser());
  page = await browser.newPage();
  complaints = complaintsOf(page);
  await page.goto(address);
  await page.waitForFunction(() => window.tests, { timeout: 60000 }).catch((error) => { throw new Error(complaints.join('\n') || String(error)); });
});
after(async () => {
  await close?.();
  server?.close();
  rmSync(scratch, { recursive: true, force: true });
});

const of = (name) => page.evaluate((which) => window.tests[which](), name);

test('a material in three shows the stripes that brindle/draw shows', async () => {
  const { compared, differ, white, black } = await of('agreement');
  if (shots) {
    mkdirSync(shots, { recursive: true });
    writeFileSync(join(shots, 'three.png'), await page.screenshot());
  }
  assert.ok(compared > 0.6, `${compared} of the pixels are told apart`);
  assert.ok(differ < 0.005, `${differ} of the pixels differ`);
  assert.ok(white > 0.1 && black > 0.1);
  assert.deepEqual(complaints, []);
});

test('in a part of a target they are those of a target of its size', async () => {
  const { differ, seen } = await of('target');
  assert.ok(seen > 0.05);
  assert.ok(differ < 0.005, `${differ} of the values differ`);
});

test('lit materials take them, too', async () => {
  for (const { name, changed } of await of('materials')) assert.ok(changed > 0.05, `${name}: ${changed}`);
  assert.deepEqual(complaints, []);
});

test('width, pattern and moved positions can change', async () => {
  const { narrow, denser, moved, back, again } = await of('changes');
  assert.ok(narrow > 1.2, `narrower stripes leave ${narrow} times as much white`);
  assert.ok(denser > 0.05 && moved > 0.05, `${denser}, ${moved}`);
  // Phases follow where vertices go, to the last digits.
  assert.ok(back < 0.005 && again < 0.005, `${back}, ${again}`);
});

test('geometries become surfaces, and what cannot be is refused', async () => {
  const { counts, refused } = await of('geometry');
  // Seams and poles are joined.
  assert.deepEqual(counts, [[24 * 15 + 2, 720], [24 * 15 + 2, 720]]);
  assert.match(refused[0], /BrindleError: the geometry has no attribute 'position'/);
  assert.match(refused[1], /BrindleError: PointsMaterial cannot take stripes/);
  assert.match(refused[2], /BrindleError: ShaderMaterial cannot take stripes/);
  assert.match(refused[3], /BrindleError: phases must have/);
});
