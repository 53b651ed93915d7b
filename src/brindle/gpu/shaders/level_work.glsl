// Which level a dispatch works on.
layout(location = 0) uniform uint level_number;
