// Prolongation (twin: prolong_slices of phases/sliced_kernels_portable.cpp).

void prolong_slot(Level level, uint slot) {
  const vec2 coarse_z = z[topology[level.coarse_slots + slot]];
  const uvec2 bits = gauge[level.first_slot + slot];
  set_phase(level, slot, times(uintBitsToFloat(bits),
                               conjugate_bit(bits) ? conjugate(coarse_z) : coarse_z));
}
