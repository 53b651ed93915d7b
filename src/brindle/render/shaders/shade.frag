// The lit surface with its pattern, in linear light: one evaluation for a group of samples, weighted
// by how many they are.

uniform usampler2D groups;  // as group_samples.frag writes them
uniform int group;          // the one to shade
uniform int last_group;     // which all further ones join
uniform vec3 base_color;
uniform bool shading;

layout(location = 0) out vec4 color;

vec3 light_at(SurfacePoint p) {
  vec3 surface = with_paint(with_pattern(base_color, p), p.triangle);
  return shading ? lit_here(surface, p.view_normal, line_of_sight(p)) : surface;
}

void main() {
  uvec4 of_sample =
      uvec4(texelFetch(groups, ivec2(gl_FragCoord.xy), 0).x) >> uvec4(0u, 2u, 4u, 6u) & 3u;
  uvec4 triangles = triangles_here();
  vec4 chosen = shares(equal(min(of_sample, uvec4(last_group)), uvec4(group))) *
      shares(notEqual(triangles, uvec4(0u)));
  uint number = chosen.x > 0.0 ? triangles.x : chosen.y > 0.0 ? triangles.y :
                chosen.z > 0.0 ? triangles.z : triangles.w;
  // Where this triangle is seen for certain.
  vec2 place = middle_of(chosen * shares(equal(triangles, uvec4(number))));
  SurfacePoint p = surface_point(surface_triangle(number - 1u), gl_FragCoord.xy + place,
                                 gl_FragCoord.xy);
  color = 0.25 * dot(chosen, vec4(1.0)) * vec4(light_at(p), 1.0);
}
