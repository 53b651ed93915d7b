// How much travels: what the modules and the page may weigh, gzipped. BRINDLE_PACKAGE and BRINDLE_PAGE are their folders.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

const weight = (folder, name) => gzipSync(readFileSync(join(folder, name)), { level: 9 }).length;

// A bound is no aim: what makes a part heavier says so, and what for.
// stripes.wasm is above 150 kB for creases, a wave for every smooth sector of a vertex, and above 158 kB for
// triangles that are wound against their neighbours. brindle.wasm is above 385 kB for files as others write them (skins,
// instances and sparse accessors of glTF, faces with bridged holes), and above 395 kB for surfaces that are subdivided
// with their arrays, warnings of textures and data that are held out, and above 406 kB for drawings whose pen travels
// less (2-opt), and animators that keep the waves that they were built for.
for (const [name, most] of [['stripes.wasm', 161_000], ['brindle.wasm', 412_000]]) {
  test(`${name} is at most ${most / 1000} kB gzipped`, () => {
    const bytes = weight(process.env.BRINDLE_PACKAGE, name);
    assert.ok(bytes > 50_000 && bytes <= most, `${bytes} bytes`);
  });
}

test('the page is at most 456 kB gzipped', () => {
  const files = readdirSync(process.env.BRINDLE_PAGE, { recursive: true, withFileTypes: true }).filter((file) => file.isFile())
    .map((file) => join(file.parentPath ?? file.path, file.name));
  assert.ok(files.length > 10);
  const bytes = files.reduce((sum, file) => sum + weight('', file), 0);
  assert.ok(bytes <= 456_000, `${bytes} bytes`);
});
