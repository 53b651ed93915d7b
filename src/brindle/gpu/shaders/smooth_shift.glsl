// Phase shifts in closed form (twin: edge_shift of phases/sliced_kernels_portable.cpp).

layout(location = 1) uniform bool trapezoid;

EdgeShift edge_shift(Wave j, Wave i) {
  const vec3 e = i.position - j.position;
  const float cosine = dot(i.direction, j.direction);
  const float along_j = dot(e, j.direction);
  const float along_i = dot(e, i.direction);
  const float along = along_j + (cosine < 0.0 ? -along_i : along_i);
  const float distance = along / (trapezoid ? 2.0 : 1.0 + abs(cosine));
  return EdgeShift(cosine, cosine < 0.0, i.root_frequency * j.root_frequency * distance);
}
