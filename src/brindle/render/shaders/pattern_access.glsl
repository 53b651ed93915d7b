// Vertices and triangles of the buffers by number. Twin of surface_buffers.glsl.

uniform vec3 origin;  // subtracted from positions, to keep precision far from zero

uvec3 vertices_of(uint triangle) { return pattern_triangle(triangle).xyz; }

uint kind_of(uint triangle) { return pattern_triangle(triangle).w; }

vec3 position_of(uint vertex) { return pattern_vertex(vertex, 0).xyz; }

vec3 normal_of(uint vertex) { return pattern_vertex(vertex, 2).xyz; }

vec4 wave_of_vertex(uint vertex) {
  return vec4(pattern_vertex(vertex, 1).xyz, pattern_vertex(vertex, 0).w);
}

vec2 phase_of(uint vertex) {
  return vec2(pattern_vertex(vertex, 1).w, pattern_vertex(vertex, 2).w);
}
