// The data of `pattern_buffers` as textures of any width, row by row: GL_RGBA32F and GL_RGBA32UI.

uniform highp sampler2D pattern_vertices;  // three texels each
uniform highp usampler2D pattern_triangles;

ivec2 pattern_place(int number, int width) { return ivec2(number % width, number / width); }

vec4 pattern_vertex(uint number, int part) {
  int width = textureSize(pattern_vertices, 0).x;
  return texelFetch(pattern_vertices, pattern_place(3 * int(number) + part, width), 0);
}

uvec4 pattern_triangle(uint number) {
  int width = textureSize(pattern_triangles, 0).x;
  return texelFetch(pattern_triangles, pattern_place(int(number), width), 0);
}
