// First file of shaders that run in one group, whose invocations read from buffers what others of
// them wrote.

#define BETWEEN_INVOCATIONS coherent

layout(local_size_x = 1024) in;
