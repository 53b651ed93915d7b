// Stripes on the surface.

uniform vec3 stripe_color;
uniform float stripe_width;  // share of the period

float stripe_coverage(FragmentWave wave, SurfacePoint p) {
  if (wave.z == vec2(0.0)) return stripe_width;
  return covered_share(turns_at_centre(wave, p) - 0.25, length(wave.turns_per_pixel), stripe_width);
}

vec3 with_pattern(vec3 surface, SurfacePoint p) {
  FragmentWave wave = wave_at(p);
  if (wave.direction == vec3(0.0)) return surface;
  return mix(surface, stripe_color, stripe_coverage(wave, p));
}
