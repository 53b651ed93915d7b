void main() {
  const uint n = invocation();
  if (n < levels[level_number + 1u].slot_count) begin_row(levels[level_number + 1u], n);
  const RowPart here = row_part(n);
  if (here.slot < levels[level_number].slot_count) gauge_row(levels[level_number], here);
}
