// What every fragment of the surface knows.

flat in uint triangle;
in vec3 centre_barycentric;
centroid in vec3 barycentric;
centroid in vec3 clip_position;
centroid in vec3 view_position;
centroid in vec3 view_normal;

// Rounding may leave a weight a little below zero.
vec3 weights_here() {
  vec3 b = max(barycentric, vec3(0.0));
  return b / (b.x + b.y + b.z);
}

FragmentWave wave_here() {
  vec3 barycentric_dx = dFdx(centre_barycentric);
  vec3 barycentric_dy = dFdy(centre_barycentric);
  CornerWave corners[3];
  for (uint m = 0u; m < 3u; ++m) {
    uint vertex = vertex_of(triangle, m);
    vec4 wave = waves[vertex];
    corners[m] = CornerWave(position_of(vertex), wave.xyz, wave.w, phases[vertex]);
  }
  return fragment_phase(corners, weights_here(), barycentric_dx, barycentric_dy);
}
