// The work of a dispatch: a level, or the slots of one of its colours.

layout(location = 0) uniform uint level_number;
layout(location = 1) uniform uint slices;      // list of the colour's slices
layout(location = 2) uniform uint work_count;  // their number of slots
