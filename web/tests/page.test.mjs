// The page in a real browser without a window. BRINDLE_PAGE is its folder; pictures of it go to
// BRINDLE_SHOTS, if that is given.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../serve.mjs';
import { box, objOf } from './box.mjs';
import { complaintsOf, openBrowser } from './browser.mjs';

const shots = process.env.BRINDLE_SHOTS;
const scratch = mkdtempSync(join(tmpdir(), 'brindle-page-'));
let server, address, browser, close, page, complaints;

before(async () => {
  ({ server, address } = await serve(process.env.BRINDLE_PAGE));
  ({ browser, close } = await openBrowser());
});
after(async () => {
  await close?.();
  server?.close();
  rmSync(scratch, { recursive: true, force: true });
});

// A new page, which must not complain.
async function visit({ hash = '#shape=torus', width = 760, height = 620, ...viewport } = {}) {
  await page?.close();
  page = await browser.newPage();
  complaints = complaintsOf(page);
  page.on('request', (request) => {
    if (!request.url().startsWith(address) && !/^(blob|data):/.test(request.url())) complaints.push(`foreign host: ${request.url()}`);
  });
  page.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()} ${response.url()}`);
  });
  await page.setViewport({ width, height, ...viewport });
  await page.goto(address + hash);
  await ready();
}

// Computed, drawn, and nothing more to come.
async function ready() {
  const failed = await page.evaluate(() => document.querySelector('#message:not(.note):not([hidden])')?.textContent);
  assert.equal(failed ?? null, null);
  await page.waitForFunction(() => document.body.dataset.state === 'ready' &&
    (document.getElementById('metrics').textContent !== '' || !document.getElementById('message').hidden), { timeout: 30000 });
  await page.evaluate(() => new Promise((done) => setTimeout(done, 400)));
  await page.waitForFunction(() => document.body.dataset.state === 'ready', { timeout: 30000 });
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

const metrics = () => page.$eval('#metrics', (e) => e.textContent);
const without = (text) => text.replace(/[\d,]+ ms/, '');
// The browser may have thrown away what was drawn by the time it is asked: a screenshot has not.
const screenshot = async (name) => {
  const bytes = await page.screenshot();
  if (shots) {
    mkdirSync(shots, { recursive: true });
    writeFileSync(join(shots, `${name}.png`), bytes);
  }
  return Buffer.from(bytes).toString('base64');
};
const canvasShot = async () => Buffer.from(await (await page.$('#canvas')).screenshot()).toString('base64');

const slide = (name, value) => page.$eval(`[name="${name}"]`, (input, to) => {
  input.value = to;
  input.dispatchEvent(new Event('input', { bubbles: true }));
}, value);

const drop = (text, name) => page.evaluate((content, file) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([content], file));
  for (const type of ['dragenter', 'dragover', 'drop']) {
    document.body.dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }
}, text, name);

// A bumpy sheet of n x n squares.
function sheet(n) {
  const rows = [];
  for (let y = 0; y <= n; ++y) for (let x = 0; x <= n; ++x) rows.push(`v ${x / n} ${y / n} ${0.1 * Math.sin(9 * x / n) * Math.sin(7 * y / n)}`);
  for (let y = 0; y < n; ++y) {
    for (let x = 0; x < n; ++x) {
      const a = y * (n + 1) + x + 1;
      rows.push(`f ${a} ${a + 1} ${a + n + 2} ${a + n + 1}`);
    }
  }
  return `${rows.join('\n')}\n`;
}

// A ball of n bands, each of 2 n squares, with small holes at its poles.
function ball(n) {
  const rows = [];
  for (let y = 0; y <= n; ++y) {
    for (let x = 0; x < 2 * n; ++x) {
      const [t, p] = [Math.PI * (y + 0.001) / (n + 0.002), Math.PI * x / n];
      rows.push(`v ${Math.sin(t) * Math.cos(p)} ${Math.sin(t) * Math.sin(p)} ${Math.cos(t)}`);
    }
  }
  for (let y = 0; y < n; ++y) {
    for (let x = 0; x < 2 * n; ++x) {
      const [a, b] = [x, (x + 1) % (2 * n)].map((column) => 2 * n * y + column + 1);
      rows.push(`f ${a} ${a + 2 * n} ${b + 2 * n} ${b}`);
    }
  }
  return `${rows.join('\n')}\n`;
}

// A flat one with vectors that turn round its middle, half as long noise, and a hole in the data.
function noisySheet(n) {
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647 - 0.5;
  const points = [], faces = [], vectors = [];
  for (let y = 0; y <= n; ++y) {
    for (let x = 0; x <= n; ++x) {
      const [u, v] = [x / n - 0.5, y / n - 0.5], length = Math.hypot(u, v) || 1;
      points.push(`${u} ${v} 0`);
      vectors.push(Math.hypot(u - 0.2, v - 0.1) < 0.06 ? 'nan nan nan' : `${-v / length + 1.6 * random()} ${u / length + 1.6 * random()} 0`);
    }
  }
  for (let y = 0; y < n; ++y) {
    for (let x = 0; x < n; ++x) {
      const a = y * (n + 1) + x;
      faces.push(`3 ${a} ${a + 1} ${a + n + 2}`, `3 ${a} ${a + n + 2} ${a + n + 1}`);
    }
  }
  return `# vtk DataFile Version 3.0\ndata\nASCII\nDATASET POLYDATA\nPOINTS ${points.length} float\n${points.join('\n')}\n` +
    `POLYGONS ${faces.length} ${4 * faces.length}\n${faces.join('\n')}\nPOINT_DATA ${points.length}\nVECTORS flow float\n${vectors.join('\n')}\n`;
}

