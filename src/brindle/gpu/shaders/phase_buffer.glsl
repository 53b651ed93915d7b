// Phases of all slots, and one more for slots without an aggregate.

#ifndef BETWEEN_INVOCATIONS
#define BETWEEN_INVOCATIONS restrict
#endif

layout(std430, binding = 6) BETWEEN_INVOCATIONS buffer Phases { vec2 z[]; };
