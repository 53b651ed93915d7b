// The data of `pattern_buffers` as storage buffers. If bindings 0 and 1 are taken, define others
// before.

#ifndef BRINDLE_VERTICES
#define BRINDLE_VERTICES 0
#endif
#ifndef BRINDLE_TRIANGLES
#define BRINDLE_TRIANGLES 1
#endif

layout(std430, binding = BRINDLE_VERTICES) readonly buffer PatternVertices {
  vec4 pattern_vertices[];  // three each
};
layout(std430, binding = BRINDLE_TRIANGLES) readonly buffer PatternTriangles {
  uvec4 pattern_triangles[];
};

vec4 pattern_vertex(uint number, int part) { return pattern_vertices[3u * number + uint(part)]; }

uvec4 pattern_triangle(uint number) { return pattern_triangles[number]; }
