// One more than the number of the visible triangle among all surfaces. Where a triangle is
// discarded, those behind it become visible.

uniform int first_triangle;  // of the triangles in this draw call
uniform int first_number;    // of the surface

layout(location = 0) out uint visible;

void main() {
  uint number = uint(first_triangle + gl_PrimitiveID);
  if (!is_seen(number)) discard;
  visible = uint(first_number) + number + 1u;
}
