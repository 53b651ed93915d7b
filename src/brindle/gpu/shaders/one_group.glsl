// First file of shaders that run in one group.

layout(local_size_x = 1024) in;

// Until everybody has come here: then all see what each wrote to `coherent` buffers and `shared`.
void await_group() {
  groupMemoryBarrier();
  barrier();
}
