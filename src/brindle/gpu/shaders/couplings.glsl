// Couplings, anchors and neighbours of all rows.

#ifndef BETWEEN_INVOCATIONS
#define BETWEEN_INVOCATIONS restrict
#endif

// A node of a level: words that all threads of its row need.
struct Row {
  vec2 anchor;    // T_i
  float degree;   // sum of weights, finest level
  uint reflects;  // whether `reflecting` has this row
};

layout(std430, binding = 1) readonly buffer Neighbors { uint neighbor[]; };
layout(std430, binding = 2) BETWEEN_INVOCATIONS buffer Direct { vec2 direct[]; };          // A
layout(std430, binding = 3) BETWEEN_INVOCATIONS buffer Reflecting { vec2 reflecting[]; };  // B
layout(std430, binding = 4) BETWEEN_INVOCATIONS buffer Rows { Row rows[]; };

uint first_entry(Level level, uint slot) {
  return topology[level.columns + slot / kLanes] * kLanes + slot % kLanes;
}

uint end_entry(Level level, uint slot) {
  return topology[level.columns + slot / kLanes + 1u] * kLanes;
}
