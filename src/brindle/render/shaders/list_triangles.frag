// Puts a triangle into the lists of the pixels that it covers, as long as there is room.

uniform int first_triangle;  // of those drawn at once

void main() {
  uint at = atomicAdd(listed[0], 3u);
  if (at + 3u > uint(listed.length())) return;
  listed[at + 1u] = uint(first_triangle + gl_PrimitiveID);
  listed[at + 2u] = floatBitsToUint(gl_FragCoord.z);
  listed[at] = atomicExchange(listed[begin_of_list()], at);
}
