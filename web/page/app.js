import { createBrindle } from './brindle/worker.js';
import { StripeDrawing } from './brindle/draw.js';
import { Camera, firstHit } from './camera.js';
import { LivePattern } from './pattern.js';
import { Settings } from './settings.js';
import { brushed, distance, leavesSurface, readStrokes, writtenStrokes } from './strokes.js';

const $ = (id) => document.getElementById(id);
const canvas = $('canvas'), body = document.body;
const names = { plane: 'Plane', cylinder: 'Cylinder', tube: 'Tube', sphere: 'Sphere', torus: 'Torus',
                trefoil: 'Trefoil knot', vessels: 'Vessels', molecule: 'Molecule', box: 'Box',
                bracket: 'Bracket', gear: 'Gear',
                hemisphere: 'Hemisphere', mobius: 'Möbius strip', sheets: 'Sheets', pieces: 'Pieces' };
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;

const camera = new Camera();
let drawing = null, turning = !still, wanted = true, opened = '', own = false;

function say(text, isNote = false) {
  const box = $('message');
  box.hidden = text === '';
  box.classList.toggle('note', isNote);
  box.firstElementChild.textContent = text;
}
$('message').lastElementChild.addEventListener('click', () => {
  say('');
  canvas.focus();
});

// ---------------------------------------------------------------------------------------------------
// The picture

const gl = canvas.getContext('webgl2', { antialias: true, alpha: true, powerPreference: 'high-performance' });
try {
  if (gl) drawing = new StripeDrawing(gl);
} catch (error) {
  say(error.message);
}
$('unable').hidden = gl !== null;
canvas.hidden = gl === null;
canvas.addEventListener('webglcontextlost', () => say('The graphics card was taken away; reload the page.'));

function fit() {
  // More pixels than 4K cost time without visible gain.
  const ratio = Math.min(devicePixelRatio, Math.sqrt(3840 * 2160 / Math.max(1, canvas.clientWidth * canvas.clientHeight)));
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width === width && canvas.height === height) return;
  canvas.width = width;
  canvas.height = height;
  wanted = true;
}

function draw() {
  const { width, height } = canvas;
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  const { branches, width: stripeWidth } = settings.values;
  drawing.draw({ ...camera.view(width, height), width, height, branches, stripeWidth: stripeWidth / 100,
                 markSize: 11 * width / canvas.clientWidth });
}

let before = performance.now();
function loop(now) {
  const passed = Math.min(now - before, 100);
  before = now;
  if (turning && drawing?.triangleCount > 0) {
    camera.spin(passed * 0.00025);
    wanted = true;
  }
  fit();
  if (wanted && drawing) {
    wanted = false;
    draw();
  }
  requestAnimationFrame(loop);
}

// ---------------------------------------------------------------------------------------------------
// Computation

const number = new Intl.NumberFormat('en', { maximumFractionDigits: 0 });
let live = null;

function showMetrics({ pattern, milliseconds }) {
  const metrics = [[number.format(live.surface.triangleCount), 'triangles'],
                   [number.format(pattern.branches), pattern.branches === 1 ? 'branch' : 'branches'],
                   [pattern.energy.toFixed(4), 'energy'], [number.format(milliseconds), 'ms']];
  $('metrics').replaceChildren(...metrics.map(([value, what]) => {
    const span = document.createElement('span'), strong = document.createElement('b');
    strong.textContent = value;
    span.append(strong, ` ${what}`);
    return span;
  }));
  $('warnings').textContent = pattern.warnings.filter((warning) => !live.surface.notes.includes(warning)).map((warning) => settings.inWords(warning)).join('\n');
  const { tile, stripes } = settings.values, what = tile === 'stripes' ? 'stripes' : `rows of ${$('tile').selectedOptions[0].text.toLowerCase()}`;
  canvas.setAttribute('aria-label', `${opened} with ${stripes} ${what} along its diagonal, ${pattern.branches} branches`);
}

function shown(result) {
  if (!drawing) return;
  if (result.waves) drawing.setTexture(result.waves, result.tile, result.broken);
  else if (result.vertices) drawing.setVertices(result.vertices);
  else drawing.setPattern(result);
  if (result.kinds) drawing.setKinds(result.kinds);
  if (result.pattern) showMetrics(result);
  wanted = true;
}

const working = (is) => {
  body.dataset.state = is ? 'working' : 'ready';
};

