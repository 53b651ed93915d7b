// A texture's tiles on the surface.

uniform vec3 stripe_color;

vec3 with_pattern(vec3 surface, SurfacePoint p) {
  Footprint footprint;
  if (!footprint_at(p, vec2(0.0), footprint)) return surface;
  float left = 1.0;
  if (kWholeTiles && is_broken(p, footprint.uv)) {
    if (!splits_broken_tiles) return surface;
    left = beside_split(p, footprint);
  }
  return with_tile(surface, left * tile_light(stripe_color, footprint));
}
