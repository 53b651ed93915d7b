// Couplings and anchors of the finest level (twins: couple_slices of
// phases/sliced_kernels_portable.cpp, set_anchors of pipeline/stripe_animator.cpp).

layout(std430, binding = 5) readonly buffer Waves { Wave waves[]; };
layout(std430, binding = 6) readonly buffer LastPhases { vec2 last_z[]; };

// Unit normals by node, for links across creases.
layout(std430, binding = 7) readonly buffer Normals { float normals[]; };

layout(location = 0) uniform float lambda;
layout(location = 2) uniform bool linked;

const float kTwoPi = 6.28318530717958648;

// exp(2 pi i turns).
vec2 unit(float turns) {
  const float radians = kTwoPi * (turns - roundEven(turns));
  return vec2(cos(radians), sin(radians));
}

// Sets B of an entry in the row that starts at `first`, in ascending order. Few rows reflect, and
// only those are written; `reflects` tells whether this row does so far.
void set_reflecting(uint first, uint entry, vec2 b, inout bool reflects) {
  if (!reflects && b != vec2(0)) {
    reflects = true;
    for (uint before = first; before < entry; before += kLanes) reflecting[before] = vec2(0);
  }
  if (reflects) reflecting[entry] = b;
}

vec3 normal_at(uint slot) {
  const uint node = topology[node_at + slot];
  return vec3(normals[3u * node], normals[3u * node + 1u], normals[3u * node + 2u]);
}

// For two waves at one position (twin: coupling_across of waves/crease_links.h).
float coupling_across(uint j, uint i) {
  const float kFolded = 1e-3, kWeight = 0.01;
  const vec3 n_j = normal_at(j), n_i = normal_at(i), d_j = waves[j].direction, d_i = waves[i].direction;
  const float unfolded = 1.0 + dot(n_i, n_j);
  if (unfolded < kFolded) return 0.0;
  return kWeight * (dot(d_i, d_j) - dot(d_j, n_i) * dot(d_i, n_j) / unfolded);
}

void main() {
  const uint i = invocation();
  const Level level = levels[0];
  if (i >= level.slot_count) return;
  const uint first = first_entry(level, i), end = end_entry(level, i);
  const Wave wave = waves[i];
  float degree = 0.0;
  bool reflects = false;
  for (uint entry = first; entry < end; entry += kLanes) {
    const uint j = neighbor[entry];
    vec2 a = vec2(0), b = vec2(0);
    if (linked && i != j && wave.position == waves[j].position) {
      const float coupling = coupling_across(j, i);
      degree += abs(coupling);
      if (coupling < 0.0) {
        b = vec2(coupling, 0);
      } else {
        a = vec2(coupling, 0);
      }
    } else if (i != j) {
      const EdgeShift shift = edge_shift(waves[j], wave);
      const float weight = abs(shift.cosine);
      degree += weight;
      if (shift.reflecting) {
        b = -weight * unit(-shift.turns);
      } else {
        a = weight * unit(shift.turns);
      }
    }
    direct[entry] = a;
    set_reflecting(first, entry, b, reflects);
  }
  // Not 0 * last_z: the last phase may be undefined.
  const vec2 anchor = lambda > 0.0 ? lambda * degree * last_z[i] : vec2(0);
  rows[i] = Row(anchor, degree, uint(reflects));
}
