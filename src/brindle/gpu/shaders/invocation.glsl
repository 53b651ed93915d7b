// Number of an invocation of a dispatch that is as wide as one dimension allows, and then deeper.

layout(local_size_x = 64) in;

uint group() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

uint invocation() { return group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }
