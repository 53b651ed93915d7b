void main() {
  const uint aggregate = invocation();
  if (aggregate < levels[level_number + 1u].slot_count) {
    sum_row(levels[level_number], levels[level_number + 1u], aggregate);
  }
}
