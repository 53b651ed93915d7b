// One more than the number of the triangle that is seen.

uniform int first_triangle;  // of those drawn at once

layout(location = 0) out uint visible;

void main() { visible = uint(first_triangle + gl_PrimitiveID) + 1u; }
