// As styled_visibility.frag, but only where strokes are: what lies behind is seen between them.

uniform int first_triangle;
uniform int first_number;

layout(location = 0) out uint visible;

bool covered(SurfacePoint p, float tone) {
  for (int layer = 0; layer < kStrokeLayers; ++layer) {
    if (is_plain(p, layer) || strokes_at(p, layer, tone).share > 0.5) return true;
  }
  return false;
}

void main() {
  uint number = uint(first_triangle + gl_PrimitiveID);
  SurfacePoint p = surface_point(surface_triangle(number), gl_FragCoord.xy, gl_FragCoord.xy);
  if (!covered(p, tone_at(p))) discard;
  visible = uint(first_number) + number + 1u;
}
