// Gauges and sums of all small levels up to the coarsest, in one group (twin: renew of
// phases/hierarchy.cpp).

layout(location = 0) uniform uint first_level;
layout(location = 1) uniform bool renews_gauges;  // in addition to sums

void renew_level(Level fine, Level coarse) {
  const uint begin = gl_LocalInvocationID.x, step_size = gl_WorkGroupSize.x;
  if (renews_gauges) {
    for (uint a = begin; a < coarse.slot_count; a += step_size) renew_gauges(fine, a);
    await_group();
  }
  for (uint a = begin; a < coarse.slot_count; a += step_size) begin_row(coarse, a);
  for (uint n = begin; n < fine.slot_count * kParts; n += step_size) gauge_row(fine, row_part(n));
  await_group();
  for (uint n = begin; n < coarse.slot_count * kParts; n += step_size) {
    sum_row(fine, coarse, row_part(n));
  }
  await_group();
}

void main() {
  for (uint l = first_level; l + 1u < level_count; ++l) renew_level(levels[l], levels[l + 1u]);
}
