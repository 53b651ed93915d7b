// Gauges and coarse sums (twins: gauge_members, gauge_slices, sum_slices of
// phases/sliced_kernels_portable.cpp and their reflecting parts in phases/hierarchy.cpp).

// Gauges of all members of an aggregate, each from its couplings to earlier ones.
void renew_gauges(Level level, uint aggregate) {
  const uint begin = topology[level.member_begin + aggregate];
  const uint end = topology[level.member_begin + aggregate + 1u];
  // Two words per member: its slot, and the start of its list of entries and neighbours. The
  // reference keeps gauge 1.
  for (uint member = begin + 2u; member < end; member += 2u) {
    const uint slot = topology[member];
    const bool reflects = rows[slot].reflects != 0u;
    vec2 plain = vec2(0), conjugated = vec2(0);
    for (uint e = topology[member + 1u]; e < topology[member + 3u]; e += 2u) {
      const uint entry = topology[e];
      const uvec2 bits = gauge[topology[e + 1u]];
      const vec2 from = uintBitsToFloat(bits);
      const vec2 a = times(direct[entry], from);
      const vec2 b = reflects ? times(reflecting[entry], conjugate(from)) : vec2(0);
      plain += conjugate_bit(bits) ? b : a;
      conjugated += conjugate_bit(bits) ? a : b;
    }
    const bool takes_conjugate = dot(conjugated, conjugated) > dot(plain, plain);
    const vec2 sum = takes_conjugate ? conjugated : plain;
    gauge[slot] =
        with_conjugate_bit(has_direction(sum) ? normalized(sum) : vec2(1, 0), takes_conjugate);
  }
}

// Eight invocations share a row; each takes every eighth entry.
const uint kParts = 8u;

struct RowPart {
  uint slot;
  uint part;
};

// The work of the n-th invocation: adjacent ones have adjacent slots.
RowPart row_part(uint n) {
  return RowPart(n / (kLanes * kParts) * kLanes + n % kLanes, n / kLanes % kParts);
}

// Gauges the couplings of one row into scratch: direct ones and, in reflecting rows, reflecting
// ones `scratch_size` later. The conjugate bit marks contributions to B of the coarser level, the
// lowest bit of the imaginary part a second contribution.
void gauge_row(Level level, RowPart here) {
  const uint i = level.first_slot + here.slot;
  const bool reflects = rows[i].reflects != 0u;
  const uvec2 bits_i = gauge[i];
  const vec2 g_i = conjugate(uintBitsToFloat(bits_i));
  const bool conjugated = conjugate_bit(bits_i);
  const uint end = end_entry(level, here.slot);
  uint entry = first_entry(level, here.slot) + here.part * kLanes;
  for (; entry < end; entry += kParts * kLanes) {
    const uvec2 bits_j = gauge[neighbor[entry]];
    const vec2 g_j = uintBitsToFloat(bits_j);
    const bool differ = conjugated != conjugate_bit(bits_j);
    const uint place = entry - level.first_column * kLanes;
    vec2 c = times(g_i, times(direct[entry], g_j));
    uvec2 result = with_conjugate_bit(conjugated ? conjugate(c) : c, differ);
    result.y = (result.y & ~1u) | uint(reflects);
    gauged[place] = result;
    if (!reflects) continue;
    c = times(times(g_i, reflecting[entry]), conjugate(g_j));
    gauged[scratch_size + place] = with_conjugate_bit(conjugated ? conjugate(c) : c, !differ);
  }
}

// A coarse row reflects if one of its entries does (`sum_row`).
void begin_row(Level coarse, uint aggregate) { rows[coarse.first_slot + aggregate].reflects = 0u; }

// A and B of a coarse entry: sums over the fine entries of its rounds.
struct EntrySum {
  vec2 a, b;
};

void add(uvec2 bits, inout EntrySum sum) {
  if (conjugate_bit(bits)) {
    sum.b += uintBitsToFloat(bits);
  } else {
    sum.a += uintBitsToFloat(bits);
  }
}

EntrySum entry_sum(uint begin, uint end, uint lane) {
  EntrySum sum = EntrySum(vec2(0), vec2(0));
  bool has_second = false;
  for (uint round = begin; round < end; round += kLanes) {
    const uint entry = topology[round + lane];
    if (entry == kNone) continue;
    const uvec2 bits = gauged[entry];
    add(bits, sum);
    has_second = has_second || (bits.y & 1u) != 0u;
  }
  if (!has_second) return sum;
  for (uint round = begin; round < end; round += kLanes) {
    const uint entry = topology[round + lane];
    if (entry != kNone && (gauged[entry].y & 1u) != 0u) add(gauged[scratch_size + entry], sum);
  }
  return sum;
}

vec2 anchor_sum(Level level, uint aggregate) {
  vec2 sum = vec2(0);
  const uint end = topology[level.member_begin + aggregate + 1u];
  for (uint member = topology[level.member_begin + aggregate]; member < end; member += 2u) {
    const uvec2 bits = gauge[topology[member]];
    const vec2 t = times(conjugate(uintBitsToFloat(bits)), rows[topology[member]].anchor);
    sum += conjugate_bit(bits) ? conjugate(t) : t;
  }
  return sum;
}

// One row of the coarser level.
void sum_row(Level fine, Level coarse, RowPart here) {
  const uint i = coarse.first_slot + here.slot, end = end_entry(coarse, here.slot);
  if (here.part == 0u) rows[i].anchor = anchor_sum(fine, here.slot);
  uint entry = first_entry(coarse, here.slot) + here.part * kLanes;
  for (; entry < end; entry += kParts * kLanes) {
    const uint rounds = fine.source_begin + entry / kLanes - coarse.first_column;
    const EntrySum sum = entry_sum(topology[rounds], topology[rounds + 1u], here.slot % kLanes);
    direct[entry] = sum.a;
    reflecting[entry] = sum.b;
    if (sum.b != vec2(0)) rows[i].reflects = 1u;
  }
}
