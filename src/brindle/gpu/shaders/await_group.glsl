// Until everybody has come here: then all see what each wrote to `coherent` buffers and `shared`.
void await_group() {
  groupMemoryBarrier();
  barrier();
}
