void main() {
  const uint slot = invocation();
  if (slot < levels[level_number].slot_count) gauge_row(levels[level_number], slot);
}
