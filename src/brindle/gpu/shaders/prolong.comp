void main() {
  const uint slot = invocation();
  const Level level = levels[level_number];
  if (slot >= level.slot_count) return;
  const vec2 coarse_z = z[topology[level.coarse_slots + slot]];
  z[level.first_slot + slot] = prolonged_phase(level, slot, coarse_z);
}