test('the page opens on a striped surface, without a complaint', async () => {
  await visit({ hash: '', width: 1200, height: 800 });
  assert.match(await metrics(), /64,960 triangles.*branches.*energy.*ms/);
  await screenshot('light');
  const shot = await canvasShot();
  assert.ok(shot.length > 40000, 'the picture is not empty');
  assert.deepEqual(complaints, []);
});

test('a slider changes picture, metrics and link', async () => {
  await visit();
  const seen = await canvasShot(), said = without(await metrics());
  await slide('stripes', 90);
  await ready();
  assert.notEqual(await canvasShot(), seen);
  assert.notEqual(without(await metrics()), said);
  assert.match(page.url(), /#.*stripes=90/);
  await slide('slack', 50);
  await ready();
  assert.match(page.url(), /slack=50/);
  await slide('width', 20);
  await page.click('[name="branches"]');
  await screenshot('branches');
  assert.deepEqual(complaints, []);
});

test('warnings name the controls, and subdividing helps', async () => {
  await visit({ hash: '#shape=torus' });
  const warnings = () => page.$eval('#warnings', (e) => e.textContent);
  assert.equal(await warnings(), '');
  await drop(ball(6), 'ball.obj');
  await page.waitForFunction(() => /144 triangles/.test(document.getElementById('metrics').textContent), { timeout: 30000 });
  await slide('stripes', 24);
  await ready();
  const said = await warnings();
  assert.match(said, /take a lower Number; .*or Subdivide [123]\.$/);
  await screenshot('warned');
  const times = Number(/Subdivide (\d)/.exec(said)[1]);
  await slide('subdivide', times);
  await page.waitForFunction((count) => document.getElementById('metrics').textContent.replaceAll(',', '').includes(`${count} triangles`),
                             { timeout: 30000 }, 144 * 4 ** times);
  await ready();
  assert.equal(await warnings(), '');
  assert.match(page.url(), new RegExp(`subdivide=${times}`));
  await screenshot('subdivided');
  assert.deepEqual(complaints, []);
});

test('a link carries the settings', async () => {
  await visit({ hash: '#shape=torus&field=x&stripes=60&rotate=30&nonsense=1&width=abc' });
  const values = await page.$$eval('[name]', (inputs) => Object.fromEntries(inputs.map((i) => [i.name, i.value])));
  assert.deepEqual([values.shape, values.field, values.stripes, values.rotate, values.width], ['torus', 'x', '60', '30', '50']);
  const first = without(await metrics());
  await visit({ hash: new URL(page.url()).hash });
  assert.equal(without(await metrics()), first);
  assert.deepEqual(complaints, []);
});

test('a mesh is dropped, and a damaged one refused with nothing lost', async () => {
  await visit();
  await drop(sheet(40), 'sheet.obj');
  await page.waitForFunction(() => /3,200 triangles/.test(document.getElementById('metrics').textContent), { timeout: 30000 });
  await ready();
  const said = await metrics(), seen = await canvasShot();
  await screenshot('dropped');
  await drop('v 0 0 0\nv 1 x 0\n', 'damaged.obj');
  await page.waitForFunction(() => !document.getElementById('message').hidden);
  assert.match(await page.$eval('#message', (e) => e.textContent), /damaged\.obj:2: /);
  await screenshot('refused');
  await page.click('#message button');
  await page.evaluate(() => new Promise((done) => setTimeout(done, 700)));  // the bar of work fades
  assert.equal(await metrics(), said);
  assert.equal(await canvasShot(), seen);
  await slide('stripes', 20);
  await ready();
  assert.notEqual(await metrics(), said);
  assert.deepEqual(complaints, []);
});

test('a part that is dropped has straight stripes on every face', async () => {
  await visit({ hash: '#shape=torus&stripes=16' });
  await drop(objOf(box(8)), 'box.obj');
  await page.waitForFunction(() => /2,816 triangles/.test(document.getElementById('metrics').textContent), { timeout: 30000 });
  await ready();
  assert.match(await metrics(), /(^|\D)0 branches/);
  await screenshot('part');
  assert.deepEqual(complaints, []);
});

test('vectors of a dropped mesh are directions, seen as finely as one likes', async () => {
  await visit({ width: 1200, height: 800 });
  assert.equal(await page.$eval('#detailed', (e) => e.hidden), true);
  await drop(noisySheet(60), 'flow.vtk');
  await page.waitForFunction(() => /7,200 triangles/.test(document.getElementById('metrics').textContent), { timeout: 30000 });
  await ready();
  assert.deepEqual(await page.$$eval('#field optgroup option', (options) => options.map((o) => o.value)), ['array:flow']);
  assert.equal(await page.$eval('[name="detail"]', (e) => e.disabled), true);
  await page.select('#field', 'array:flow');
  await slide('stripes', 30);
  await ready();
  const branches = async () => Number(/([\d,]+) branch/.exec(await metrics())[1].replace(',', ''));
  const noisy = await branches();
  await screenshot('data');
  await slide('detail', 2);
  await ready();
  const calm = await branches();
  await screenshot('data_detail');
  assert.ok(calm < 0.5 * noisy, `${noisy} branches, then ${calm}`);
  await page.select('#tile', 'arrows');
  await ready();
  await screenshot('data_arrows');
  // Another mesh with an array of this name keeps the choice, one without it does not.
  await drop(noisySheet(20), 'coarse.vtk');
  await page.waitForFunction(() => /800 triangles/.test(document.getElementById('metrics').textContent), { timeout: 30000 });
  await ready();
  assert.equal(await page.$eval('#field', (e) => e.value), 'array:flow');
  await drop(noisySheet(30).replace('VECTORS flow', 'VECTORS wind'), 'wind.vtk');
  await page.waitForFunction(() => /1,800 triangles/.test(document.getElementById('metrics').textContent), { timeout: 30000 });
  await ready();
  assert.equal(await page.$eval('#field', (e) => e.value), 'smooth');
  await page.select('#shape', 'torus');
  await ready();
  assert.deepEqual(await page.$$eval('#field option', (options) => options.map((o) => o.value)), ['smooth', 'curvature', 'edges', 'x', 'y', 'z']);
  assert.equal(await page.$eval('#field', (e) => e.value), 'smooth');
  assert.equal(await page.$eval('#detailed', (e) => e.hidden), true);
  assert.deepEqual(complaints, []);
});

test('strokes end where the surface ends', async () => {
  const link = async (hash, ...places) => {
    await visit({ hash, width: 900, height: 640 });
    await page.click('#brush');
    const box = await (await page.$('#canvas')).boundingBox(), side = 0.5 * Math.min(box.width, box.height);
    const to = ([x, y]) => [box.x + box.width / 2 + x * side, box.y + box.height / 2 + y * side];
    await page.mouse.move(...to(places[0]));
    await page.mouse.down();
    for (const place of places.slice(1)) await page.mouse.move(...to(place), { steps: 10 });
    await screenshot('strokes_end');
    await page.mouse.up();
    await page.waitForFunction(() => !document.getElementById('unbrush').disabled);
    await ready();
    assert.deepEqual(complaints, []);
    return page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('strokes').split('~').length);
  };
  // Through the hole, past the rim and back, and over the surface alone.
  assert.equal(await link('#shape=torus&stripes=30', [-0.6, 0], [0.6, 0]), 2);
  assert.equal(await link('#shape=sphere&stripes=30', [0.5, -0.1], [1.4, 0], [0.5, 0.1]), 2);
  assert.equal(await link('#shape=sphere&stripes=30', [-0.5, -0.1], [0.5, 0.1]), 1);
});

