// Discs that face the camera, 6 vertices each.

layout(std430, binding = 0) readonly buffer Marks { float marks[]; };  // position, linear colour

uniform mat4 view_from_world;
uniform mat4 clip_from_view;
uniform vec4 tile;
uniform vec3 origin;
uniform vec4 slice;      // as in visible_triangles.vert
uniform vec2 mark_size;  // radius of a disc in clip coordinates of the whole picture

out vec2 disc;
flat out vec3 mark_color;

void main() {
  uint first = 6u * (uint(gl_VertexID) / 6u);
  uint corner = uint(gl_VertexID) % 6u;
  vec3 position = vec3(marks[first], marks[first + 1u], marks[first + 2u]) - origin;
  mark_color = vec3(marks[first + 3u], marks[first + 4u], marks[first + 5u]);
  disc = vec2(corner == 1u || corner == 4u || corner == 5u ? 1.0 : -1.0,
              corner == 2u || corner == 3u || corner == 5u ? 1.0 : -1.0);

  // Moved towards the eye by its radius, so that a slanted surface does not cut the disc.
  vec3 center = (view_from_world * vec4(position, 1.0)).xyz;
  bool orthographic = clip_from_view[3][3] == 1.0;
  float radius = mark_size.y * (orthographic ? 1.0 : -center.z) / clip_from_view[1][1];
  center = orthographic ? center + vec3(0.0, 0.0, radius) : center * (1.0 + radius / center.z);
  gl_Position = clip_from_view * vec4(center, 1.0);
  gl_Position.xy += disc * mark_size * gl_Position.w;
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
  // A mark is visible if its centre is.
  if (dot(slice.xyz, position) + slice.w > 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
