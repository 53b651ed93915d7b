// One more than the number of the triangle that is seen, counted through all surfaces. What lies behind
// a triangle that is not seen here is seen instead.

uniform int first_triangle;  // of those drawn at once
uniform int first_number;    // of the surface

layout(location = 0) out uint visible;

void main() {
  uint number = uint(first_triangle + gl_PrimitiveID);
  if (!is_seen(number)) discard;
  visible = uint(first_number) + number + 1u;
}
