// The sum of all parts of a dispatch, in a fixed order.

layout(std430, binding = 0) writeonly buffer Results { vec4 results[]; };

layout(location = 0) uniform uint part_count;
layout(location = 1) uniform uint result_number;

void main() {
  vec4 sum = vec4(0);
  for (uint p = gl_LocalInvocationID.x; p < part_count; p += gl_WorkGroupSize.x) sum += parts[p];
  sum = group_sum(sum);
  if (gl_LocalInvocationID.x == 0u) results[result_number] = sum;
}
