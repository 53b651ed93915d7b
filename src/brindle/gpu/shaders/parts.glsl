// What the groups of a dispatch add up to, one part a group.
layout(std430, binding = 7) buffer Parts { vec4 parts[]; };
