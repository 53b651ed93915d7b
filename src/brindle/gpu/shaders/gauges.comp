void main() {
  const uint aggregate = invocation();
  if (aggregate < levels[level_number + 1u].slot_count) {
    renew_gauges(levels[level_number], aggregate);
  }
}
