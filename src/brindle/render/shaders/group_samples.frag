// Groups the samples of a pixel that show one surface, to shade them once. Depths of one surface
// continue from one sample to the next, from either side.

uniform mat4 clip_from_view;
uniform vec4 tile;                // as in visible_triangles.vert
uniform vec2 target_size;         // in pixels
uniform bool distinct_triangles;  // whether even adjacent triangles may look different
uniform int first_number;         // of the surface's triangles: others are invisible
uniform int triangle_count;

layout(location = 0) out uint groups;  // 2 bits per sample, in the order of textureGather

// A continuing surface deviates from a straight line by at most this share of a pixel's side at its
// distance; more is visible as a crease.
const float kBend = 0.1;

// Four pairs of adjacent samples, above, below, left and right, with those before and after.
vec4 bends(vec4 before, vec4 a, vec4 b, vec4 after) {
  return min(abs(b - 2.0 * a + before), abs(a - 2.0 * b + after));
}

// Whether the pairs above, below, left and right show one surface.
bvec4 joined_pairs(uvec4 triangles) {
  vec4 ll = depths_around(vec2(-1.0, -1.0));
  vec4 lr = depths_around(vec2(1.0, -1.0));
  vec4 ur = depths_around(vec2(1.0, 1.0));
  vec4 ul = depths_around(vec2(-1.0, 1.0));
  vec4 depths = vec4(ul.z, ur.w, lr.x, ll.y);
  vec4 a = depths.xwwz;
  vec4 bend = bends(vec4(ul.w, ll.x, ll.z, lr.w), a, depths.yzxy, vec4(ur.z, lr.y, ul.y, ur.x));
  // Relative to a pixel's side at that distance, which is constant in parallel projection.
  float perspective = 1.0 - clip_from_view[3][3];
  vec4 unit = abs(perspective * (2.0 * a - 1.0) + clip_from_view[2][2]) /
      (clip_from_view[1][1] * tile.y * target_size.y);
  return lessThan(bend, distinct_triangles ? vec4(-1.0) : kBend * unit);
}

void main() {
  uvec4 triangles = triangles_here();
  uvec4 numbers = triangles - 1u - uint(first_number);
  triangles *= uvec4(lessThan(numbers, uvec4(triangle_count)));
  bvec4 seen = notEqual(triangles, uvec4(0u));
  bvec4 joined = joined_pairs(triangles);
  bool above = triangles.x == triangles.y || (joined.x && seen.x && seen.y);
  bool below = triangles.w == triangles.z || (joined.y && seen.w && seen.z);
  bool left = triangles.w == triangles.x || (joined.z && seen.w && seen.x);
  bool right = triangles.z == triangles.y || (joined.w && seen.z && seen.y);

  // A group has the number of its first sample.
  uint y = above ? 0u : 1u;
  uint w = left ? 0u : triangles.w == triangles.y ? y : 3u;
  uint z = right ? y : below ? w : triangles.z == triangles.x ? 0u : 2u;
  if (right && below) z = y = w = min(y, w);

  // Renumbers groups without gaps; `first` marks the first sample of each.
  uvec4 first = uvec4(seen.x, seen.y && y == 1u, seen.z && z == 2u, seen.w && w == 3u);
  uvec4 number = uvec4(0u, first.x, first.x + first.y, first.x + first.y + first.z);
  uint count = number.w + first.w;
  groups = number.x | number[y] << 2 | number[z] << 4 | number[w] << 6;
  gl_FragDepth = 1.0 - 0.125 * float(count);
}
