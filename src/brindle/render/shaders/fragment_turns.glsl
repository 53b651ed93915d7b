// Phi / 2 pi at the pixel's centre, where neighbours that share the pixel agree.
float turns_at_centre(FragmentWave wave, SurfacePoint p) {
  return atan(wave.z.y, wave.z.x) / kTurn + dot(wave.turns_per_pixel, p.way_to_centre);
}
