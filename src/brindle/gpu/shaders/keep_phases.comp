// Makes the present phases the gauges that a descent corrects (twin: correct of
// phases/multilevel.cpp).
void main() {
  const uint slot = invocation();
  const Level level = levels[level_number];
  if (slot >= level.slot_count) return;
  const uint i = level.first_slot + slot;
  gauge[i] =
      with_conjugate_bit(level_number == 0u ? z[i] : vec2(1, 0), conjugate_bit(gauge[i]));
}
