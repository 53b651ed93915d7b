// A texture's tiles on the surface.

uniform vec3 stripe_color;

// A quarter more than the phase over 2 pi: `texture_coordinate` of pattern/texture_waves.h. Where a
// phase is undefined, tiles are mixed up beyond all limits.
vec3 with_pattern(vec3 surface, SurfacePoint p) {
  const float kMostTiles = 4.0;
  TextureFragment f = texture_at(p);
  if (f.u.direction == vec3(0.0) || f.v.direction == vec3(0.0)) return surface;
  vec2 uv = vec2(turns_at_centre(f.u, p), turns_at_centre(f.v, p)) + 0.25;
  vec2 dx = vec2(f.u.turns_per_pixel.x, f.v.turns_per_pixel.x);
  vec2 dy = vec2(f.u.turns_per_pixel.y, f.v.turns_per_pixel.y);
  bool defined = f.u.z != vec2(0.0) && f.v.z != vec2(0.0) &&
                 max(length(dx), length(dy)) < kMostTiles;
  if (!defined) {
    uv = vec2(0.0);
    dx = vec2(kMostTiles, 0.0);
    dy = vec2(0.0, kMostTiles);
  }
  Footprint footprint = Footprint(uv, dx, dy);
  float left = 1.0;
  if (kWholeTiles && is_broken(p, uv)) {
    if (!splits_broken_tiles) return surface;
    left = beside_split(p, footprint);
  }
  return with_tile(surface, left * tile_light(stripe_color, footprint));
}
