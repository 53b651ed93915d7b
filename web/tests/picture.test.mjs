// Pictures of brindle/draw in a real browser beside those of the tool: the same mesh, pattern, camera and
// colours, pixel by pixel. BRINDLE_TOOL is the tool, BRINDLE_SHOTS where pictures go.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { serve } from '../serve.mjs';
import { complaintsOf, openBrowser } from './browser.mjs';

const folder = process.env.BRINDLE_PACKAGE, tool = process.env.BRINDLE_TOOL, shots = process.env.BRINDLE_SHOTS;
const models = join(dirname(fileURLToPath(import.meta.url)), '../../../shared/models');
const width = 640, height = 480;
const scratch = mkdtempSync(join(tmpdir(), 'brindle-picture-'));
const { createBrindle } = await import(pathToFileURL(join(folder, 'index.js')));
let server, address, browser, close, page, complaints;

const program = `
import { StripeDrawing } from 'brindle/draw';

const width = ${width}, height = ${height};
const canvas = document.body.appendChild(Object.assign(document.createElement('canvas'), { width, height }));
const gl = canvas.getContext('webgl2', { preserveDrawingBuffer: true, antialias: false });
const drawing = new StripeDrawing(gl);

async function pixelsOf(address) {
  const bitmap = await createImageBitmap(await (await fetch(address)).blob(), { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
  const context = new OffscreenCanvas(width, height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, width, height).data;
}

function drawn({ positions, normals, triangles, camera, texture, ...pattern }) {
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  drawing.setSurface({ positions: Float32Array.from(positions), normals: Float32Array.from(normals), triangles: Uint32Array.from(triangles) });
  if (texture) {
    const { u, v, side, distances, words, ...broken } = texture;
    drawing.setTexture({ u: Float32Array.from(u), v: Float32Array.from(v) }, { side, distances: Float32Array.from(distances) },
                       { ...broken, words: Uint32Array.from(words) });
  } else drawing.setPattern(pattern);
  drawing.draw({ ...camera, width, height });
  const upwards = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upwards);
  return upwards;
}

// Where both have the surface in the whole of a pixel: the shares of pixels whose largest difference, in
// levels of 255, is above so many.
window.compared = async (address, given) => {
  const theirs = await pixelsOf(address), ours = drawn(given);
  const differences = [];
  let either = 0;
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const a = 4 * (y * width + x), b = 4 * ((height - 1 - y) * width + x);
      either += theirs[a + 3] > 0 || ours[b + 3] > 0;
      if (theirs[a + 3] < 255 || ours[b + 3] < 255) continue;
      differences.push(Math.max(...[0, 1, 2].map((c) => Math.abs(theirs[a + c] - ours[b + c]))));
    }
  }
  const above = (levels) => differences.filter((d) => d > levels).length / differences.length;
  return { inside: differences.length, either, above: { 2: above(2), 8: above(8), 32: above(32) },
           mean: differences.reduce((sum, d) => sum + d, 0) / differences.length };
};
`;

// What the tool has written: numbers of vertices by name, and triangles.
function readPLY(path) {
  const bytes = readFileSync(path), end = bytes.indexOf('end_header\n') + 11;
  const lines = bytes.subarray(0, end).toString().split('\n').map((line) => line.split(' '));
  const count = (name) => Number(lines.find(([word, what]) => word === 'element' && what === name)[2]);
  const faces = lines.findIndex(([word, what]) => word === 'element' && what === 'face');
  const properties = (list) => list.filter(([word]) => word === 'property').map((words) => [words.at(-1), words.slice(1, -1)]);
  const view = new DataView(bytes.buffer, bytes.byteOffset + end);
  let at = 0;
  const readers = { float: ['getFloat32', 4], double: ['getFloat64', 8], uchar: ['getUint8', 1], uint: ['getUint32', 4], int: ['getInt32', 4] };
  const next = (type) => {
    const [method, size] = readers[type], number = view[method](at, true);
    at += size;
    return number;
  };
  const ofVertex = properties(lines.slice(0, faces)), ofFace = properties(lines.slice(faces));
  const vertices = Object.fromEntries(ofVertex.map(([name]) => [name, []])), triangles = [];
  for (let i = 0; i < count('vertex'); ++i) for (const [name, [type]] of ofVertex) vertices[name].push(next(type));
  for (let i = 0; i < count('face'); ++i) {
    for (const [name, [type, ofLength, ofEntry]] of ofFace) {
      if (type !== 'list') next(type);
      else for (let left = next(ofLength); left > 0; --left) if (name === 'vertex_indices') triangles.push(next(ofEntry)); else next(ofEntry);
    }
  }
  assert.equal(at, bytes.length - end);
  return { vertices, triangles };
}

const columns = (...arrays) => Float32Array.from({ length: arrays.length * arrays[0].length }, (_, i) => arrays[i % arrays.length][Math.floor(i / arrays.length)]);

before(async () => {
  if (!tool) return;
  await build({ stdin: { contents: program, resolveDir: scratch }, alias: { brindle: folder }, bundle: true, format: 'esm',
                outfile: join(scratch, 'program.js'), logLevel: 'error' });
  writeFileSync(join(scratch, 'index.html'), '<!doctype html><link rel="icon" href="data:,"><script type="module" src="program.js"></script>');
  ({ server, address } = await serve(scratch));
  ({ browser, close } = await openBrowser());
  page = await browser.newPage();
  complaints = complaintsOf(page);
  await page.setViewport({ width: width + 16, height: height + 16 });
  await page.goto(address);
  await page.waitForFunction(() => window.compared, { timeout: 60000 });
});
after(async () => {
  await close?.();
  server?.close();
  rmSync(scratch, { recursive: true, force: true });
});

const brindle = await createBrindle();

