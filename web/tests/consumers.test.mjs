// The package as others get it: packed, installed, imported, bundled.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { build } from 'esbuild';
import { build as vite } from 'vite';
import webpack from 'webpack';

const folder = process.env.BRINDLE_PACKAGE;
const scratch = mkdtempSync(join(tmpdir(), 'brindle-consumer-'));
after(() => rmSync(scratch, { recursive: true }));

const npm = (...words) => execFileSync('npm', [...words, '--offline', '--no-audit', '--no-fund'], { cwd: scratch, encoding: 'utf8' });
const [packed] = JSON.parse(npm('pack', folder, '--json'));
writeFileSync(join(scratch, 'package.json'), JSON.stringify({ type: 'module', private: true }));
npm('install', join(scratch, packed.filename));

const program = `
import createBrindle, { BrindleError } from 'brindle';
const brindle = await createBrindle();
const torus = brindle.shape('torus');
const pattern = torus.stripes(torus.projectedField([0, 0, 1]), { stripes: 20 });
let refused = false;
try { brindle.shape('x'); } catch (error) { refused = error instanceof BrindleError; }
console.log(JSON.stringify({ energy: pattern.energy, refused }));
`;
const run = (file) => JSON.parse(execFileSync('node', [file], { cwd: scratch, encoding: 'utf8' }));

test('what is packed is what is exported, and nothing else', () => {
  const files = new Set(packed.files.map((file) => file.path));
  const { exports, version, dependencies } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  assert.equal(packed.version, version);
  assert.equal(dependencies, undefined);
  for (const target of Object.values(exports).flatMap((e) => (typeof e === 'string' ? [e] : Object.values(e)))) {
    assert.ok(files.has(target.replace('./', '')), target);
  }
  assert.ok(files.has('LICENSE') && files.has('NOTICE.md'));
  for (const file of files) assert.match(file, /^(package\.json|LICENSE|(README|NOTICE)\.md|(brindle|stripes)\.wasm|[\w-]+\.(js|d\.ts))$/);
});

// Each takes a program, and leaves it with all that it needs in a folder.
const bundlers = {
  esbuild: (entry, out) => build({ entryPoints: [entry], outfile: join(out, 'program.mjs'), bundle: true, minify: true, format: 'esm',
                                   platform: 'browser', logLevel: 'error' }),
  vite: (entry, out) => vite({
    root: scratch, configFile: false, logLevel: 'error',
    build: { outDir: out, target: 'es2022', modulePreload: false, rollupOptions: {
      input: entry, preserveEntrySignatures: 'strict', output: { entryFileNames: 'program.mjs' } } },
    worker: { format: 'es' },
  }),
  webpack: (entry, out) => new Promise((done, failed) => {
    webpack({ mode: 'production', performance: false, context: scratch, entry, target: ['web', 'es2022'], experiments: { outputModule: true, topLevelAwait: true },
              output: { path: out, filename: 'program.mjs', module: true, publicPath: '', chunkFormat: 'module' } }, (error, stats) => {
      const problems = stats?.toJson({ errors: true, warnings: true });
      if (error || problems.errors.length || problems.warnings.length) failed(error ?? new Error(JSON.stringify(problems.errors.concat(problems.warnings))));
      else done();
    });
  }),
};

test('installed and bundled, it does the same', async (t) => {
  writeFileSync(join(scratch, 'program.js'), program);
  const installed = run('program.js');
  assert.ok(installed.refused);
  for (const [name, bundle] of Object.entries(bundlers)) {
    await t.test(name, async () => {
      await bundle(join(scratch, 'program.js'), join(scratch, name));
      renameSync(join(scratch, 'node_modules'), join(scratch, 'hidden'));
      try {
        assert.deepEqual(run(`${name}/program.mjs`), installed);
      } finally {
        renameSync(join(scratch, 'hidden'), join(scratch, 'node_modules'));
      }
    });
  }
});

// What is loaded when the program runs is found by `new URL(..., import.meta.url)`.
const apart = `
import createBrindle from 'brindle/slim';
import { createBrindle as createInWorker } from 'brindle/worker';
globalThis.start = () => [createBrindle(), createInWorker()];
`;

for (const name of ['vite', 'webpack']) {
  test(`${name} takes the WebAssembly and the worker along`, async () => {
    writeFileSync(join(scratch, 'apart.js'), apart);
    const out = join(scratch, `${name}-apart`);
    await bundlers[name](join(scratch, 'apart.js'), out);
    const files = readdirSync(out, { recursive: true, withFileTypes: true }).filter((file) => file.isFile())
      .map((file) => join(file.parentPath ?? file.path, file.name));
    const wasm = files.filter((file) => file.endsWith('.wasm'));
    assert.ok(wasm.length >= 1, `no WebAssembly among ${files}`);
    assert.deepEqual(readFileSync(wasm[0]), readFileSync(join(folder, 'brindle.wasm')));
    const programs = files.filter((file) => /\.m?js$/.test(file)).map((file) => readFileSync(file, 'utf8'));
    assert.ok(programs.some((text) => text.includes('onmessage')), 'the worker is missing');
  });
}

const inRealTime = `
import createBrindle, { BrindleError } from 'brindle/stripes';
const brindle = await createBrindle();
const surface = brindle.surface({ positions: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], triangles: [0, 1, 2, 0, 2, 3] });
const pattern = surface.stripes(surface.projectedField([1, 0, 0]), { frequency: 0.3 });
let refused = false;
try { brindle.surface({ positions: [0, 0], triangles: [] }); } catch (error) { refused = error instanceof BrindleError; }
console.log(JSON.stringify({ energy: pattern.energy, refused }));
`;

test('stripes in real time are bundled without the rest of the library', async () => {
  writeFileSync(join(scratch, 'realtime.js'), inRealTime);
  const installed = run('realtime.js');
  assert.ok(installed.refused && installed.energy < 0.1);
  const sizes = {};
  for (const [name, program] of [['whole', 'program.js'], ['realtime', 'realtime.js']]) {
    await bundlers.esbuild(join(scratch, program), join(scratch, name));
    sizes[name] = readFileSync(join(scratch, name, 'program.mjs')).length;
  }
  assert.deepEqual(run('realtime/program.mjs'), installed);
  assert.ok(sizes.realtime < 0.5 * sizes.whole, JSON.stringify(sizes));
});
