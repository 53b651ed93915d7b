// The wave at a point of the surface.
FragmentWave wave_at(SurfacePoint p) {
  CornerWave corners[3];
  for (int m = 0; m < 3; ++m) {
    vec4 wave = wave_of_vertex(p.vertices[m]);
    corners[m] = CornerWave(position_of(p.vertices[m]), wave.xyz, wave.w, phase_of(p.vertices[m]));
  }
  return fragment_phase(corners, p.barycentric, p.barycentric_dx, p.barycentric_dy);
}
