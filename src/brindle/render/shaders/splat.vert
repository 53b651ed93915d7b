// Discs in the tangent planes of points, 6 vertices each.

struct Splat {
  vec4 position_radius;
  vec4 normal_turns;
  vec4 direction_frequency;
};

layout(std430, binding = 0) readonly buffer Splats { Splat splats[]; };

uniform mat4 view_from_world;
uniform mat4 clip_from_view;
uniform vec4 tile;  // scale and offset of clip coordinates: the part of the picture being drawn
uniform vec3 origin;
uniform vec4 slice;  // as in visible_triangles.vert
uniform bool behind;

out vec2 disc;  // across the disc, from -1 to 1; x runs along the wave
out vec3 view_position;
flat out vec3 view_normal;
flat out float turns;             // of the phase at the centre
flat out float turns_per_radius;  // along x
flat out float has_wave;

// Any unit tangent vector.
vec3 any_tangent(vec3 normal) {
  vec3 axis = abs(normal.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  return normalize(cross(normal, axis));
}

void main() {
  Splat splat = splats[uint(gl_VertexID) / 6u];
  uint corner = uint(gl_VertexID) % 6u;
  disc = vec2(corner == 1u || corner == 4u || corner == 5u ? 1.0 : -1.0,
              corner == 2u || corner == 3u || corner == 5u ? 1.0 : -1.0);
  float radius = splat.position_radius.w;
  vec3 normal = splat.normal_turns.xyz;
  vec3 along = splat.direction_frequency.xyz;
  has_wave = along == vec3(0.0) ? 0.0 : 1.0;
  if (has_wave == 0.0) along = any_tangent(normal);
  turns = splat.normal_turns.w;
  turns_per_radius = splat.direction_frequency.w * radius;

  vec3 center = splat.position_radius.xyz - origin;
  vec3 position = center + radius * (disc.x * along + disc.y * cross(normal, along));
  gl_ClipDistance[0] = -(dot(slice.xyz, position) + slice.w);
  view_position = (view_from_world * vec4(position, 1.0)).xyz;
  view_normal = mat3(view_from_world) * normal;
  if (behind) {
    // Along the line of sight, so that the disc covers the same pixels.
    float depth = -(view_from_world * vec4(center, 1.0)).z;
    bool orthographic = clip_from_view[3][3] == 1.0;
    view_position = orthographic ? view_position - vec3(0.0, 0.0, radius)
                                 : view_position * (1.0 + radius / max(depth, radius));
  }
  gl_Position = clip_from_view * vec4(view_position, 1.0);
  gl_Position.xy = gl_Position.xy * tile.xy + gl_Position.w * tile.zw;
}
