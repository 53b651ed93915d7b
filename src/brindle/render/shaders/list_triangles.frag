// Adds a triangle to the lists of the pixels that it covers, while there is space.

uniform int first_triangle;  // of the triangles in this draw call

void main() {
  uint at = atomicAdd(listed[0], 3u);
  if (at + 3u > uint(listed.length())) return;
  listed[at + 1u] = uint(first_triangle + gl_PrimitiveID);
  listed[at + 2u] = floatBitsToUint(gl_FragCoord.z);
  listed[at] = atomicExchange(listed[begin_of_list()], at);
}
