// The package as others get it: packed, installed, imported, bundled.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { build } from 'esbuild';

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
  for (const file of files) assert.match(file, /^(package\.json|LICENSE|NOTICE\.md|brindle\.wasm|[\w-]+\.(js|d\.ts))$/);
});

test('installed and bundled, it does the same', async () => {
  writeFileSync(join(scratch, 'program.js'), program);
  const installed = run('program.js');
  assert.ok(installed.refused);
  await build({ entryPoints: [join(scratch, 'program.js')], outfile: join(scratch, 'bundle/program.mjs'), bundle: true, minify: true,
                format: 'esm', platform: 'browser', logLevel: 'error' });
  rmSync(join(scratch, 'node_modules'), { recursive: true });
  assert.deepEqual(run('bundle/program.mjs'), installed);
});
