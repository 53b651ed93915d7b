// All small levels in one group: gauges and sums up to the coarsest, then the descent to the first
// small one (twins: renew of phases/hierarchy.cpp, descend of phases/multilevel.cpp).

layout(location = 0) uniform uint first_level;
layout(location = 1) uniform vec2 start;   // phase on the coarsest level
layout(location = 2) uniform bool renews;  // gauges, beside sums

void await_group() {
  memoryBarrierBuffer();
  memoryBarrierShared();
  barrier();
}

void renew_level(Level fine, Level coarse) {
  const uint step_size = gl_WorkGroupSize.x;
  if (renews) {
    for (uint a = gl_LocalInvocationID.x; a < coarse.slot_count; a += step_size) {
      renew_gauges(fine, a);
    }
    await_group();
  }
  for (uint slot = gl_LocalInvocationID.x; slot < fine.slot_count; slot += step_size) {
    gauge_row(fine, slot);
  }
  await_group();
  for (uint a = gl_LocalInvocationID.x; a < coarse.slot_count; a += step_size) {
    sum_row(fine, coarse, a);
  }
  await_group();
}

void descend_to(Level level, bool coarsest) {
  const uint step_size = gl_WorkGroupSize.x;
  for (uint slot = gl_LocalInvocationID.x; slot < level.slot_count; slot += step_size) {
    if (coarsest) {
      set_phase(level, slot, start);
    } else {
      prolong_slot(level, slot);
    }
  }
  await_group();
  for (uint sweep = 0u; sweep < level.sweeps; ++sweep) {
    const float over_relaxation = sweep + 1u < level.sweeps ? level.over_relaxation : 1.0;
    for (uint color = 0u; color < level.color_count; ++color) {
      const uint begin = topology[level.color_begin + color];
      const uint count = (topology[level.color_begin + color + 1u] - begin) * kLanes;
      for (uint n = gl_LocalInvocationID.x; n < count; n += step_size) {
        sweep_slot(level, slot_of_work(begin, n), over_relaxation);
      }
      memoryBarrierShared();
      barrier();
    }
  }
  for (uint slot = gl_LocalInvocationID.x; slot < level.slot_count; slot += step_size) {
    z[level.first_slot + slot] = z_here[slot];
  }
  await_group();
}

void main() {
  for (uint l = first_level; l + 1u < level_count; ++l) renew_level(levels[l], levels[l + 1u]);
  for (uint l = level_count; l > first_level; --l) descend_to(levels[l - 1u], l == level_count);
}
