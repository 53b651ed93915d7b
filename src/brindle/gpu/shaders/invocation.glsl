// The invocation's number in a dispatch that fills the first dimension, then the second.

layout(local_size_x = 64) in;

uint group() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

uint invocation() { return group() * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }
