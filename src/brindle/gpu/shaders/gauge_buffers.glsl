// Gauges of all slots, and what the couplings of a level become between them.

#ifndef BETWEEN_INVOCATIONS
#define BETWEEN_INVOCATIONS restrict
#endif

layout(std430, binding = 5) BETWEEN_INVOCATIONS buffer Gauges { uvec2 gauge[]; };
layout(std430, binding = 7) BETWEEN_INVOCATIONS buffer Scratch { uvec2 gauged[]; };
