// Targets and sweeps (twins: targets, sweep_slices of phases/sliced_kernels_portable.cpp).

// The sums of Eq. 8 for one row, without its anchor.
vec2 pull(Level level, uint slot, bool reflects) {
  vec2 t = vec2(0);
  const uint first = first_entry(level, slot), end = end_entry(level, slot);
  for (uint entry = first; entry < end; entry += kLanes) {
    t += times(direct[entry], phase_at(level, neighbor[entry]));
  }
  if (!reflects) return t;
  for (uint entry = first; entry < end; entry += kLanes) {
    t += times(reflecting[entry], conjugate(phase_at(level, neighbor[entry])));
  }
  return t;
}

// t_i of Eq. 8.
vec2 target(Level level, uint slot) {
  const Row row = rows[level.first_slot + slot];
  return row.anchor + pull(level, slot, row.reflects != 0u);
}

void sweep_slot(Level level, uint slot, float over_relaxation) {
  const vec2 t = target(level, slot);
  if (!has_direction(t)) return;
  vec2 after = normalized(t);
  if (over_relaxation != 1.0) {
    const vec2 before = phase_at(level, level.first_slot + slot);
    after = normalized(before + over_relaxation * (after - before));
  }
  set_phase(level, slot, after);
}

// The slot that the n-th invocation of a colour works on; `slices` is the colour's list.
uint slot_of_work(uint slices, uint n) {
  return topology[slices + n / kLanes] * kLanes + n % kLanes;
}
