// First file of shaders that run in one group.

layout(local_size_x = 1024) in;
