// Before the buffers of shaders whose invocations read couplings and gauges that others of them
// wrote.
#define BETWEEN_INVOCATIONS coherent restrict
