// Coverage of a sample by the strokes of a surface, and their colour.

uniform vec3 stroke_colors[2];
uniform vec3 stroke_looks[2];  // opacity, width, pixels between strokes (0: the pattern's own)
uniform bvec4 stroke_follows[2];  // whether widths, opacities and colours depend on values; whether widths are in pixels
uniform vec4 stroke_tones[2];     // tone without strokes, 1 / (none - full), whether tones are in use, least tone
uniform float samples_per_pixel;  // along a side
uniform bool discarded;  // only strokes are drawn, not the surface between them

struct StrokeColor {
  vec3 color;
  float share;  // of the sample
  float opacity;
};

FragmentWave layer_wave(SurfacePoint p, int layer) {
  CornerWave corners[3];
  for (int m = 0; m < 3; ++m) {
    uint v = p.vertices[m];
    vec4 wave = layer == 0 ? wave_of_vertex(v) : second_waves[v];
    vec2 z = layer == 0 ? phase_of(v) : second_phases[v];
    corners[m] = CornerWave(position_of(v), wave.xyz, wave.w, z);
  }
  return fragment_phase(corners, p.barycentric, p.barycentric_dx, p.barycentric_dy);
}

// Strokes of twice the frequency include the existing ones and those midway between them. Where
// strokes are farther apart on the screen than twice the requested distance, those between have
// reached the same width (Praun et al. 2001: strokes of a lighter tone are a subset of those of a
// darker one).
float share_of_levels(float turns, float footprint, float width, bool in_pixels, float spacing) {
  if (!kSpacing) {
    return covered_share(turns, footprint, min(in_pixels ? width * footprint : width, 1.0));
  }
  float level = 0.0, grown = 0.0;
  if (spacing > 0.0) {
    float octaves = max(-log2(max(footprint * spacing, 1e-9)), 0.0);
    level = min(floor(octaves), 8.0);
    grown = octaves - level > 1.0 ? 1.0 : octaves - level;
    grown = smoothstep(0.3, 1.0, grown);
  }
  float finer = exp2(level);
  float own = in_pixels ? width * footprint * finer : width * (1.0 - 0.5 * grown);
  float between = in_pixels ? own * grown : 0.5 * width * grown;
  float share = covered_share(turns * finer, footprint * finer, min(own, 1.0));
  if (between > 0.0) {
    share += covered_share(turns * finer - 0.5, footprint * finer, min(between, 1.0));
  }
  return min(share, 1.0);
}

// Which properties of a layer depend on vertex values, and whether widths are in pixels.
bvec4 follows_of(int layer) {
  bvec4 follows = stroke_follows[layer];
  return bvec4(kFollows && follows.x, kFollows && follows.y, kFollows && follows.z,
               kPixels && follows.w);
}

// The share of the sample that strokes cover, or whether they cover it, by covered_share. `tone` is
// the lightness of the surface.
StrokeColor strokes_at(SurfacePoint p, int layer, float tone) {
  StrokeColor none = StrokeColor(vec3(0.0), 0.0, 0.0);
  FragmentWave wave = layer_wave(p, layer);
  if (wave.direction == vec3(0.0)) return none;
  uint first = 3u * uint(layer);
  bvec4 follows = follows_of(layer);
  float width = follows.x ? style_value(p, first) : stroke_looks[layer].y;
  float opacity = follows.y ? style_value(p, first + 1u) : stroke_looks[layer].x;
  float place = follows.z ? style_value(p, first + 2u) : 0.0;
  if (min(width, min(opacity, place)) <= kNoValue) return none;
  vec4 tones = stroke_tones[layer];
  if (kTones && tones.z > 0.0) {
    width *= mix(tones.w, 1.0, clamp((tones.x - tone) * tones.y, 0.0, 1.0));
  }
  float footprint = length(wave.turns_per_pixel);
  if (follows.w) width *= samples_per_pixel;
  float share = follows.w ? min(width * footprint, 1.0) : clamp(width, 0.0, 1.0);
  if (wave.z != vec2(0.0)) {
    share = share_of_levels(turns_at_centre(wave, p) - 0.25, footprint, width, follows.w,
                            stroke_looks[layer].z * samples_per_pixel);
  }
  vec3 color = follows.z ? scale_color(place) : stroke_colors[layer];
  return StrokeColor(color, share, clamp(opacity, 0.0, 1.0));
}

// Whether the surface is plain here: no wave, or no value for its strokes.
bool is_plain(SurfacePoint p, int layer) {
  for (int m = 0; m < 3; ++m) {
    uint v = p.vertices[m];
    vec4 wave = layer == 0 ? wave_of_vertex(v) : second_waves[v];
    if (wave.xyz == vec3(0.0)) return true;
  }
  uint first = 3u * uint(layer);
  bvec4 follows = follows_of(layer);
  return (follows.x && style_value(p, first) <= kNoValue) ||
         (follows.y && style_value(p, first + 1u) <= kNoValue) ||
         (follows.z && style_value(p, first + 2u) <= kNoValue);
}

// The lightness of a white surface, 0 to 1, perceptually uniform.
float tone_at(SurfacePoint p) {
  vec3 light = lit_here(vec3(1.0), p.view_normal, line_of_sight(p));
  return pow(clamp(dot(light, vec3(0.2126, 0.7152, 0.0722)), 0.0, 1.0), 1.0 / 2.2);
}

// A discarded surface shows strokes only, selected by their shares.
bool pattern_at(inout vec3 surface, SurfacePoint p) {
  float tone = kTones ? tone_at(p) : 0.0;
  bool plain = true;
  for (int layer = 0; layer < kStrokeLayers; ++layer) {
    if (is_plain(p, layer)) continue;
    StrokeColor stroke = strokes_at(p, layer, tone);
    float share = discarded && plain ? 1.0 : stroke.share;
    plain = false;
    surface = mix(surface, stroke.color, share * stroke.opacity);
  }
  return true;
}

// Whether a triangle is visible at the pixel's middle: where strokes are.
bool is_seen(uint number) {
  SurfacePoint p = surface_point(surface_triangle(number), gl_FragCoord.xy, gl_FragCoord.xy);
  float tone = kTones ? tone_at(p) : 0.0;
  for (int layer = 0; layer < kStrokeLayers; ++layer) {
    if (is_plain(p, layer) || strokes_at(p, layer, tone).share > 0.5) return true;
  }
  return false;
}
