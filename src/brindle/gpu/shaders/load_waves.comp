// Loads waves in slot order (twin: load_waves of phases/sliced_waves.cpp).

layout(std430, binding = 1) readonly buffer Positions { float positions[]; };
layout(std430, binding = 2) readonly buffer Directions { float directions[]; };
layout(std430, binding = 3) readonly buffer Frequencies { float frequencies[]; };
layout(std430, binding = 4) writeonly buffer Waves { Wave waves[]; };
layout(std430, binding = 5) readonly buffer LastWaves { Wave last_waves[]; };
layout(std430, binding = 6) readonly buffer LastPhases { vec2 last_z[]; };
layout(std430, binding = 7) writeonly buffer TurnedPhases { vec2 turned_z[]; };

// Last phases: none, those of `last_waves`, or those given by node for the loaded waves.
const int kByLastWaves = 1, kByNode = 2;
layout(location = 0) uniform int last;

void main() {
  const uint slot = invocation();
  if (slot >= levels[0].slot_count) return;
  const uint node = topology[node_at + slot];
  if (node == kNone) {
    waves[slot] = Wave(vec3(0), 0.0, vec3(0), 0.0);
    if (last == kByLastWaves) turned_z[slot] = last_z[slot];
    if (last == kByNode) turned_z[slot] = vec2(0);
    return;
  }
  const vec3 direction =
      vec3(directions[3u * node], directions[3u * node + 1u], directions[3u * node + 2u]);
  if (last == kByNode) turned_z[slot] = last_z[node];
  if (last == kByLastWaves) {
    const bool turned = dot(last_waves[slot].direction, direction) < 0.0;
    turned_z[slot] = turned ? -conjugate(last_z[slot]) : last_z[slot];
  }
  const vec3 position =
      vec3(positions[3u * node], positions[3u * node + 1u], positions[3u * node + 2u]);
  waves[slot] = Wave(position, sqrt(frequencies[node]), direction, 0.0);
}
