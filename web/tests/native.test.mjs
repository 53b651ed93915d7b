// Energies and branches are those of the tool, where both get the same numbers. BRINDLE_TOOL is the
// tool; models are skipped where they are not.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const tool = process.env.BRINDLE_TOOL;
const models = join(dirname(fileURLToPath(import.meta.url)), '../../../shared/models');
const { createBrindle } = await import(pathToFileURL(join(process.env.BRINDLE_PACKAGE, 'index.js')));
const brindle = await createBrindle();
const scratch = mkdtempSync(join(tmpdir(), 'brindle-web-'));
after(() => rmSync(scratch, { recursive: true }));

function reported(...words) {
  const file = join(scratch, 'report.json');
  // The module has one wave a vertex.
  execFileSync(tool, ['stripe', ...words, '--crease-angle', '180', '--report', file], { stdio: 'pipe' });
  return JSON.parse(readFileSync(file, 'utf8'));
}

const inputs = [['shape:trefoil', () => brindle.shape('trefoil')]];
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
  assert.ok(Math.abs(ours.energy - theirs.energy) <= 1e-5, `${ours.energy} for ${theirs.energy}`);
  assert.equal(ours.branches, theirs.branches.count ?? theirs.branches);
  return undefined;
});

for (const [source, make] of inputs) {
  test(`${source.split('/').pop()}: the tool's energies and branches`, (t) => {
    if (!tool) return t.skip('BRINDLE_TOOL names no tool');
    const surface = make();
    if (!surface) return t.skip('the model is not here');
    const smooth = surface.smoothField();
    const file = join(scratch, 'field.csv');
    const rows = [];
    for (let i = 0; i < smooth.length; i += 3) rows.push(`${smooth[i]},${smooth[i + 1]},${smooth[i + 2]}`);
    writeFileSync(file, `${rows.join('\n')}\n`);
    const fields = [[['--direction', '0,0,1'], surface.projectedField([0, 0, 1])], [['--field', file], surface.tangentField(smooth)]];
    for (const [words, field] of fields) {
      for (const slack of [0, 0.2]) {
        const theirs = reported(source, ...words, '--stripes', '40', ...(slack ? ['--slack', String(slack)] : []));
        const ours = surface.stripes(field, { stripes: 40, slack });
        const what = `${words[0]} slack ${slack}: energy ${ours.energy} for ${theirs.energy}`;
        assert.ok(Math.abs(ours.energy - theirs.energy) <= 1e-5, what);
        assert.equal(ours.branches, theirs.branches.count ?? theirs.branches, what);
        ours.dispose();
      }
    }
    const cross = surface.smoothField({ symmetry: 4 }), crosses = join(scratch, 'crosses.csv');
    writeFileSync(crosses, Array.from({ length: surface.vertexCount }, (_, i) => `${[...cross.subarray(3 * i, 3 * i + 3)]}\n`).join(''));
    const theirs = reported(source, '--cross', '--field', crosses, '--stripes', '40');
    const ours = surface.crosses(surface.tangentField(cross), { stripes: 40 });
    assert.ok(Math.abs(ours.energy - theirs.energy) <= 1e-5, `crosses: energy ${ours.energy} for ${theirs.energy}`);
    assert.equal(ours.branches, theirs.branches.count ?? theirs.branches, 'crosses');
    return undefined;
  });
}
