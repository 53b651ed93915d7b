// First file of shaders with a single group.

layout(local_size_x = 1024) in;

// A barrier that makes writes to `coherent` buffers and `shared` visible to the whole group.
void await_group() {
  groupMemoryBarrier();
  barrier();
}
