// A surface without a pattern.
vec3 with_pattern(vec3 surface, SurfacePoint p) { return surface; }
