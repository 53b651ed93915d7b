// Targets and sweeps (twins: targets, sweep_slices of phases/sliced_kernels_portable.cpp).

// The work of an invocation: a slot and its entries.
struct RowWork {
  uint slot;
  uint first;
  uint end;
};

RowWork row_work(Level level, uint slot) {
  return RowWork(slot, first_entry(level, slot), end_entry(level, slot));
}

// For the n-th invocation of a colour; `slices` is the colour's list, three words per slice.
RowWork row_of_work(uint slices, uint n) {
  const uint at = slices + 3u * (n / kLanes), lane = n % kLanes;
  return RowWork(topology[at] * kLanes + lane, topology[at + 1u] * kLanes + lane,
                 topology[at + 2u] * kLanes);
}

// The sums of Eq. 8 for one row, without its anchor. Four entries at a time, to overlap their
// memory latencies.
vec2 pull(Level level, RowWork work, bool reflects) {
  vec2 t = vec2(0);
  for (uint e0 = work.first; e0 < work.end; e0 += 4u * kLanes) {
    const bool is_1 = e0 + kLanes < work.end, is_2 = e0 + 2u * kLanes < work.end,
               is_3 = e0 + 3u * kLanes < work.end;
    const uint e1 = is_1 ? e0 + kLanes : e0, e2 = is_2 ? e0 + 2u * kLanes : e0,
               e3 = is_3 ? e0 + 3u * kLanes : e0;
    const vec2 z0 = phase_at(level, neighbor[e0]), z1 = phase_at(level, neighbor[e1]),
               z2 = phase_at(level, neighbor[e2]), z3 = phase_at(level, neighbor[e3]);
    const vec2 a0 = direct[e0], a1 = direct[e1], a2 = direct[e2], a3 = direct[e3];
    t += times(a0, z0);
    t += is_1 ? times(a1, z1) : vec2(0);
    t += is_2 ? times(a2, z2) : vec2(0);
    t += is_3 ? times(a3, z3) : vec2(0);
    if (!reflects) continue;
    const vec2 b0 = reflecting[e0], b1 = reflecting[e1], b2 = reflecting[e2], b3 = reflecting[e3];
    t += times(b0, conjugate(z0));
    t += is_1 ? times(b1, conjugate(z1)) : vec2(0);
    t += is_2 ? times(b2, conjugate(z2)) : vec2(0);
    t += is_3 ? times(b3, conjugate(z3)) : vec2(0);
  }
  return t;
}

// t_i of Eq. 8.
vec2 target(Level level, RowWork work) {
  const Row row = rows[level.first_slot + work.slot];
  return row.anchor + pull(level, work, row.reflects != 0u);
}

void sweep_row(Level level, RowWork work, float over_relaxation) {
  const vec2 t = target(level, work);
  if (!has_direction(t)) return;
  vec2 after = normalized(t);
  if (over_relaxation != 1.0) {
    const vec2 before = phase_at(level, level.first_slot + work.slot);
    after = normalized(before + over_relaxation * (after - before));
  }
  set_phase(level, work.slot, after);
}
