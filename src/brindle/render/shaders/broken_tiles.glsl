// Which motifs of a texture's tiles are left out. Twin of is_broken in pattern/broken_tiles.cpp and
// motif_at of pattern/motif_centre.h.

layout(std430, binding = 3) readonly buffer BrokenTiles { uint broken_tiles[]; };

uniform bool has_broken_tiles;
uniform int tile_layout;
uniform bool splits_broken_tiles;

const int kSingle = 0;
const int kCourses = 2;

// Twice the U and twice the V of the motif's middle.
ivec2 motif_at(vec2 uv) {
  ivec2 cell = 2 * ivec2(floor(uv)) + 1;
  ivec2 corner = 2 * ivec2(floor(uv + 0.5));
  if (tile_layout == kCourses) {
    float to_course = uv.y - 0.5 * float(corner.y);
    return abs(to_course) < 0.25 ? ivec2(cell.x, corner.y) : ivec2(corner.x, cell.y);
  }
  if (tile_layout == kSingle) return cell;
  vec2 away = abs(uv - 0.5 * vec2(cell));
  return away.x + away.y < 0.5 ? cell : corner;
}

vec3 floats_at(uint first) {
  return uintBitsToFloat(
      uvec3(broken_tiles[first], broken_tiles[first + 1u], broken_tiles[first + 2u]));
}

bool is_listed(uint record, ivec2 middle) {
  uint count = broken_tiles[record + 6u];
  for (uint i = 0u; i < count; ++i) {
    uint at = record + 7u + 2u * i;
    if (ivec2(int(broken_tiles[at]), int(broken_tiles[at + 1u])) == middle) return true;
  }
  return false;
}

// Lifted like the corners of the triangle.
vec2 lifted(SurfacePoint p, uint record, vec2 uv) {
  vec2 led = vec2(dot(p.barycentric, floats_at(record)), dot(p.barycentric, floats_at(record + 3u)));
  return uv + floor(led - uv + 0.5);
}

// `uv` are texture coordinates without the shift of all tiles.
bool is_broken(SurfacePoint p, vec2 uv) {
  if (!has_broken_tiles) return false;
  uint record = broken_tiles[p.triangle];
  if (record < 2u) return record == 1u;
  return is_listed(record, motif_at(lifted(p, record, uv)));
}

// The share of a pixel outside the joint that splits a broken brick along its middle.
float beside_split(SurfacePoint p, Footprint f) {
  const float kJoint = 0.035;  // half of it
  float across = f.uv.x - 0.5 * float(motif_at(f.uv).x);
  float pixel = length(vec2(f.dx.x, f.dy.x));
  return clamp((abs(across) - kJoint) / max(pixel, 1e-6) + 0.5, 0.0, 1.0);
}
