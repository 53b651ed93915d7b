// The levels of a hierarchy in common buffers (twins: phases/sliced_graph.h, phases/hierarchy.h).
// Slots, columns and entries are numbered through all levels, finest first.
//
// No shader declares more than eight storage blocks, the number that every device supports.

const uint kLanes = 16u;
const uint kNone = 0xffffffffu;

// Starts of a level's parts: slots and columns, or words of `topology`.
struct Level {
  uint first_slot;
  uint slot_count;
  uint first_column;
  uint columns;       // a word per slice and one more: its first column
  uint coarse_slots;  // a word per slot: the slot of its aggregate
  uint member_begin;  // a word per slot of the coarser level and one more: its first member
  uint source_begin;  // a word per column of the coarser level and one more: its first round
  uint color_begin;   // a word per colour and one more: its first slice in a list of three words each
  uint color_count;
  uint sweeps;
  float over_relaxation;  // of all sweeps except the last
  uint filling;
};

layout(std140, binding = 0) uniform Levels {
  Level levels[32];
  uint level_count;
  uint node_at;       // word of `topology`: one per slot of the finest level, kNone for padding
  uint scratch_size;  // entries of the finest level
};

layout(std430, binding = 0) readonly buffer Topology { uint topology[]; };
