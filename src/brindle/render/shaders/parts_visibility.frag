// As styled_visibility.frag, but only where something of the triangle is seen: what lies behind is
// seen elsewhere.

uniform int first_triangle;
uniform int first_number;

layout(location = 0) out uint visible;

void main() {
  uint number = uint(first_triangle + gl_PrimitiveID);
  if (!is_seen(number)) discard;
  visible = uint(first_number) + number + 1u;
}
