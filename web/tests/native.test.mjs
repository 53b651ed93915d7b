// Energies and branches are those of the tool, where both get the same numbers. BRINDLE_TOOL is the
// tool; models are skipped where they are not.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { box, objOf } from './box.mjs';

const tool = process.env.BRINDLE_TOOL;
const models = join(dirname(fileURLToPath(import.meta.url)), '../../../shared/models');
const { createBrindle } = await import(pathToFileURL(join(process.env.BRINDLE_PACKAGE, 'index.js')));
const brindle = await createBrindle();
const scratch = mkdtempSync(join(tmpdir(), 'brindle-web-'));
after(() => rmSync(scratch, { recursive: true }));

function reported(...words) {
  const file = join(scratch, 'report.json');
  execFileSync(tool, ['stripe', ...words, '--report', file], { stdio: 'pipe' });
  return JSON.parse(readFileSync(file, 'utf8'));
}

/** A field in a file, with a row for every vertex but copies at creases; and as the tool takes it. */
function handedOver(surface, field, name) {
  const copies = surface.creaseVertices(), own = surface.vertexCount - copies.length;
  const row = (vertex) => field.subarray(3 * vertex, 3 * vertex + 3);
  const file = join(scratch, name), taken = field.slice();
  writeFileSync(file, Array.from({ length: own }, (_, vertex) => `${[...row(vertex)]}\n`).join(''));
  copies.forEach((vertex, i) => taken.set(row(vertex), 3 * (own + i)));
  return [file, surface.tangentField(taken)];
}

function agree(ours, theirs, what) {
  assert.ok(Math.abs(ours.energy - theirs.energy) <= 1e-5, `${what}: energy ${ours.energy} for ${theirs.energy}`);
  assert.equal(ours.branches, theirs.branches.count ?? theirs.branches, what);
}

const boxFile = join(scratch, 'box.obj');
writeFileSync(boxFile, objOf(box(8)));
const inputs = [['shape:trefoil', () => brindle.shape('trefoil')], [boxFile, () => brindle.readSurface(readFileSync(boxFile), 'box.obj')]];
for (const name of ['spot.obj', 'horse.ply']) {
  const path = join(models, name);
  inputs.push([path, () => (existsSync(path) ? brindle.readSurface(readFileSync(path), name) : null)]);
}

test('attributes of glTF are those that the tool reads', (t) => {
  if (!tool) return t.skip('BRINDLE_TOOL names no tool');
  const file = join(scratch, 'knot.glb');
  execFileSync(tool, ['stripe', 'shape:trefoil', '--field', 'curvature', '--stripes', '30', '--output', file], { stdio: 'pipe' });
  const surface = brindle.readSurface(readFileSync(file), 'knot.glb');
  assert.ok(['direction', 'phase'].every((name) => surface.arrays.some((array) => array.name === name)));
  const ours = surface.stripes(surface.arrayField('direction'), { stripes: 30 });
  const theirs = reported(file, '--field', 'array:direction', '--stripes', '30');
  agree(ours, theirs, 'glTF');
  return undefined;
});

for (const [source, make] of inputs) {
  test(`${source.split('/').pop()}: the tool's energies and branches`, (t) => {
    if (!tool) return t.skip('BRINDLE_TOOL names no tool');
    const surface = make();
    if (!surface) return t.skip('the model is not here');
    const [file, smooth] = handedOver(surface, surface.smoothField(), 'field.csv');
    const fields = [[['--direction', '3,1,2'], surface.projectedField([3, 1, 2])], [['--field', file], smooth]];
    for (const [words, field] of fields) {
      for (const slack of [0, 0.2]) {
        const theirs = reported(source, ...words, '--stripes', '40', ...(slack ? ['--slack', String(slack)] : []));
        const ours = surface.stripes(field, { stripes: 40, slack });
        agree(ours, theirs, `${words[0]} slack ${slack}`);
        assert.equal(surface.creaseVertices().length, theirs.crease_vertices);
        assert.equal(ours.creaseSlipMean === undefined, theirs.crease_vertices === 0);
        if (theirs.crease_vertices > 0) {
          assert.ok(Math.abs(ours.creaseSlipMean - theirs.crease_slip_mean_deg) < 0.1, `${ours.creaseSlipMean} for ${theirs.crease_slip_mean_deg}`);
          assert.ok(Math.abs(ours.creaseSlipShare - theirs.crease_slip_share) < 0.01);
        }
        ours.dispose();
      }
    }
    const [crosses, cross] = handedOver(surface, surface.smoothField({ symmetry: 4 }), 'crosses.csv');
    agree(surface.crosses(cross, { stripes: 40 }), reported(source, '--cross', '--field', crosses, '--stripes', '40'), 'crosses');
    return undefined;
  });
}

test('an angle of creases is refused in the words of the tool', (t) => {
  if (!tool) return t.skip('BRINDLE_TOOL names no tool');
  const said = (work) => {
    try {
      work();
    } catch (error) {
      return /expected .*/.exec(error.stderr ?? error.message)[0];
    }
    return null;
  };
  const ours = said(() => brindle.shape('box', { creaseAngle: 181 }));
  assert.equal(ours, said(() => execFileSync(tool, ['stripe', 'shape:box', '--crease-angle', '181'], { stdio: 'pipe' })));
  return undefined;
});