test('a stroke changes the field, and can be taken back', async () => {
  await visit({ hash: '#shape=sphere&stripes=30', width: 900, height: 640 });
  const said = without(await metrics());
  await page.click('#brush');
  assert.equal(await page.$eval('#brush', (e) => e.getAttribute('aria-pressed')), 'true');
  const box = await (await page.$('#canvas')).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const side = 0.5 * Math.min(box.width, box.height);
  await page.mouse.move(x - 0.5 * side, y - 0.2 * side);
  await page.mouse.down();
  for (let i = 0; i <= 10; ++i) await page.mouse.move(x + (0.1 * i - 0.5) * side, y + (0.04 * i - 0.2) * side);
  await screenshot('stroke');
  await page.mouse.up();
  await page.waitForFunction(() => !document.getElementById('unbrush').disabled);
  await ready();
  const combed = without(await metrics());
  assert.notEqual(combed, said);
  await screenshot('stroked');
  const link = await page.evaluate(() => location.hash);
  await page.click('#unbrush');
  await ready();
  assert.equal(await page.evaluate(() => location.hash), '#shape=sphere&stripes=30');
  assert.deepEqual(complaints, []);
  await visit({ hash: link, width: 900, height: 640 });
  // What was there before the stroke does not travel: the pattern follows the one that was seen last.
  const energy = (text) => Number(/([\d.]+) energy/.exec(text)[1]);
  assert.notEqual(without(await metrics()), said);
  assert.ok(Math.abs(energy(await metrics()) / energy(combed) - 1) < 0.25);
  assert.equal(await page.evaluate(() => location.hash), link);
  assert.equal(await page.$eval('#unbrush', (e) => e.disabled), false);
  // Strokes are those of one shape.
  await page.select('#shape', 'torus');
  await ready();
  assert.equal(await page.evaluate(() => location.hash), '#shape=torus&stripes=30');
  assert.equal(await page.$eval('#unbrush', (e) => e.disabled), true);
  for (const strokes of ['1.2.3.4.5', '1.2.x.4.5.6', '~~', '1e9.0.0.1.1.1']) {
    await visit({ hash: `#shape=sphere&stripes=30&strokes=${strokes}` });
    assert.equal(without(await metrics()), said);
    assert.deepEqual(complaints, []);
  }
});

