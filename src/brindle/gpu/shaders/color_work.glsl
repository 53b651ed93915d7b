// Which colour of a level a dispatch works on: its list of slices, and how many slots they are.
layout(location = 1) uniform uint slices;
layout(location = 2) uniform uint work_count;
