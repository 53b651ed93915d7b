// The data of `pattern_buffers` as buffer textures: GL_RGBA32F and GL_RGBA32UI.

uniform samplerBuffer pattern_vertices;    // three texels each
uniform usamplerBuffer pattern_triangles;

vec4 pattern_vertex(uint number, int part) {
  return texelFetch(pattern_vertices, 3 * int(number) + part);
}

uvec4 pattern_triangle(uint number) { return texelFetch(pattern_triangles, int(number)); }
