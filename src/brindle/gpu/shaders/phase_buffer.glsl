// Phases of all slots, and one more for the missing aggregate.

layout(std430, binding = 6) restrict buffer Phases { vec2 z[]; };

#ifdef PHASES_IN_GROUP
// Phases of a level that one group works on, in shared memory.
const uint kMostHere = 4096u;
shared vec2 z_here[kMostHere];

vec2 phase_at(Level level, uint slot_of_all) { return z_here[slot_of_all - level.first_slot]; }

void set_phase(Level level, uint slot, vec2 value) { z_here[slot] = value; }
#else
vec2 phase_at(Level level, uint slot_of_all) { return z[slot_of_all]; }

void set_phase(Level level, uint slot, vec2 value) { z[level.first_slot + slot] = value; }
#endif
