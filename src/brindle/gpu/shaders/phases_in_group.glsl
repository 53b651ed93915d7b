// Phases of a level that one group works on alone: near at hand.
const uint kMostHere = 4096u;
shared vec2 z_here[kMostHere];

vec2 phase_at(Level level, uint slot_of_all) { return z_here[slot_of_all - level.first_slot]; }

void set_phase(Level level, uint slot, vec2 value) { z_here[slot] = value; }
