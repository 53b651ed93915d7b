// Eq. 10 and 11 for the nodes of one colour (twin: relax_slices of
// phases/sliced_kernels_portable.cpp). The decrease of the energy is added to the parts.

layout(std430, binding = 5) buffer Momenta { vec2 momentum[]; };

layout(location = 3) uniform float strength;  // s_m
layout(location = 4) uniform uint first_part;

float relax_row(RowWork work) {
  const uint slot = work.slot;
  const vec2 t = target(levels[0], work);
  if (!has_direction(t)) return 0.0;
  const vec2 before = z[slot];
  const vec2 pulled = t + momentum[slot];
  const vec2 after = has_direction(pulled) ? normalized(pulled) : before;
  z[slot] = after;
  momentum[slot] = strength * (t - before);
  return dot(after - before, t);
}

void main() {
  const uint n = invocation();
  const float drop = n < work_count ? relax_row(row_of_work(slices, n)) : 0.0;
  const vec4 sum = group_sum(vec4(drop, 0, 0, 0));
  if (gl_LocalInvocationID.x == 0u) parts[first_part + group()] = sum;
}
