// What is painted over single triangles.

uniform bool has_triangle_colors;

vec3 linear_light(vec3 srgb) {
  return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThan(srgb, vec3(0.04045)));
}

vec3 with_paint(vec3 surface, uint triangle) {
  if (!has_triangle_colors) return surface;
  vec4 paint = paint_of(triangle);
  return mix(surface, linear_light(paint.rgb), paint.a);
}
