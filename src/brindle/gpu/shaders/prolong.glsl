// Prolongation (twin: prolong_slices of phases/sliced_kernels_portable.cpp).

// The phase of a slot whose aggregate has the phase `coarse_z`.
vec2 prolonged_phase(Level level, uint slot, vec2 coarse_z) {
  const uvec2 bits = gauge[level.first_slot + slot];
  return times(uintBitsToFloat(bits), conjugate_bit(bits) ? conjugate(coarse_z) : coarse_z);
}
