// Stripes on the surface.

uniform vec3 stripe_color;
uniform float stripe_width;  // share of the period

// The wave at a point of the surface.
FragmentWave wave_at(SurfacePoint p) {
  CornerWave corners[3];
  for (int m = 0; m < 3; ++m) {
    vec4 wave = wave_of_vertex(p.vertices[m]);
    corners[m] = CornerWave(position_of(p.vertices[m]), wave.xyz, wave.w, phase_of(p.vertices[m]));
  }
  return fragment_phase(corners, p.barycentric, p.barycentric_dx, p.barycentric_dy);
}

float stripe_coverage(FragmentWave wave, SurfacePoint p) {
  if (wave.z == vec2(0.0)) return stripe_width;
  return covered_share(turns_at_centre(wave, p) - 0.25, length(wave.turns_per_pixel), stripe_width);
}

vec3 with_pattern(vec3 surface, SurfacePoint p) {
  FragmentWave wave = wave_at(p);
  if (wave.direction == vec3(0.0)) return surface;
  return mix(surface, stripe_color, stripe_coverage(wave, p));
}
