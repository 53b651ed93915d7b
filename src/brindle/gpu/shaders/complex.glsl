// Complex numbers as vec2, and gauges with an embedded bit (twin: phases/sliced_kernels.h).

vec2 times(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }

vec2 conjugate(vec2 a) { return vec2(a.x, -a.y); }

// Stored as integers until used: flushing denormals to zero would lose the bit.
uvec2 with_conjugate_bit(vec2 value, bool conjugated) {
  const uvec2 bits = floatBitsToUint(value);
  return uvec2((bits.x & ~1u) | uint(conjugated), bits.y);
}

bool conjugate_bit(uvec2 bits) { return (bits.x & 1u) != 0u; }

const float kSmallest = 1.17549435e-38;

bool has_direction(vec2 a) { return dot(a, a) > kSmallest; }

vec2 normalized(vec2 a) { return a * inversesqrt(dot(a, a)); }
