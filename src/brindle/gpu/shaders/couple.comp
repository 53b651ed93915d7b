// Couplings and anchors of the finest level (twins: couple_slices of
// phases/sliced_kernels_portable.cpp, set_anchors of pipeline/stripe_animator.cpp).

layout(std430, binding = 5) readonly buffer Waves { Wave waves[]; };
layout(std430, binding = 6) readonly buffer LastPhases { vec2 last_z[]; };

layout(location = 0) uniform float lambda;

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
    if (i != j) {
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
