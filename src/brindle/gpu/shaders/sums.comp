void main() {
  const RowPart here = row_part(invocation());
  if (here.slot < levels[level_number + 1u].slot_count) {
    sum_row(levels[level_number], levels[level_number + 1u], here);
  }
}
