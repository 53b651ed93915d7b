// Phases of a level that many groups work on.
vec2 phase_at(Level level, uint slot_of_all) { return z[slot_of_all]; }

void set_phase(Level level, uint slot, vec2 value) { z[level.first_slot + slot] = value; }
