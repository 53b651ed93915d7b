// The descent from the coarsest to the first small level, in one group (twin: descend of
// phases/multilevel.cpp). The present level's phases are in `z_here`; only those of the first small
// level are written to the buffer.

layout(location = 0) uniform uint first_level;
layout(location = 1) uniform vec2 start;  // phase on the coarsest level

const uint kSlotsEach = kMostHere / gl_WorkGroupSize.x;  // slots of a level per invocation

uint slot_of(uint k) { return gl_LocalInvocationID.x + k * gl_WorkGroupSize.x; }

// The phase of a slot's aggregate, from `z_here` if there is one.
vec2 coarse_phase(Level coarse, uint slot_of_all) {
  const uint slot = slot_of_all - coarse.first_slot;
  return slot < coarse.slot_count ? z_here[slot] : z[slot_of_all];
}

void prolong_level(Level level, Level coarse) {
  vec2 prolonged[kSlotsEach];
  for (uint k = 0u; k < kSlotsEach; ++k) {
    if (slot_of(k) >= level.slot_count) break;
    const vec2 coarse_z = coarse_phase(coarse, topology[level.coarse_slots + slot_of(k)]);
    prolonged[k] = prolonged_phase(level, slot_of(k), coarse_z);
  }
  await_group();
  for (uint k = 0u; k < kSlotsEach; ++k) {
    if (slot_of(k) < level.slot_count) z_here[slot_of(k)] = prolonged[k];
  }
}

void sweep_color(Level level, uint color, float over_relaxation) {
  const uint begin = topology[level.color_begin + color];
  const uint count = (topology[level.color_begin + color + 1u] - begin) / 3u * kLanes;
  for (uint n = gl_LocalInvocationID.x; n < count; n += gl_WorkGroupSize.x) {
    sweep_row(level, row_of_work(begin, n), over_relaxation);
  }
}

void sweep_level(Level level) {
  for (uint sweep = 0u; sweep < level.sweeps; ++sweep) {
    const float over_relaxation = sweep + 1u < level.sweeps ? level.over_relaxation : 1.0;
    for (uint color = 0u; color < level.color_count; ++color) {
      sweep_color(level, color, over_relaxation);
      await_group();
    }
  }
}

void main() {
  for (uint k = 0u; k < kSlotsEach; ++k) z_here[slot_of(k)] = start;
  for (uint l = level_count; l > first_level; --l) {
    await_group();
    if (l < level_count) prolong_level(levels[l - 1u], levels[l]);
    await_group();
    sweep_level(levels[l - 1u]);
  }
  const Level level = levels[first_level];
  for (uint k = 0u; k < kSlotsEach; ++k) {
    if (slot_of(k) < level.slot_count) z[level.first_slot + slot_of(k)] = z_here[slot_of(k)];
  }
}
