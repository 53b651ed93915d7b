// Strokes of up to two patterns over each other.

uniform bool discarded;  // nothing of the surface is seen between strokes

// Of a discarded surface only strokes are seen; which ones, their shares tell.
bool pattern_at(inout vec3 surface, SurfacePoint p, float tone) {
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
