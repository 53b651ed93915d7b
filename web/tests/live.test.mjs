// What the page asks the library for while sliders move and when they rest. BRINDLE_PACKAGE is the package's folder.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { LivePattern } from '../page/pattern.js';
import { defaults } from '../page/settings.js';

const load = (name) => import(pathToFileURL(join(process.env.BRINDLE_PACKAGE, name)));
const { createBrindle } = await load('index.js');
const { serve } = await load('serve.js');
const remote = await load('worker.js');
const { port1, port2 } = new MessageChannel();
serve(port1, createBrindle);
const library = await remote.createBrindle({ worker: port2 });
after(() => {
  library.terminate();
  port1.close();
});

// All that was shown, in its order; `rest` waits until nothing is under way.
async function page(spec) {
  const shown = [], failed = [];
  let done = () => {};
  const live = new LivePattern(library, { shown: (result) => shown.push(result), working: (is) => is || done(), failed: (message) => failed.push(message) });
  await live.take((brindle) => brindle.shape(spec));
  const ask = (settings, draft) => new Promise((resolve) => {
    done = resolve;
    live.ask({ ...defaults, ...settings }, draft);
  });
  return { live, shown, failed, ask };
}

test('a texture follows while a slider moves, and rests where it was', async () => {
  const { shown, failed, ask } = await page('torus,resolution=60');
  await ask({ tile: 'dots', stripes: 20 });
  assert.ok(shown[0].pattern, 'at first it is solved');
  for (const stripes of [20.2, 20.4, 20.6]) await ask({ tile: 'dots', stripes }, true);
  await ask({ tile: 'dots', stripes: 20.6 });
  const [solved, , , last, rest] = shown;
  assert.equal(shown.length, 5);
  for (const draft of shown.slice(1, 4)) {
    assert.equal(draft.pattern, undefined);
    assert.equal(draft.kinds.length, solved.kinds.length);
    assert.notDeepEqual(draft.waves, solved.waves);
  }
  // The same input: nothing jumps, and there are metrics and coordinates again.
  assert.deepEqual(rest.waves, last.waves);
  assert.deepEqual(rest.broken, last.broken);
  assert.ok(rest.pattern.energy > 0);
  assert.equal((await rest.pattern.cornerUVs()).length, 6 * rest.kinds.length);
  assert.deepEqual(failed, []);
});

test('another tile is drawn on the same waves, and another sense or surface on waves of its own', async () => {
  const { live, shown, failed, ask } = await page('torus,resolution=60');
  const at = { stripes: 20, field: 'z' };
  await ask({ ...at, tile: 'checker' });
  await ask({ ...at, tile: 'arrows' }, true);
  await ask({ ...at, tile: 'arrows' });
  assert.deepEqual(shown[2].waves, shown[0].waves);
  assert.notEqual(shown[2].tile, shown[0].tile);
  assert.ok(shown[2].broken.words.length > 0 && shown[0].broken.words.length === 0);
  await ask({ ...at, tile: 'arrows', field: 'smooth' }, true);
  assert.ok(shown[3].pattern, 'lines have no sense to go on with');
  await ask({ stripes: 20 });
  assert.ok(shown[4].phases);
  await ask({ ...at, tile: 'arrows' }, true);
  assert.deepEqual(shown[5].waves, shown[0].waves, 'nothing is left of what was before the stripes');
  await live.take((brindle) => brindle.shape('sphere,resolution=16'));
  await ask({ ...at, tile: 'arrows' }, true);
  assert.ok(shown[6].pattern && shown[6].kinds.length !== shown[5].kinds.length);
  assert.deepEqual(failed, []);
});
