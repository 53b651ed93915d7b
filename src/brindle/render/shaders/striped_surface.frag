// The lit surface with its stripes, in linear light.

uniform bool has_waves;
uniform bool has_texture;
uniform bool has_triangle_colors;
uniform bool shading;
uniform vec3 base_color;
uniform vec3 stripe_color;
uniform float stripe_width;  // share of the period
uniform vec3 up;             // of the world, seen from the camera
uniform vec2 target_size;    // in pixels

layout(location = 0) out vec4 color;

// The integral of a tent from -1 to t.
float tent_integral(float t) {
  float s = clamp(t, -1.0, 1.0);
  return s < 0.0 ? 0.5 * (1.0 + s) * (1.0 + s) : 1.0 - 0.5 * (1.0 - s) * (1.0 - s);
}

// The phase is known where the triangle covers the pixel; its centre is where neighbours that share
// the pixel agree. This is the way from one to the other.
vec2 way_to_centre() {
  return gl_FragCoord.xy - (0.5 * clip_position.xy / clip_position.z + 0.5) * target_size;
}

// Phi / 2 pi at the pixel's centre.
float turns_at_centre(FragmentWave fragment) {
  return atan(fragment.z.y, fragment.z.x) / kTurn + dot(fragment.turns_per_pixel, way_to_centre());
}

// How much of a pixel a stripe covers: the periodic pulse around Phi = pi/2, which a flip
// (pi - Phi) leaves alone, filtered with a tent as wide as two pixels (a box filter, twice). Where
// stripes are finer than that, their mean remains.
float stripe_coverage(FragmentWave fragment) {
  float footprint = max(length(fragment.turns_per_pixel), 1e-6);
  if (fragment.z == vec2(0.0) || footprint > 1.5) return stripe_width;
  float u = turns_at_centre(fragment) - 0.25;
  u -= floor(u + 0.5);
  float coverage = 0.0;
  for (float period = -2.0; period <= 2.0; period += 1.0) {
    coverage += tent_integral((u - period + 0.5 * stripe_width) / footprint) -
                tent_integral((u - period - 0.5 * stripe_width) / footprint);
  }
  return mix(coverage, stripe_width, smoothstep(0.75, 1.25, footprint));
}

vec3 linear_light(vec3 srgb) {
  return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThan(srgb, vec3(0.04045)));
}

// A quarter more than the phase over 2 pi: `texture_coordinate` of pattern/texture_waves.h. Where a
// phase is undefined, tiles are mixed up beyond all limits.
vec3 textured(vec3 surface) {
  const float kMostTiles = 4.0;
  TextureFragment f = texture_here();
  if (f.u.direction == vec3(0.0) || f.v.direction == vec3(0.0)) return surface;
  vec2 uv = vec2(turns_at_centre(f.u), turns_at_centre(f.v)) + 0.25;
  vec2 dx = vec2(f.u.turns_per_pixel.x, f.v.turns_per_pixel.x);
  vec2 dy = vec2(f.u.turns_per_pixel.y, f.v.turns_per_pixel.y);
  bool defined = f.u.z != vec2(0.0) && f.v.z != vec2(0.0) &&
                 max(length(dx), length(dy)) < kMostTiles;
  if (!defined) {
    uv = vec2(0.0);
    dx = vec2(kMostTiles, 0.0);
    dy = vec2(0.0, kMostTiles);
  }
  return with_tile(surface, stripe_color, Footprint(uv, dx, dy));
}

vec3 surface_color() {
  vec3 surface = base_color;
  if (has_texture) {
    surface = textured(surface);
  } else if (has_waves) {
    FragmentWave fragment = wave_here();
    if (fragment.direction != vec3(0.0)) {
      surface = mix(surface, stripe_color, stripe_coverage(fragment));
    }
  }
  if (has_triangle_colors) {
    vec4 paint = unpackUnorm4x8(triangle_colors[triangle]);
    surface = mix(surface, linear_light(paint.rgb), paint.a);
  }
  return surface;
}

// A soft key light from the upper left, a weak fill from the right, light from the sky and off the
// ground, and a thin rim. Both sides look alike: a surface may have but one.
vec3 lit(vec3 surface) {
  vec3 n = normalize(gl_FrontFacing ? view_normal : -view_normal);
  vec3 v = normalize(-view_position);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 key_from = normalize(vec3(-0.45, 0.70, 0.75));
  vec3 fill_from = normalize(vec3(0.85, 0.05, 0.50));
  float key = clamp((dot(n, key_from) + 0.25) / 1.25, 0.0, 1.0);
  float fill = clamp((dot(n, fill_from) + 0.40) / 1.40, 0.0, 1.0);
  float sky = 0.5 + 0.5 * dot(n, up);
  vec3 light = key * vec3(0.66, 0.64, 0.61) + fill * vec3(0.12, 0.13, 0.15) +
               mix(vec3(0.17, 0.165, 0.16), vec3(0.30, 0.31, 0.33), sky);
  light *= mix(0.62, 1.0, smoothstep(0.0, 0.55, facing));
  float gloss = pow(clamp(dot(n, normalize(key_from + v)), 0.0, 1.0), 40.0);
  vec3 reflected = surface * light + vec3(0.035 * gloss);
  reflected += vec3(0.03) * pow(1.0 - facing, 4.0) * sky;
  return reflected;
}

void main() {
  vec3 surface = surface_color();
  color = vec4(shading ? lit(surface) : surface, 1.0);
}
