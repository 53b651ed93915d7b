// Positions only, to find visible triangles.

layout(location = 0) in vec3 vertex_position;

uniform mat4 view_from_world;
uniform mat4 clip_from_view;
uniform vec4 tile;    // scale and offset of clip coordinates: the part of the picture being drawn
uniform vec3 origin;  // subtracted from positions, to keep precision far from zero

uniform vec4 slice;   // for positions relative to `origin`: positive ones are cut away

void main() {
  vec3 position = vertex_position - origin;
  vec4 view_position = view_from_world * vec4(position, 1.0);
  gl_Position = clip_from_view * vec4(view_position.xyz, 1.0);
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
  gl_ClipDistance[0] = -(dot(slice.xyz, position) + slice.w);
}
