// The triangles at the middle of each pixel, in a list.

// How many words are in use; of each pixel where its list begins (0: it is empty); then, for each
// triangle in a list, where the next one is (0: it is the last), its number and its depth.
layout(std430, binding = 4) buffer ListedTriangles { uint listed[]; };

uniform int pixels_in_row;

uint begin_of_list() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  return 1u + uint(pixel.y * pixels_in_row + pixel.x);
}
