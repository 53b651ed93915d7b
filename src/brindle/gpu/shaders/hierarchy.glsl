// All levels of a hierarchy in common buffers (twins: phases/sliced_graph.h, phases/hierarchy.h).
// Slots, columns and entries are numbered through all levels, finest first.

#ifndef BETWEEN_INVOCATIONS
#define BETWEEN_INVOCATIONS
#endif

const uint kLanes = 16u;
const uint kNone = 0xffffffffu;

// Where a level's parts begin: in slots and columns, or in words of `topology`.
struct Level {
  uint first_slot;
  uint slot_count;
  uint first_column;
  uint columns;       // one word a slice and one more: its first column
  uint coarse_slots;  // one word a slot: the slot of its aggregate
  uint member_begin;  // one word a slot of the coarser level and one more: its first member
  uint source_begin;  // one word a column of the coarser level and one more: its first round
  uint color_begin;   // one word a colour and one more: its first slice in a list
  uint color_count;
  uint sweeps;
  uint gauge_entry_count, source_count;  // for measurements alone
};

layout(std140, binding = 0) uniform Levels {
  Level levels[32];
  uint level_count;
  uint node_at;       // word of `topology`: one a slot of the finest level, kNone for filling
  uint scratch_size;  // entries of the finest level
};

// A node of a level: the words that all threads of its row need at once.
struct Row {
  vec2 anchor;    // T_i
  float degree;   // sum of weights, finest level
  uint reflects;  // whether `reflecting` holds this row
};

layout(std430, binding = 0) readonly buffer Topology { uint topology[]; };
layout(std430, binding = 1) readonly buffer Neighbors { uint neighbor[]; };
layout(std430, binding = 2) BETWEEN_INVOCATIONS buffer Direct { vec2 direct[]; };
layout(std430, binding = 3) BETWEEN_INVOCATIONS buffer Reflecting { vec2 reflecting[]; };
layout(std430, binding = 4) BETWEEN_INVOCATIONS buffer Rows { Row rows[]; };
layout(std430, binding = 5) BETWEEN_INVOCATIONS buffer Gauges { uvec2 gauge[]; };
layout(std430, binding = 6) BETWEEN_INVOCATIONS buffer Phases { vec2 z[]; };
layout(std430, binding = 7) BETWEEN_INVOCATIONS buffer Scratch { uvec2 gauged[]; };

uint first_entry(Level level, uint slot) {
  return topology[level.columns + slot / kLanes] * kLanes + slot % kLanes;
}

uint end_entry(Level level, uint slot) {
  return topology[level.columns + slot / kLanes + 1u] * kLanes;
}

// Sets B of an entry of the row that begins at `first`; rows are filled in ascending order. Few
// rows reflect: only those are written. `reflects` tells whether this one does so far.
void set_reflecting(uint first, uint entry, vec2 b, inout bool reflects) {
  if (!reflects && b != vec2(0)) {
    reflects = true;
    for (uint before = first; before < entry; before += kLanes) reflecting[before] = vec2(0);
  }
  if (reflects) reflecting[entry] = b;
}
