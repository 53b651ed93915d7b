// Whether a triangle shows at this pixel's middle: only where tiles are opaque. Each pass draws one
// region.

bool is_seen(uint number) {
  vec4 tile;
  SurfacePoint p = surface_point(surface_triangle(number), gl_FragCoord.xy, gl_FragCoord.xy);
  return tile_at(p, tile) && tile.a > 0.5;
}