async function open(make, name) {
  const mesh = await live.take(make, settings.values.subdivide);
  if (!mesh) return false;
  opened = name;
  own = !(settings.values.shape in names);
  drawing?.setSurface(live.shape);
  // The bounding ball, which does not change with rotation.
  const { positions } = live.shape, center = drawing?.center ?? [0, 0, 0];
  let radius = 0;
  for (let i = 0; i < positions.length; i += 3) {
    radius = Math.max(radius, Math.hypot(positions[i] - center[0], positions[i + 1] - center[1], positions[i + 2] - center[2]));
  }
  camera.frame(radius);
  live.strokes = own || !settings.strokes ? [] : readStrokes(settings.strokes, live.surface.diagonal);
  settings.strokes = '';
  keepStrokes();
  settings.offer(mesh.arrays.filter(({ components }) => components === 3).map(({ name: array }) => array));
  say(mesh.notes.map((note) => `${note}.`.replace(/\.\.$/, '.')).join('\n'), true);
  live.ask(settings.values);
  return true;
}

async function refine() {
  if (!live?.mesh) return;
  if (await live.refine(settings.values.subdivide)) {
    drawing?.setSurface(live.shape);
    live.ask(settings.values);
  } else {
    settings.put('subdivide', live.subdivide);
    carry();
  }
}

/** Those of a mesh that was dropped are of no use in a link. */
function keepStrokes() {
  $('unbrush').disabled = live.strokes.length === 0;
  settings.strokes = own ? '' : writtenStrokes(live.strokes, live.surface.diagonal);
  carry();
}

const openShape = () => open((brindle) => brindle.shape(settings.values.shape), names[settings.values.shape]);

async function openFile(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const select = $('shape');
  if (!await open((brindle) => brindle.readSurface(bytes, file.name), file.name)) return;
  select.querySelector('[value=""]')?.remove();
  select.prepend(new Option(file.name, '', true, true));
  settings.values.shape = '';
  carry();
}

// ---------------------------------------------------------------------------------------------------
// Controls

let rest = 0;
function follow(name) {
  carry();
  if (name === 'width' || name === 'branches') {
    wanted = true;
    return;
  }
  if (name === 'shape') {
    if (settings.values.shape !== '') openShape();
    return;
  }
  clearTimeout(rest);
  if (name === 'subdivide') {
    rest = setTimeout(refine, 180);
    return;
  }
  live?.ask(settings.values, true);
  rest = setTimeout(() => live?.ask(settings.values), 180);
}

const sorted = (hash) => [...new URLSearchParams(hash.slice(1))].map(String).sort().join('&');
const sameLink = (a, b) => sorted(a) === sorted(b);
function carry() {
  history.replaceState(null, '', location.pathname + location.search + settings.hash());
  for (const link of document.querySelectorAll('#gallery a')) {
    if (sameLink(link.hash, settings.hash())) link.setAttribute('aria-current', 'true');
    else link.removeAttribute('aria-current');
  }
}
const settings = new Settings($('settings'), follow);

$('settings').addEventListener('submit', (event) => event.preventDefault());
$('file').addEventListener('change', ({ target }) => {
  if (target.files[0]) openFile(target.files[0]);
  target.value = '';
});

let over = 0;
addEventListener('dragenter', (event) => {
  event.preventDefault();
  body.classList.toggle('dropping', ++over > 0);
});
addEventListener('dragleave', () => body.classList.toggle('dropping', --over > 0));
addEventListener('dragover', (event) => event.preventDefault());
addEventListener('drop', (event) => {
  event.preventDefault();
  over = 0;
  body.classList.remove('dropping');
  const [file] = event.dataTransfer.files;
  if (file) openFile(file);
});

// ---------------------------------------------------------------------------------------------------
// Mouse, fingers, keys

const fingers = new Map();
let brushing = false, combed = null;  // strokes of this press, which end where the surface ends; lists of points

function brush(isOn) {
  brushing = isOn;
  $('brush').setAttribute('aria-pressed', String(isOn));
  canvas.classList.toggle('brush', isOn);
  if (isOn) turning = false;
}
$('brush').addEventListener('click', () => brush(!brushing));
$('unbrush').addEventListener('click', () => {
  live.strokes = [];
  keepStrokes();
  live.ask(settings.values);
});

function hit([x, y]) {
  const { width, height } = canvas.getBoundingClientRect();
  return live?.shape ? firstHit(camera.ray(x, y, width, height), live.shape, drawing.center) : null;
}