/** What the tool is asked for; its picture, and the mesh with its pattern. */
function toolOf(name, mesh, { azimuth, elevation, zoom = 1, up = 'z', words }) {
  const picture = `${name}.png`, written = join(scratch, `${name}.ply`);
  const stripe = (...more) => execFileSync(tool, ['stripe', mesh, ...more, '--crease-angle', '180', '--quiet'], { stdio: 'pipe' });
  stripe(...words, '--camera', `${azimuth},${elevation},${zoom}`, '--up', up, '--size', `${width}x${height}`, '--quality', 'interactive',
         '--transparent', '--colors', '#1c325a,#f4efe5', '--output', join(scratch, picture));
  stripe(...words.filter((word, i) => !/^--(texture|oriented|tiles)$/.test(word) && !/^--(texture|tiles)$/.test(words[i - 1])), '--output', written);
  const { vertices: v, triangles } = readPLY(written);
  const surface = brindle.surface({ positions: columns(v.x, v.y, v.z), triangles });
  const { viewFromWorld, clipFromView, up: upwards } = surface.camera({ azimuth, elevation, zoom, up, width, height });
  const camera = { viewFromWorld: [...viewFromWorld], clipFromView: [...clipFromView], up: [...upwards] };
  const phases = v.phase.flatMap((phase) => (Number.isNaN(phase) ? [0, 1] : [Math.cos(phase), Math.sin(phase)]));
  const waves = { directions: columns(v.direction_x, v.direction_y, v.direction_z), frequencies: Float32Array.from(v.frequency), phases };
  return { picture, surface, waves, drawn: { positions: [...surface.positions()], normals: [...surface.normals()], triangles, camera } };
}

/** The shares of pixels that differ, which are told. Contours of the tool's pictures are smoothed, those of WebGL are not. */
async function compared(t, name, picture, what, given) {
  const result = await page.evaluate((...all) => window.compared(...all), address + picture, given);
  if (shots) {
    mkdirSync(shots, { recursive: true });
    writeFileSync(join(shots, `tool_${name}.png`), readFileSync(join(scratch, picture)));
    writeFileSync(join(shots, `webgl_${name}.png`), await (await page.$('canvas')).screenshot({ omitBackground: true }));
  }
  const { inside, either, above, mean } = result;
  const shares = Object.entries(above).map(([levels, share]) => `${(100 * share).toFixed(3)} % by more than ${levels}`).join(', ');
  t.diagnostic(`${what}: of ${inside} pixels differ ${shares} levels; ${mean.toFixed(3)} on average; ${either - inside} pixels at the border`);
  assert.ok(inside > 0.1 * width * height && inside > 0.9 * either, `${inside} pixels of ${either} have the surface in both`);
  return { above, shares };
}

const cases = [
  ['knot', 'shape:trefoil', { azimuth: 30, elevation: 20, words: ['--stripes', '40'] }],
  ['edges', 'shape:box', { azimuth: 40, elevation: 35, words: ['--stripes', '24'] }],
  ['near', 'shape:sphere,resolution=24', { azimuth: 200, elevation: -30, zoom: 4, words: ['--stripes', '60'] }],
  ['fine', 'shape:torus', { azimuth: 0, elevation: 75, words: ['--stripes', '200'] }],
  ['spot', join(models, 'spot.obj'), { azimuth: -50, elevation: 10, up: 'y', words: ['--stripes', '50'] }],
];

for (const [name, mesh, asked] of cases) {
  test(`${name}: the pixels of the tool`, async (t) => {
    if (!tool) return t.skip('BRINDLE_TOOL names no tool');
    if (!mesh.startsWith('shape:') && !existsSync(mesh)) return t.skip('the model is not here');
    const { picture, surface, waves, drawn } = toolOf(name, mesh, asked);
    const { directions, frequencies } = waves, plain = { directions: [...directions], frequencies: [...frequencies] };
    const same = await compared(t, name, picture, "the tool's phases", { ...drawn, ...plain, phases: waves.phases });
    const contours = asked.zoom > 1 ? 0.02 : 1;  // none are in the picture
    assert.ok(same.above[2] < 0.04 * contours && same.above[8] < 0.015 * contours && same.above[32] < 0.003 * contours, same.shares);
    const pattern = surface.stripes(directions, { frequency: frequencies });
    const own = await compared(t, name, picture, 'own phases', { ...drawn, ...plain, phases: [...pattern.phases()] });
    assert.ok(own.above[8] < 0.02 && own.above[32] < 0.004, own.shares);
    assert.deepEqual(complaints, []);
    surface.dispose();
    return undefined;
  });
}

for (const tile of ['arrows', 'checker', 'bricks', 'plusminus']) {
  test(`${tile}: the tiles of the tool`, async (t) => {
    if (!tool) return t.skip('BRINDLE_TOOL names no tool');
    const oriented = tile === 'arrows', direction = [0.31, 0.9, 0.27];
    const { picture, surface, drawn } = toolOf(tile, 'shape:torus,resolution=80', { azimuth: 20, elevation: 50,
      words: ['--direction', direction.join(','), '--stripes', '24', '--texture', tile, ...(oriented ? ['--oriented'] : [])] });
    const texture = surface.texture(surface.projectedField(direction), { stripes: 24, oriented });
    const { u, v } = texture.waves(), broken = texture.brokenTiles(tile), { side, distances } = brindle.tile(tile);
    const { above, shares } = await compared(t, tile, picture, 'own phases', { ...drawn,
      texture: { u: [...u], v: [...v], side, distances: [...distances], ...broken, words: [...broken.words] } });
    assert.ok(above[8] < 0.02 && above[32] < 0.004, shares);
    assert.deepEqual(complaints, []);
    surface.dispose();
    return undefined;
  });
}
