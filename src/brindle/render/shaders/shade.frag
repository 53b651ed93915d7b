// The light of the visible parts of one surface: one evaluation per group of samples, weighted by
// their number.

uniform usampler2D groups;  // from group_samples.frag
uniform int group;          // the one to shade
uniform int last_group;     // includes all further ones
uniform int first_number;   // of the surface's triangles
uniform int triangle_count;
uniform bool middle_of_samples;  // whether gaps between samples may belong to no surface
uniform bool shading;
uniform vec3 base_color;
uniform vec2 depth_range;  // nearest and farthest point of all surfaces
uniform vec3 haze_color;

layout(location = 0) out vec4 color;

vec3 linear_light(vec3 srgb) {
  return mix(pow((srgb + 0.055) / 1.055, vec3(2.4)), srgb / 12.92, lessThan(srgb, vec3(0.04045)));
}

// Overrides the colour of single triangles.
vec3 with_paint(vec3 surface, uint triangle) {
  if (!kTriangleColors) return surface;
  vec4 paint = paint_of(triangle);
  return mix(surface, linear_light(paint.rgb), paint.a);
}

// Applies the depth cue.
vec3 with_depth_cue(vec3 light, SurfacePoint p) {
  if (kDepthCue == 0) return light;
  float depth =
      clamp((-p.view_position.z - depth_range.x) / (depth_range.y - depth_range.x), 0.0, 1.0);
  if (kDepthCue == 2) return mix(light, haze_color, 0.85 * depth * depth * (3.0 - 2.0 * depth));
  // From red to blue through violet: green in between would be a third landmark.
  vec3 near = vec3(0.86, 0.07, 0.05), far = vec3(0.05, 0.12, 0.80);
  vec3 hue = mix(near, far, smoothstep(0.0, 1.0, depth));
  float brightness = dot(light, vec3(0.2126, 0.7152, 0.0722));
  // Dark strokes stay dark; light surfaces take the hue.
  return hue * brightness * 1.3 + 0.12 * light;
}

vec4 light_at(SurfacePoint p) {
  vec3 surface = base_color;
  if (kSurfacePlaces) {
    float place = style_value(p, kPlaceOfSurface);
    if (place > kNoValue) surface = scale_color(place);
  }
  if (!pattern_at(surface, p)) return vec4(0.0);
  surface = with_paint(surface, p.triangle);
  if (shading) surface = lit_here(surface, p.view_normal, line_of_sight(p));
  return vec4(with_depth_cue(surface * open_share(p), p), 1.0);
}

void main() {
  uvec4 of_sample =
      uvec4(texelFetch(groups, ivec2(gl_FragCoord.xy), 0).x) >> uvec4(0u, 2u, 4u, 6u) & 3u;
  uvec4 numbers = triangles_here() - 1u - uint(first_number);
  vec4 chosen = shares(equal(min(of_sample, uvec4(last_group)), uvec4(group))) *
      shares(lessThan(numbers, uvec4(triangle_count)));
  uint number = chosen.x > 0.0 ? numbers.x : chosen.y > 0.0 ? numbers.y :
                chosen.z > 0.0 ? numbers.z : numbers.w;
  // A point at which this triangle is certainly visible.
  vec2 place = middle_of(chosen * shares(equal(numbers, uvec4(number))));
  SurfacePoint p = surface_point(surface_triangle(number), gl_FragCoord.xy + place,
                                 gl_FragCoord.xy + (middle_of_samples ? place : vec2(0.0)));
  color = 0.25 * dot(chosen, vec4(1.0)) * light_at(p);
}
