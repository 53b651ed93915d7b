// Whether a triangle shows at this pixel's middle: only where strokes are.

bool is_seen(uint number) {
  SurfacePoint p = surface_point(surface_triangle(number), gl_FragCoord.xy, gl_FragCoord.xy);
  float tone = tone_at(p);
  for (int layer = 0; layer < kStrokeLayers; ++layer) {
    if (is_plain(p, layer) || strokes_at(p, layer, tone).share > 0.5) return true;
  }
  return false;
}
