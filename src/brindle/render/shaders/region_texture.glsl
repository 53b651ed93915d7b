// A texture with different tiles per region. Each pass draws one region.

uniform vec3 motif_color;
uniform vec2 texture_shift;
uniform vec2 region;        // from this value to that
uniform bool first_region;  // also draws parts without a tile
uniform bool discarded;     // only tiles are drawn, not the surface beside them

// A value in the middle of the tile, to first order: tiles are not cut at region borders.
float value_of_tile(SurfacePoint p, Footprint f, uint which) {
  vec3 values;
  for (int m = 0; m < 3; ++m) values[m] = style_values[kStyleValues * p.vertices[m] + which];
  if (min(values.x, min(values.y, values.z)) <= kNoValue) return kNoValue;
  float value = dot(values, p.barycentric);
  mat2 uv_per_pixel = mat2(f.dx, f.dy);
  float area = determinant(uv_per_pixel);
  if (abs(area) < 1e-12) return value;
  vec2 to_middle = floor(f.uv) + 0.5 - f.uv;
  vec2 pixels = inverse(uv_per_pixel) * to_middle;
  return value + dot(vec2(dot(values, p.barycentric_dx), dot(values, p.barycentric_dy)), pixels);
}

// One colour for the whole motif.
vec3 color_of_motif(SurfacePoint p, Footprint f) {
  float place = kMotifPlaces ? value_of_tile(p, f, kPlaceOfMotif) : kNoValue;
  return place > kNoValue ? scale_color(place) : motif_color;
}

// The tile, scaled about its middle.
vec4 decal_light(vec3 motif, Footprint f, float size) {
  vec2 from_middle = f.uv - floor(f.uv) - 0.5;
  vec2 pixel = vec2(length(vec2(f.dx.x, f.dy.x)), length(vec2(f.dx.y, f.dy.y)));
  vec2 inside = clamp((0.5 * size - abs(from_middle)) / max(pixel, 1e-6) + 0.5, 0.0, 1.0);
  Footprint decal = Footprint(from_middle / size + 0.5, f.dx / size, f.dy / size);
  return inside.x * inside.y * tile_light(motif, decal);
}

// The tile's light as in `tile_light`. False in other regions.
bool tile_at(SurfacePoint p, out vec4 tile) {
  tile = vec4(0.0);
  Footprint f;
  if (!footprint_at(p, texture_shift, f)) return first_region;
  float value = kRegions ? value_of_tile(p, f, kValueOfRegion) : region.x;
  if (kRegions && value <= kNoValue) return first_region;
  if (kRegions && (value < region.x || value >= region.y)) return false;
  float left = 1.0;
  if (kWholeTiles && is_broken(p, f.uv)) {
    if (!splits_broken_tiles) return true;
    left = beside_split(p, f);
  }
  float size = kTileSizes ? value_of_tile(p, f, kSizeOfTile) : 1.0;
  if (size >= 1.0) {
    tile = left * tile_light(color_of_motif(p, f), f);
  } else if (size > 1e-3) {
    tile = decal_light(color_of_motif(p, f), f, size);
  }
  return true;
}

// False in other regions.
bool pattern_at(inout vec3 surface, SurfacePoint p) {
  vec4 tile;
  if (!tile_at(p, tile)) return false;
  surface = !discarded ? with_tile(surface, tile) : tile.a > 0.0 ? tile.rgb / tile.a : vec3(0.0);
  return true;
}

// Whether a triangle is visible at the pixel's middle: where tiles are opaque.
bool is_seen(uint number) {
  vec4 tile;
  SurfacePoint p = surface_point(surface_triangle(number), gl_FragCoord.xy, gl_FragCoord.xy);
  return tile_at(p, tile) && tile.a > 0.5;
}
