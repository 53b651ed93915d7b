// Waves into the order of slots (twin: load_waves of phases/sliced_waves.cpp).

layout(std430, binding = 1) readonly buffer Positions { float positions[]; };
layout(std430, binding = 2) readonly buffer Directions { float directions[]; };
layout(std430, binding = 3) readonly buffer Frequencies { float frequencies[]; };
layout(std430, binding = 4) buffer Waves { Wave waves[]; };
layout(std430, binding = 5) buffer LastPhases { vec2 last_z[]; };

layout(location = 0) uniform bool has_last;

void main() {
  const uint slot = invocation();
  if (slot >= levels[0].slot_count) return;
  const uint node = topology[node_at + slot];
  if (node == kNone) return;
  const vec3 direction =
      vec3(directions[3u * node], directions[3u * node + 1u], directions[3u * node + 2u]);
  if (has_last && dot(waves[slot].direction, direction) < 0.0) {
    last_z[slot] = -conjugate(last_z[slot]);
  }
  waves[slot].position =
      vec3(positions[3u * node], positions[3u * node + 1u], positions[3u * node + 2u]);
  waves[slot].root_frequency = sqrt(frequencies[node]);
  waves[slot].direction = direction;
}
