// One more than the number of the triangle that is seen, counted through all surfaces.

uniform int first_triangle;  // of those drawn at once
uniform int first_number;    // of the surface

layout(location = 0) out uint visible;

void main() { visible = uint(first_number + first_triangle + gl_PrimitiveID) + 1u; }
