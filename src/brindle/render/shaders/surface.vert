// Draws 3 vertices a triangle, without indices: each carries its exact barycentric coordinates.

uniform mat4 view_from_world;
uniform mat4 clip_from_view;
uniform vec4 tile;  // scale and offset of clip coordinates: the part of the picture being drawn
uniform bool smooth_normals;

flat out uint triangle;

// At the pixel's centre, which may lie outside where the triangle covers only a part of the pixel.
out vec3 centre_barycentric;
// Where the triangle covers the pixel.
centroid out vec3 barycentric;
centroid out vec3 clip_position;  // x, y and w
centroid out vec3 view_position;
centroid out vec3 view_normal;

void main() {
  triangle = uint(gl_VertexID) / 3u;
  uint corner = uint(gl_VertexID) % 3u;
  vec3 a = position_of(vertex_of(triangle, 0u)) - origin;
  vec3 b = position_of(vertex_of(triangle, 1u)) - origin;
  vec3 c = position_of(vertex_of(triangle, 2u)) - origin;
  vec3 position = corner == 0u ? a : corner == 1u ? b : c;

  // Vertex normals follow the winding of this triangle: its neighbours may be wound against it.
  vec3 normal = cross(b - a, c - a);
  if (smooth_normals) {
    vec3 vertex_normal = normal_of(vertex_of(triangle, corner));
    if (dot(vertex_normal, vertex_normal) > 0.0) {
      normal = dot(vertex_normal, normal) < 0.0 ? -vertex_normal : vertex_normal;
    }
  }

  barycentric = vec3(corner == 0u, corner == 1u, corner == 2u);
  centre_barycentric = barycentric;
  view_position = (view_from_world * vec4(position, 1.0)).xyz;
  view_normal = mat3(view_from_world) * (dot(normal, normal) > 0.0 ? normalize(normal) : normal);
  gl_Position = clip_from_view * vec4(view_position, 1.0);
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
  clip_position = gl_Position.xyw;
}
