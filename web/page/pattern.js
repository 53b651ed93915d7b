import { isData } from './settings.js';

// The surface and its pattern, computed in a Worker. The newest request wins: while one runs, only the last
// further one is kept.
export class LivePattern {
  constructor(brindle, { shown, working, failed }) {
    this.brindle = brindle;
    this.call = { shown, working, failed };
    this.wish = null;
    this.busy = false;
    this.mesh = null;  // as it was opened
    this.surface = null;  // the same, every triangle split in four `subdivide` times
    this.subdivide = 0;
    this.strokes = [];
    this.tiles = {};
  }

  /** `settings`, and `draft`: whether further requests follow at once. */
  ask(settings, draft = false) {
    this.wish = { settings: { ...settings }, draft };
    if (!this.busy) this.work();
  }

  async work() {
    this.busy = true;
    this.call.working(true);
    while (this.wish && this.surface) {
      const { settings, draft } = this.wish;
      this.wish = null;
      try {
        await this.follow(settings, draft);
      } catch (error) {
        this.call.failed(error.message);
      }
    }
    this.busy = false;
    this.call.working(false);
  }

  /** A mesh that is made by `make`, every triangle split in four `subdivide` times; if that fails, the old one stays. */
  async take(make, subdivide) {
    const mesh = await this.replace(() => make(this.brindle), subdivide);
    if (mesh) this.strokes = [];
    return mesh;
  }

  /** The same mesh, split so many times. */
  refine(subdivide) {
    return this.replace(() => this.mesh, subdivide);
  }

  async replace(make, subdivide) {
    this.call.working(true);
    try {
      const mesh = await make(), surface = subdivide > 0 ? await mesh.subdivided(subdivide) : mesh;
      const [positions, normals, triangles] =
        [await surface.positions(), await surface.normals(), await surface.triangles()];
      while (this.busy) await new Promise((done) => setTimeout(done, 10));
      const kept = [mesh, surface];
      const old = [this.pattern, this.texture, this.animator, this.followed?.animator, this.surface, this.mesh].filter((object) => !kept.includes(object));
      this.mesh = mesh;
      this.surface = surface;
      this.subdivide = subdivide;
      this.shape = { positions, normals, triangles };
      this.pattern = this.texture = this.animator = this.followed = this.field = this.fieldKey = this.last = null;
      await Promise.all([...new Set(old)].map((object) => object?.dispose()));
      return mesh;
    } catch (error) {
      this.call.failed(error.message);
      return null;
    } finally {
      if (!this.busy) this.call.working(false);
    }
  }

  async fieldFor({ field, rotate, detail, stripes, tile }) {
    // Arrows have a sense, and those that face each other cancel.
    const oriented = isData(field) && tile === 'arrows';
    const seen = isData(field) && detail > 0 ? { stripes, periods: detail, symmetry: oriented ? 1 : 2 } : null;
    const key = JSON.stringify([field, rotate, seen, oriented, this.strokes]);
    if (key === this.fieldKey) return this.field;
    const axis = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] }[field];
    const strokes = this.strokes;
    // Stripes run across a field: turned by 90 degrees, they run along strokes and edges.
    const along = rotate + 90;
    let made;
    if (strokes.length === 0 && isData(field)) made = await this.fieldOfData(field.slice('array:'.length), rotate, seen, oriented);
    else if (strokes.length === 0 && axis) made = await this.surface.projectedField(axis, { rotate });
    else made = await this.surface.smoothField({ rotate: along, strokes, curvature: field === 'curvature' ? 0.1 : 0,
                                         curvatureDirection: 'min', features: field === 'edges' ? 1 : 0 });
    this.fieldKey = key;
    this.field = made;
    return made;
  }

  async fieldOfData(name, rotate, seen, oriented) {
    if (!seen) return this.surface.arrayField(name, { rotate, oriented });
    const { directions } = await this.surface.measuredField(await this.surface.array(name), seen);
    return this.surface.rotatedField(directions, rotate);
  }

  async follow(settings, draft) {
    const begin = performance.now();
    const directions = await this.fieldFor(settings);
    const { stripes } = settings, slack = settings.slack / 100;
    if (settings.tile !== 'stripes') return this.followTexture(settings, directions, draft, begin);
    if (draft && slack === 0) {
      this.animator ??= await this.surface.animator();
      const { phases, vertices } = await this.animator.frame({ directions, stripes, vertices: true });
      this.last = phases;
      this.call.shown({ vertices, milliseconds: performance.now() - begin });
      return;
    }
    const pattern = await this.surface.stripes(directions, { stripes, slack, ...(this.last ? { lastPhases: this.last } : {}) });
    const [phases, frequencies, kinds] =
      [await pattern.phases(), await pattern.frequencies(), await pattern.triangleKinds()];
    await this.keep({ pattern });
    this.last = phases.slice();
    this.call.shown({ directions, frequencies, phases, kinds, pattern, milliseconds: performance.now() - begin });
  }

  /** An animator that continues the shown texture, if it is of the same kind. */
  async textureAnimator({ tile, slack }, oriented) {
    const key = JSON.stringify([tile, slack, oriented]);
    if (!this.texture || this.followed?.key !== key) {
      await this.followed?.animator.dispose();
      this.followed = null;
      if (!this.texture || this.texture.oriented !== oriented) return null;
      const animator = await this.surface.textureAnimator({ tile, oriented, slack: slack / 100 });
      await animator.follow(this.texture);
      this.followed = { key, animator };
    }
    return this.followed.animator;
  }

  async followTexture(settings, directions, draft, begin) {
    const { field, stripes, slack, tile } = settings;
    // Vectors have signs, along which arrows point.
    const oriented = (isData(field) || 'xyz'.includes(field)) && this.strokes.length === 0;
    this.tiles[tile] ??= await this.brindle.tile(tile);
    const key = JSON.stringify([this.fieldKey, stripes, slack, oriented]);
    let texture = this.texture;
    // Another tile only changes the motif on the same waves.
    if (texture?.key !== key) {
      const animator = await this.textureAnimator(settings, oriented);
      if (draft && animator) {
        const { waves, broken, triangleKinds } = await animator.frame({ directions, stripes });
        this.call.shown({ waves, broken, kinds: triangleKinds, tile: this.tiles[tile], milliseconds: performance.now() - begin });
        return;
      }
      texture = animator ? await animator.texture({ directions, stripes })
        : await this.surface.texture(directions, { stripes, slack: slack / 100, oriented });
      Object.assign(texture, { key, oriented });
    }
    const [waves, kinds, broken] = [await texture.waves(), await texture.triangleKinds(), await texture.brokenTiles(tile)];
    await this.keep({ texture });
    this.last = null;
    this.call.shown({ waves, kinds, broken, tile: this.tiles[tile], pattern: texture, milliseconds: performance.now() - begin });
  }

  /** The one of both that is shown. */
  async keep({ pattern = null, texture = null }) {
    const old = [this.pattern, this.texture];
    this.pattern = pattern;
    this.texture = texture;
    await Promise.all(old.filter((object) => object !== pattern && object !== texture).map((object) => object?.dispose()));
  }
}
