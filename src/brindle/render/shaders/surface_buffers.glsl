// The surface and its waves by vertex and triangle number, so that every pixel can read the corners
// of its triangle.

uniform usamplerBuffer triangle_vertices;
uniform samplerBuffer positions;
uniform samplerBuffer normals;
uniform samplerBuffer waves;   // direction, frequency
uniform samplerBuffer phases;  // z
uniform usamplerBuffer triangle_colors;

uniform vec3 origin;  // subtracted from positions, to keep precision far from zero

uvec3 vertices_of(uint triangle) { return texelFetch(triangle_vertices, int(triangle)).xyz; }

vec3 position_of(uint vertex) { return texelFetch(positions, int(vertex)).xyz; }

vec3 normal_of(uint vertex) { return texelFetch(normals, int(vertex)).xyz; }

vec4 wave_of_vertex(uint vertex) { return texelFetch(waves, int(vertex)); }

vec2 phase_of(uint vertex) { return texelFetch(phases, int(vertex)).xy; }

vec4 paint_of(uint triangle) {
  return unpackUnorm4x8(texelFetch(triangle_colors, int(triangle)).x);
}