test('downloads are whole files', async () => {
  const folder = join(scratch, 'downloads');
  mkdirSync(folder, { recursive: true });
  await visit({ hash: '#shape=torus&stripes=20' });
  const client = await page.createCDPSession();
  await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: folder, eventsEnabled: true });
  for (const [kind, check] of [
    ['png', (b) => b.subarray(1, 4).toString() === 'PNG'], ['svg', (b) => /<svg[^]*<path[^]*<\/svg>/.test(b.toString())],
    ['obj', (b) => /^l \d/m.test(b.toString())], ['glb', (b) => b.readUInt32LE(0) === 0x46546c67 && b.readUInt32LE(8) === b.length]]) {
    await page.click(`[data-save="${kind}"]`);
    for (let i = 0; i < 100 && !readdirSync(folder).includes(`torus.${kind}`); ++i) await new Promise((d) => setTimeout(d, 100));
    assert.ok(check(readFileSync(join(folder, `torus.${kind}`))), kind);
  }
  if (shots) for (const kind of ['png', 'svg']) writeFileSync(join(shots, `download.${kind}`), readFileSync(join(folder, `torus.${kind}`)));
  assert.deepEqual(complaints, []);
});

test('tiles are drawn in the place of stripes, and travel in links', async () => {
  await visit({ hash: '#shape=torus&field=z&stripes=24' });
  const ofStripes = without(await metrics()), drawn = new Set([await canvasShot()]);
  for (const tile of ['checker', 'dots', 'arrows', 'bricks', 'hatch', 'plus', 'plusminus']) {
    await page.select('#tile', tile);
    await ready();
    assert.match(page.url(), new RegExp(`tile=${tile}(&|$)`));
    drawn.add(await canvasShot());
    await screenshot(`tile_${tile}`);
    assert.equal(await page.$eval('[name="width"]', (e) => e.disabled) && await page.$eval('[data-save="svg"]', (e) => e.disabled), true);
  }
  assert.equal(drawn.size, 8);
  assert.match(await page.$eval('#canvas', (e) => e.getAttribute('aria-label')), /rows of plus and minus/);
  const link = await page.evaluate(() => location.hash), said = without(await metrics());
  await slide('stripes', 12);
  await ready();
  assert.notEqual(without(await metrics()), said);
  await visit({ hash: link });
  assert.equal(without(await metrics()), said);
  await page.select('#tile', 'stripes');
  await ready();
  assert.equal(without(await metrics()), ofStripes);
  assert.equal(await page.$eval('[name="width"]', (e) => e.disabled), false);
  assert.deepEqual(complaints, []);
});

