// The shadow on visible ground.

uniform sampler2D shadow;
uniform mat4 clip_from_view;
uniform mat4 view_from_world;
uniform vec4 tile;         // as in visible_triangles.vert
uniform vec2 target_size;  // in pixels
uniform vec3 ground;       // a point on it, relative to `origin`
uniform vec3 across, away, upwards;  // the world's axes: two along the ground, one off it
uniform vec4 shadow_place;  // lower corner along these axes, relative to `ground`, and 1 / sides

layout(location = 0) out vec4 color;

void main() {
  float share = 0.25 * dot(shares(equal(triangles_here(), uvec4(0u))), vec4(1.0));
  vec2 clip = ((2.0 * gl_FragCoord.xy / target_size - 1.0) - tile.zw) / tile.xy;
  bool orthographic = clip_from_view[3][3] == 1.0;
  vec2 middle = orthographic ? -clip_from_view[3].xy : clip_from_view[2].xy;
  vec2 place = (clip + middle) / vec2(clip_from_view[0][0], clip_from_view[1][1]);
  mat3 world_from_view = transpose(mat3(view_from_world));
  vec3 ray = world_from_view * vec3(orthographic ? vec2(0.0) : place, -1.0);
  vec3 start = orthographic ? vec3(place, 0.0) : vec3(0.0);
  vec3 eye = world_from_view * (start - view_from_world[3].xyz);
  float fall = dot(ray, upwards);
  float distance = dot(ground - eye, upwards) / (fall == 0.0 ? 1e-9 : fall);
  if (share == 0.0 || distance <= 0.0 || fall >= 0.0) discard;
  vec3 from_ground = eye + distance * ray - ground;
  vec2 uv = (vec2(dot(from_ground, across), dot(from_ground, away)) - shadow_place.xy) *
      shadow_place.zw;
  if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) discard;
  color = vec4(0.0, 0.0, 0.0, share * textureLod(shadow, uv, 0.0).r);
}
