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

// The phase is known where the triangle covers the pixel; its centre is where neighbours that share
// the pixel agree. This is the way from one to the other.
vec2 way_to_centre() {
  return gl_FragCoord.xy - (0.5 * clip_position.xy / clip_position.z + 0.5) * target_size;
}

// Phi / 2 pi at the pixel's centre.
float turns_at_centre(FragmentWave fragment) {
  return atan(fragment.z.y, fragment.z.x) / kTurn + dot(fragment.turns_per_pixel, way_to_centre());
}

float stripe_coverage(FragmentWave fragment) {
  if (fragment.z == vec2(0.0)) return stripe_width;
  return covered_share(turns_at_centre(fragment) - 0.25, length(fragment.turns_per_pixel),
                       stripe_width);
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

void main() {
  vec3 surface = surface_color();
  vec3 normal = gl_FrontFacing ? view_normal : -view_normal;
  color = vec4(shading ? lit(surface, normal, view_position, up) : surface, 1.0);
}