test('every item of the gallery is a link to settings that the page shows', async () => {
  await visit({ hash: '#shape=torus&width=80&rotate=10', width: 1000, height: 700 });
  const items = await page.$$eval('#gallery a', (links) => links.map((a) => [a.textContent, a.hash]));
  assert.ok(items.length >= 6);
  const drawn = new Set();
  for (const [name, hash] of items) {
    await page.evaluate((text) => [...document.querySelectorAll('#gallery a')].find((a) => a.textContent === text).click(), name);
    await ready();
    // All of them are settings, and nothing of those before is left.
    assert.deepEqual(new Set(new URLSearchParams(await page.evaluate(() => location.hash.slice(1)))), new Set(new URLSearchParams(hash.slice(1))));
    assert.deepEqual(await page.$$eval('#gallery [aria-current="true"]', (links) => links.map((a) => a.textContent)), [name]);
    drawn.add(await canvasShot());
    await screenshot(`gallery_${name.toLowerCase()}`);
  }
  assert.equal(drawn.size, items.length);
  await page.select('#shape', 'plane');
  await ready();
  assert.equal(await page.$$eval('#gallery [aria-current]', (links) => links.length), 0);
  assert.deepEqual(complaints, []);
});

test('keys alone reach and change everything', async () => {
  await visit();
  const reached = [];
  for (let i = 0; i < 34; ++i) {
    await page.keyboard.press('Tab');
    reached.push(await page.evaluate(() => document.activeElement.name || document.activeElement.id || document.activeElement.dataset.save || document.activeElement.hash || ''));
  }
  for (const name of ['canvas', 'shape', 'file', 'subdivide', 'field', 'rotate', 'brush', 'tile', 'stripes', 'width', 'slack', 'branches', 'png', 'svg', 'obj', 'glb', 'link']) {
    assert.ok(reached.includes(name), `${name} is not reached: ${reached}`);
  }
  assert.equal(new Set(reached.filter((name) => name.startsWith('#'))).size, await page.$$eval('#gallery a', (links) => links.length));
  await page.focus('#canvas');
  for (const key of ['ArrowLeft', 'ArrowUp', '+', 'Home']) {
    const seen = await canvasShot();
    await page.keyboard.press(key);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    assert.notEqual(await canvasShot(), seen, key);
  }
  const said = without(await metrics());
  await page.focus('[name="stripes"]');
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
  await ready();
  assert.notEqual(without(await metrics()), said);
});

test('every control has a name that is read out', async () => {
  await visit();
  const tree = await page.accessibility.snapshot({ interestingOnly: true });
  const nameless = [];
  const walk = (node) => {
    if (['link', 'button', 'slider', 'combobox', 'checkbox', 'img', 'textbox'].includes(node.role) && !node.name) nameless.push(node);
    (node.children ?? []).forEach(walk);
  };
  walk(tree);
  assert.deepEqual(nameless, []);
});

for (const [name, view] of [['phone', { width: 320, height: 640, deviceScaleFactor: 2, isMobile: true, hasTouch: true }],
                            ['4k', { width: 3840, height: 2160 }], ['small', { width: 800, height: 500 }]]) {
  test(`nothing is cut off in a window of ${view.width} pixels`, async () => {
    await visit(view);
    const wide = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
    assert.ok(wide[0] <= wide[1], `${wide}`);
    const out = await page.$$eval('button, select, input, output', (list) => list.filter((e) => {
      const box = e.getBoundingClientRect();
      return box.width > 1 && e.offsetParent && (box.left < 0 || box.right > innerWidth + 0.5);
    }).map((e) => e.id || e.name));
    assert.deepEqual(out, []);
    await screenshot(name);
    assert.deepEqual(complaints, []);
  });
}

test('dark pages are dark', async () => {
  await visit({ hash: '#shape=molecule&field=edges&stripes=70', width: 1200, height: 800 });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'dark' }]);
  const ink = await page.evaluate(() => getComputedStyle(document.body).color);
  assert.match(ink, /rgb\(2\d\d/);
  await screenshot('dark');
});

test('without WebGL 2 the page says so', async () => {
  await page?.close();
  page = await browser.newPage();
  await page.evaluateOnNewDocument(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto(address);
  await page.waitForFunction(() => !document.getElementById('unable').hidden);
  assert.match(await page.$eval('#unable', (e) => e.textContent), /WebGL/);
  await screenshot('unable');
});
