// As visible_triangles.frag, for the triangles in the pixel's list: the nearest visible one; at
// equal depths, the first.

uniform int first_number;

layout(location = 0) out uint visible;

void main() {
  float nearest = 2.0;
  uint found = 0u;
  for (uint at = listed[begin_of_list()]; at != 0u; at = listed[at]) {
    uint number = listed[at + 1u];
    float depth = uintBitsToFloat(listed[at + 2u]);
    bool nearer = depth < nearest || (depth == nearest && number + 1u < found);
    if (nearer && is_seen(number)) {
      nearest = depth;
      found = number + 1u;
    }
  }
  if (found == 0u) discard;
  visible = uint(first_number) + found;
  gl_FragDepth = nearest;
}
