// Lists of the triangles at the middle of each pixel.

// The number of words in use; for each pixel, the position of its list (0: empty); for each
// triangle in a list, the position of the next (0: none), its number and its depth.
layout(std430, binding = 4) buffer ListedTriangles { uint listed[]; };

uniform int pixels_in_row;

uint begin_of_list() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  return 1u + uint(pixel.y * pixels_in_row + pixel.x);
}
