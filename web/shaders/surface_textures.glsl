// The surface and its waves in textures, by number of vertex and triangle: the twin of
// surface_buffers.glsl of the library for WebGL 2, which has no buffer textures.

const int kRowBits = 11;

uniform highp usampler2D triangle_vertices;
uniform highp sampler2D positions;
uniform highp sampler2D normals;
uniform highp sampler2D waves;   // direction, frequency
uniform highp sampler2D phases;  // z
uniform highp usampler2D triangle_kinds;

uniform vec3 origin;  // taken off every position: a surface far from zero keeps its digits

ivec2 place_of(uint number) {
  return ivec2(int(number) & ((1 << kRowBits) - 1), int(number) >> kRowBits);
}

uvec3 vertices_of(uint triangle) { return texelFetch(triangle_vertices, place_of(triangle), 0).xyz; }

vec3 position_of(uint vertex) { return texelFetch(positions, place_of(vertex), 0).xyz; }

vec3 normal_of(uint vertex) { return texelFetch(normals, place_of(vertex), 0).xyz; }

vec4 wave_of_vertex(uint vertex) { return texelFetch(waves, place_of(vertex), 0); }

vec2 phase_of(uint vertex) { return texelFetch(phases, place_of(vertex), 0).xy; }

uint kind_of(uint triangle) { return texelFetch(triangle_kinds, place_of(triangle), 0).x; }
