// Measures phases: energy, weight, angle, count (twins: energy of waves/phase_graph.cpp, mean_step
// of pipeline/stripe_animator.cpp).

layout(std430, binding = 5) readonly buffer LastPhases { vec2 last_z[]; };

// With the sum of weights in `degree`, Eq. 4 is half the difference between the strongest possible
// pull on a node and the actual one along its phase.
vec4 measure_slot(uint slot) {
  const Row row = rows[slot];
  if (row.degree <= 0.0) return vec4(0);
  const vec2 t = pull(levels[0], row_work(levels[0], slot), row.reflects != 0u);
  const float energy = 0.5 * (row.degree - dot(z[slot], t));
  const vec2 turned = times(z[slot], conjugate(last_z[slot]));
  const float angle = turned == vec2(0) ? 0.0 : abs(atan(turned.y, turned.x));
  return vec4(energy, row.degree, angle, 1);
}

void main() {
  const uint slot = invocation();
  const vec4 sum = group_sum(slot < levels[0].slot_count ? measure_slot(slot) : vec4(0));
  if (gl_LocalInvocationID.x == 0u) parts[group()] = sum;
}
