// The surface and its waves. Vertices are pulled from these buffers by number, so that every
// fragment can read the three corners of its triangle.

layout(std430, binding = 0) readonly buffer Triangles { uint triangle_vertices[]; };
layout(std430, binding = 1) readonly buffer Positions { float positions[]; };
layout(std430, binding = 2) readonly buffer Normals { float normals[]; };
layout(std430, binding = 3) readonly buffer Waves { vec4 waves[]; };  // direction, frequency
layout(std430, binding = 4) readonly buffer Phases { vec2 phases[]; };  // z
layout(std430, binding = 5) readonly buffer TriangleColors { uint triangle_colors[]; };

uniform vec3 origin;  // taken off every position: a surface far from zero keeps its digits

uint vertex_of(uint triangle, uint corner) { return triangle_vertices[3u * triangle + corner]; }

vec3 position_of(uint vertex) {
  return vec3(positions[3u * vertex], positions[3u * vertex + 1u], positions[3u * vertex + 2u]);
}

vec3 normal_of(uint vertex) {
  return vec3(normals[3u * vertex], normals[3u * vertex + 1u], normals[3u * vertex + 2u]);
}
