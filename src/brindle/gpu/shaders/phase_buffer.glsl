// Phases of all slots, and one more for slots without an aggregate.

layout(std430, binding = 6) restrict buffer Phases { vec2 z[]; };
