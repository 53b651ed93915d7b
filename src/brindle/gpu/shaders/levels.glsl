// The levels of a hierarchy, all in common buffers (twins: phases/sliced_graph.h,
// phases/hierarchy.h). Slots, columns and entries are numbered through all levels, finest first.
//
// No shader declares more than eight storage blocks, as many as every device has.

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
  uint color_begin;   // one word a colour and one more: its first slice in a list of three words each
  uint color_count;
  uint sweeps;
  float over_relaxation;  // of all sweeps but the last
  uint gauge_entry_count, source_count;  // for measurements alone
  uint filling_0, filling_1, filling_2;
};

layout(std140, binding = 0) uniform Levels {
  Level levels[32];
  uint level_count;
  uint node_at;       // word of `topology`: one a slot of the finest level, kNone for filling
  uint scratch_size;  // entries of the finest level
};

layout(std430, binding = 0) readonly buffer Topology { uint topology[]; };
