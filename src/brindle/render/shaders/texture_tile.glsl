// The waves U and V of a texture, at three corners per triangle. `texture_fragment` has a twin in
// pattern/texture_waves.cpp.

uniform samplerBuffer texture_u;  // three pairs for every corner: direction, frequency, z
uniform samplerBuffer texture_v;
// 2: compilers that know it write the loop out, and take twice as long, seconds on software renderers.
uniform int wave_count;

// The waves of a texture at a point.
struct TextureFragment {
  FragmentWave u, v;
};

CornerWave corner_of(int wave, vec3 position, int first) {
  bool is_u = wave == 0;
  vec2 a = is_u ? texelFetch(texture_u, first).xy : texelFetch(texture_v, first).xy;
  vec2 b = is_u ? texelFetch(texture_u, first + 1).xy : texelFetch(texture_v, first + 1).xy;
  vec2 z = is_u ? texelFetch(texture_u, first + 2).xy : texelFetch(texture_v, first + 2).xy;
  return CornerWave(position, vec3(a, b.x), b.y, z);
}

TextureFragment texture_at(SurfacePoint p) {
  TextureFragment f;
  for (int wave = 0; wave < wave_count; ++wave) {
    CornerWave corners[3];
    for (int m = 0; m < 3; ++m) {
      corners[m] = corner_of(wave, position_of(p.vertices[m]), 3 * (3 * int(p.triangle) + m));
    }
    FragmentWave fragment =
        split_fragment_phase(corners, p.barycentric, p.barycentric_dx, p.barycentric_dy);
    if (wave == 0) {
      f.u = fragment;
    } else {
      f.v = fragment;
    }
  }
  return f;
}

// The tile, filtered over the whole pixel.

uniform sampler2D tile_colors;     // premultiplied light of a picture, or coverage by a motif
uniform sampler2D tile_distances;  // of a motif, to its border, in tile sides
uniform bool tile_is_motif;

const float kMostSamples = 16.0;

// The position and extent of a pixel in texture coordinates.
struct Footprint {
  vec2 uv;
  vec2 dx, dy;
};

// Where texels are magnified, the distance is more precise: borders stay sharp at any
// magnification.
float motif_from_distance(Footprint f) {
  vec2 step = 1.0 / vec2(textureSize(tile_distances, 0));
  float distance = textureLod(tile_distances, f.uv, 0.0).r;
  vec2 slope = 0.5 / step *
      vec2(textureLod(tile_distances, f.uv + vec2(step.x, 0.0), 0.0).r -
               textureLod(tile_distances, f.uv - vec2(step.x, 0.0), 0.0).r,
           textureLod(tile_distances, f.uv + vec2(0.0, step.y), 0.0).r -
               textureLod(tile_distances, f.uv - vec2(0.0, step.y), 0.0).r);
  float width = length(vec2(dot(slope, f.dx), dot(slope, f.dy)));
  return clamp(0.5 - distance / max(width, 1e-6), 0.0, 1.0);
}

// The mean over the pixel's ellipse in the tile: samples along its longer axis, each as wide as the
// shorter one (Heckbert 1989; like anisotropic filtering on graphics cards, but equal on all of
// them). The extents are derivatives of the waves, so that nothing wraps.
vec4 filtered_tile(Footprint f) {
  vec2 size = vec2(textureSize(tile_colors, 0));
  mat2 texels = mat2(f.dx * size, f.dy * size);
  mat2 square = texels * transpose(texels);
  float mean = 0.5 * (square[0][0] + square[1][1]);
  float apart = length(vec2(0.5 * (square[0][0] - square[1][1]), square[0][1]));
  float longer = sqrt(mean + apart);
  float shorter = sqrt(max(mean - apart, 0.0));
  float samples = clamp(ceil(longer / max(shorter, 1.0)), 1.0, kMostSamples);
  float angle = 0.5 * atan(2.0 * square[0][1], square[0][0] - square[1][1]);
  vec2 axis = longer * vec2(cos(angle), sin(angle)) / size;
  float level = log2(max(max(shorter, longer / samples), 1.0));
  vec4 sum = vec4(0.0);
  for (float k = 0.5; k < samples; k += 1.0) {
    sum += textureLod(tile_colors, f.uv + (k / samples - 0.5) * axis, level);
  }
  return sum / samples;
}

// The tile's premultiplied light and alpha. U and V are phases.
vec4 tile_light(vec3 motif_color, Footprint f) {
  vec4 tile = filtered_tile(f);
  if (!tile_is_motif) return tile;
  float texels = max(length(f.dx), length(f.dy)) * float(textureSize(tile_colors, 0).x);
  float coverage = tile.r;
  if (texels < 1.0) coverage = mix(motif_from_distance(f), tile.r, smoothstep(0.5, 1.0, texels));
  return coverage * vec4(motif_color, 1.0);
}

vec3 with_tile(vec3 surface, vec4 tile) { return tile.rgb + (1.0 - tile.a) * surface; }

// The phase over 2 pi plus a quarter: `texture_coordinate` of pattern/texture_waves.h. Where a
// phase is undefined or changes too fast, the footprint is large: the tile's mean. False without
// waves.
bool footprint_at(SurfacePoint p, vec2 shift, out Footprint footprint) {
  const float kMostTiles = 4.0;
  TextureFragment f = texture_at(p);
  if (f.u.direction == vec3(0.0) || f.v.direction == vec3(0.0)) return false;
  footprint = Footprint(vec2(turns_at_centre(f.u, p), turns_at_centre(f.v, p)) + 0.25 - shift,
                        vec2(f.u.turns_per_pixel.x, f.v.turns_per_pixel.x),
                        vec2(f.u.turns_per_pixel.y, f.v.turns_per_pixel.y));
  if (f.u.z == vec2(0.0) || f.v.z == vec2(0.0) ||
      max(length(footprint.dx), length(footprint.dy)) >= kMostTiles) {
    footprint = Footprint(vec2(0.0), vec2(kMostTiles, 0.0), vec2(0.0, kMostTiles));
  }
  return true;
}
