// Gauges of all slots, and the gauged couplings of a level.

#ifndef BETWEEN_INVOCATIONS
#define BETWEEN_INVOCATIONS restrict
#endif

layout(std430, binding = 5) BETWEEN_INVOCATIONS buffer Gauges { uvec2 gauge[]; };
layout(std430, binding = 7) BETWEEN_INVOCATIONS buffer Scratch { uvec2 gauged[]; };

// Prolongation: the phase of a slot with the aggregate's phase `coarse_z` (twin: prolong_slices of
// phases/sliced_kernels_portable.cpp).
vec2 prolonged_phase(Level level, uint slot, vec2 coarse_z) {
  const uvec2 bits = gauge[level.first_slot + slot];
  return times(uintBitsToFloat(bits), conjugate_bit(bits) ? conjugate(coarse_z) : coarse_z);
}
