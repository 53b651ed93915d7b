// Ends the converged relaxation (twin: relax of phases/relaxation.cpp) by setting the group counts
// of all remaining dispatches to zero, so that the processor need not wait for the energy.

layout(std430, binding = 0) buffer Relaxation {
  uint iterations;
  uint converged;
  float weight;
  float energies[];  // before the first iteration and after each
};
layout(std430, binding = 1) writeonly buffer Commands { uint commands[]; };

layout(location = 0) uniform uint part_count;
layout(location = 1) uniform uint command_count;
layout(location = 2) uniform float epsilon;

void main() {
  if (converged != 0u) return;
  vec4 sum = vec4(0);
  for (uint p = gl_LocalInvocationID.x; p < part_count; p += gl_WorkGroupSize.x) sum += parts[p];
  sum = group_sum(sum);
  if (gl_LocalInvocationID.x != 0u) return;
  const float before = energies[iterations];
  const float drop = sum.x / weight;
  iterations += 1u;
  energies[iterations] = before - drop;
  if (drop > 0.0 && drop / before >= epsilon) return;
  converged = 1u;
  for (uint c = 0u; c < command_count; ++c) commands[3u * c] = 0u;
}
