// A point in the middle of a triangle, moved towards the viewer so that a curved surface does not
// cut it.

uniform mat4 view_from_world;
uniform mat4 clip_from_view;
uniform highp usampler2D marks;  // numbers of triangles
uniform float mark_size;         // in pixels

flat out uint kind;

void main() {
  uint triangle = texelFetch(marks, pattern_place(gl_VertexID, textureSize(marks, 0).x), 0).x;
  uvec3 v = vertices_of(triangle);
  vec3 middle = (position_of(v.x) + position_of(v.y) + position_of(v.z)) / 3.0 - origin;
  kind = kind_of(triangle);
  gl_Position = clip_from_view * (view_from_world * vec4(middle, 1.0));
  gl_Position.z -= 0.03 * gl_Position.w;
  gl_PointSize = mark_size;
}
