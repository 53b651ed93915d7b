// Triangle corners by vertex number: all data are in textures.

uniform mat4 view_from_world;
uniform mat4 clip_from_view;

flat out uint triangle;

void main() {
  triangle = uint(gl_VertexID) / 3u;
  vec3 place = position_of(vertices_of(triangle)[gl_VertexID % 3]);
  gl_Position = clip_from_view * (view_from_world * vec4(place - origin, 1.0));
}