function pixelOf(event) {
  const { left, top } = canvas.getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

const trail = (strokes) => $('trail').firstElementChild.setAttribute('d',
  strokes.filter((stroke) => stroke.length > 1).map((stroke) => `M${stroke.map(({ pixel }) => pixel).join('L')}`).join(''));

function extend(event) {
  const pixel = pixelOf(event), place = hit(pixel), stroke = combed.at(-1), last = stroke.at(-1);
  if (!place) {
    if (last) combed.push([]);
  } else if (last && leavesSurface(last, { pixel, place }, hit)) {
    combed.push([{ pixel, place }]);
  } else if (!last || distance(place, last.place) >= 0.004 * live.surface.diagonal / camera.zoom) {
    stroke.push({ pixel, place });
  }
  trail(combed);
}

function endStrokes() {
  const lines = combed.filter((stroke) => stroke.length > 1).map((stroke) => stroke.flatMap(({ place }) => place));
  if (lines.length > 0) {
    // Rounded as in the link, which then shows the same.
    const { diagonal } = live.surface, strokes = [...live.strokes, ...lines.map((line) => brushed(line, diagonal))];
    live.strokes = readStrokes(writtenStrokes(strokes, diagonal), diagonal);
    keepStrokes();
    live.ask(settings.values);
  }
  combed = null;
  trail([]);
}

canvas.addEventListener('pointerdown', (event) => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, [event.clientX, event.clientY]);
  turning = false;
  if (brushing && fingers.size === 1 && hit(pixelOf(event))) {
    combed = [[]];
    extend(event);
  }
});
canvas.addEventListener('pointermove', (event) => {
  const last = fingers.get(event.pointerId);
  if (!last) return;
  const place = [event.clientX, event.clientY];
  if (combed) return extend(event);
  const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
  if (other) {
    const apart = (a) => Math.hypot(a[0] - other[0], a[1] - other[1]);
    camera.zoomBy(apart(place) / Math.max(1, apart(last)));
  }
  const share = other ? 0.5 : 1;
  camera.drag(share * (place[0] - last[0]), share * (place[1] - last[1]), Math.min(canvas.clientWidth, canvas.clientHeight));
  fingers.set(event.pointerId, place);
  wanted = true;
});
for (const name of ['pointerup', 'pointercancel']) {
  canvas.addEventListener(name, (event) => {
    fingers.delete(event.pointerId);
    if (combed) endStrokes();
  });
}
canvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  camera.zoomBy(Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)));
  wanted = true;
}, { passive: false });

const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
canvas.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (steps[event.key]) camera.drag(...steps[event.key].map((c) => 40 * c), 1000);
  else if (event.key === '+' || event.key === '=') camera.zoomBy(1.15);
  else if (event.key === '-') camera.zoomBy(1 / 1.15);
  else if (event.key === 'Home') camera.reset();
  else if (event.key === ' ') turning = !turning;
  else return;
  if (event.key !== ' ') turning = false;
  event.preventDefault();
  wanted = true;
});

// ---------------------------------------------------------------------------------------------------
// Files

function save(content, type, extension) {
  const name = `${(opened || 'stripes').toLowerCase().replace(/\.[a-z]+$/, '').replace(/[^a-z0-9]+/g, '-')}.${extension}`;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const savers = {
  png: () => new Promise((done) => {
    draw();
    canvas.toBlob((blob) => done(save(blob, 'image/png', 'png')));
  }),
  svg: async () => save(await live.pattern.svg({ camera: { rotation: camera.rotation, zoom: camera.zoom, width: 1200, height: 900 }, fair: 0.25 }),
                        'image/svg+xml', 'svg'),
  obj: async () => save(await live.pattern.curvesFile('obj'), 'model/obj', 'obj'),
  glb: async () => {
    const texture = live.texture ??
      await live.surface.texture(live.field, { stripes: settings.values.stripes, slack: settings.values.slack / 100 });
    save(await texture.glb(), 'model/gltf-binary', 'glb');
    if (texture !== live.texture) await texture.dispose();
  },
};
for (const button of document.querySelectorAll('[data-save]')) {
  button.addEventListener('click', async () => {
    if (!live?.pattern && !live?.texture) return;
    working(true);
    try {
      await savers[button.dataset.save]();
    } catch (error) {
      say(error.message);
    }
    working(live.busy);
  });
}
$('link').addEventListener('click', async ({ target }) => {
  try {
    await navigator.clipboard.writeText(location.href);
    target.textContent = own || settings.values.shape === '' ? 'Copied, without the mesh' : 'Copied';
  } catch {
    target.textContent = 'Copy it from the address bar';
  }
  setTimeout(() => { target.textContent = 'Copy link'; }, 2000);
});

// ---------------------------------------------------------------------------------------------------

async function begin() {
  $('shape').replaceChildren(...Object.entries(names).map(([value, text]) => new Option(text, value)));
  $('shape').value = settings.values.shape;
  settings.read(location.hash);
  requestAnimationFrame(loop);
  try {
    const brindle = await createBrindle({ worker: new Worker('host.js', { type: 'module' }) });
    live = new LivePattern(brindle, { shown, working, failed: say });
    await openShape();
  } catch (error) {
    say(`The page could not start: ${error.message}`);
    body.dataset.state = 'failed';
  }
}
addEventListener('hashchange', () => {
  settings.read(location.hash);
  follow('shape');
});
begin();
