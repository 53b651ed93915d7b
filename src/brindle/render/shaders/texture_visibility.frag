// As styled_visibility.frag, but only where tiles are opaque: what lies behind is seen beside them.
// Each pass draws one region.

uniform int first_triangle;
uniform int first_number;

layout(location = 0) out uint visible;

void main() {
  uint number = uint(first_triangle + gl_PrimitiveID);
  vec4 tile;
  if (!tile_at(surface_point(surface_triangle(number), gl_FragCoord.xy, gl_FragCoord.xy), tile) ||
      tile.a <= 0.5) {
    discard;
  }
  visible = uint(first_number) + number + 1u;
}
