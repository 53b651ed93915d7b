// Compiled, never run: the declarations say what callers need.
import createBrindle, { BrindleError, type Curves, type Surface } from 'brindle';
import { createBrindle as createSlim } from 'brindle/slim';
import createStripes, { type Surface as StripedSurface } from 'brindle/stripes';
import { createBrindle as createInWorker } from 'brindle/worker';
import { StripeDrawing, colorOf } from 'brindle/draw';
import { patternFragment } from 'brindle/shaders';
import { Stripes, surfaceInput } from 'brindle/three';
import { Mesh, MeshStandardMaterial, TorusGeometry } from 'three';

async function here(gl: WebGL2RenderingContext): Promise<Curves> {
  const brindle = await createBrindle();
  const surface: Surface = brindle.surface({ positions: [0, 0, 0], triangles: new Uint16Array(3) }, { repair: true, creaseAngle: 40 });
  const split: Uint32Array = brindle.shape('box', { creaseAngle: 30 }).creaseVertices();
  const field = surface.smoothField({ strokes: [{ points: [0, 0, 0, 1, 0, 0], radius: 1 }] });
  const pattern = surface.stripes(field, { stripes: 20, slack: 0.1 });
  const drawing = new StripeDrawing(gl);
  drawing.setSurface({ positions: surface.positions(), normals: surface.normals(), triangles: surface.triangles() });
  drawing.setPattern({ directions: pattern.directions(), frequencies: pattern.frequencies(), phases: pattern.phases() });
  drawing.draw({ ...surface.camera({ azimuth: 10, up: 'z', width: 320, height: 200 }), stripeWidth: 0.3 });
  drawing.draw({ viewFromWorld: [], clipFromView: [], width: 1, height: 1, stripeColor: colorOf('#000000') });
  const measured = surface.measuredField(surface.array(surface.arrays[0].name), { stripes: 20 });
  surface.stripes(surface.arrayField('flow', { rotate: 90, oriented: true })).dispose();
  const said: string[] = [...surface.subdivided(1).stripes(field).warnings, ...surface.texture(field, { tile: 'dots' }).warnings];
  pattern.svg({ camera: surface.camera({ side: 'top', projection: 'orthographic', up: '-z' }), join: true });
  pattern.svg({ camera: { rotation: [0, 0, 0, 1], width: 400 } });
  pattern.curvesFile('vtp');
  // @ts-expect-error a name, not a format
  pattern.curvesFile('curves.vtp');
  surface.stripes(measured.directions).dispose();
  const texture = surface.texture(field, { stripes: 20, oriented: true });
  drawing.setTexture(texture.waves(), brindle.tile('dots'), texture.brokenTiles('dots'));
  const follower = surface.textureAnimator({ oriented: true, tile: 'dots', slack: 0.1 });
  follower.follow(texture);
  const { waves, broken, triangleKinds } = follower.frame({ directions: field, positions: surface.positions(), normals: surface.normals() });
  drawing.setTexture(waves, brindle.tile('dots'), broken, { positions: surface.positions(), normals: surface.normals() });
  drawing.setKinds(triangleKinds);
  // @ts-expect-error an option that is unknown
  surface.stripes(field, { strips: 20 });
  // @ts-expect-error a number, not a text
  surface.stripes(field, { stripes: '20' });
  console.log(said.length, split.length, pattern.creaseSlipMean, pattern.creaseSlipShare?.toFixed(2));
  return pattern.curves({ join: true });
}

async function inThree(): Promise<Mesh> {
  const brindle = await createBrindle();
  const surface: Surface = brindle.surface(surfaceInput(new TorusGeometry()), { repair: true });
  const pattern = surface.stripes(surface.smoothField());
  const stripes = new Stripes(
    { positions: surface.positions(), normals: surface.normals(), triangles: surface.triangles() },
    { directions: pattern.directions(), frequencies: pattern.frequencies(), phases: pattern.phases() }, { color: 'navy' });
  stripes.width = 0.4;
  const { vertices } = surface.animator().frame({ directions: pattern.directions(), vertices: true, corners: new Float32Array(3) });
  if (vertices) stripes.setVertices(vertices);
  return new Mesh(stripes.geometry, stripes.paint(new MeshStandardMaterial()));
}

async function inRealTime(whole: Surface): Promise<Float32Array> {
  const brindle = await createStripes({ wasm: 'stripes.wasm' });
  // What takes a surface of the small module takes one of the whole.
  const surfaces: StripedSurface[] = [brindle.surface({ positions: [0, 0, 0], triangles: [0, 0, 0] }, { repair: true }), whole];
  // @ts-expect-error curves are the whole module's
  surfaces[0].stripes(surfaces[0].smoothField()).curves();
  // @ts-expect-error textures are the whole module's
  surfaces[0].texture(surfaces[0].smoothField());
  return surfaces[0].animator().frame({ directions: surfaces[0].projectedField([0, 0, 1]), stripes: 20 }).phases;
}

async function elsewhere(): Promise<number> {
  const brindle = await createInWorker();
  const surface = await brindle.shape('torus');
  const pattern = await surface.stripes(await surface.smoothField(), { stripes: 20 });
  const other = await surface.stripes(await surface.curvatureField(), { frequency: 2 });
  const { positions } = await pattern.samplesWith(other);
  brindle.terminate();
  return pattern.energy + positions.length + patternFragment.length;
}

export { here, inThree, inRealTime, elsewhere, createSlim, BrindleError };
