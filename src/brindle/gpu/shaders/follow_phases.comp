// Starts the paper's iterations of the next frame from the last phases, or from the peak if unknown
// (twin: iterate of pipeline/frames/stripe_animator.cpp). Flips momenta with their directions
// (twin: load_waves of phases/sliced_waves.cpp).

layout(std430, binding = 1) readonly buffer Waves { Wave waves[]; };
layout(std430, binding = 2) readonly buffer LastWaves { Wave last_waves[]; };
layout(std430, binding = 3) readonly buffer TurnedPhases { vec2 turned_z[]; };
layout(std430, binding = 5) buffer Momenta { vec2 momentum[]; };

const vec2 kPeak = vec2(0, 1);

void main() {
  const uint slot = invocation();
  if (slot >= levels[0].slot_count) return;
  z[slot] = turned_z[slot] == vec2(0) ? kPeak : turned_z[slot];
  const bool turned = dot(last_waves[slot].direction, waves[slot].direction) < 0.0;
  if (turned) momentum[slot] = -conjugate(momentum[slot]);
}
