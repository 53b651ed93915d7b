// Sums over the groups of a dispatch, one part per group.

layout(std430, binding = 7) buffer Parts { vec4 parts[]; };

// The sum of a vec4 over the group, in a fixed order; valid in the first invocation.
shared vec4 group_parts[gl_WorkGroupSize.x];

vec4 group_sum(vec4 part) {
  const uint here = gl_LocalInvocationID.x;
  group_parts[here] = part;
  for (uint half_size = gl_WorkGroupSize.x / 2u; half_size > 0u; half_size /= 2u) {
    memoryBarrierShared();
    barrier();
    if (here < half_size) group_parts[here] += group_parts[here + half_size];
  }
  return group_parts[here];
}
