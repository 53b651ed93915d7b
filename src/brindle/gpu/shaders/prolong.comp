void main() {
  const uint slot = invocation();
  if (slot < levels[level_number].slot_count) prolong_slot(levels[level_number], slot);
}
