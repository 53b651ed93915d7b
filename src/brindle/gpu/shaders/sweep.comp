layout(location = 3) uniform float over_relaxation;

void main() {
  const uint n = invocation();
  if (n < work_count) sweep_row(levels[level_number], row_of_work(slices, n), over_relaxation);
}
