// The shaded surface with its stripes, encoded as sRGB. One evaluation per pixel.

uniform vec3 base_color;      // linear, as all colours
uniform vec3 branch_color;
uniform vec3 singular_color;
uniform bool branches;        // whether irregular triangles are painted
uniform vec3 up;              // the world's up in view coordinates

flat in uint triangle;

layout(location = 0) out vec4 color;

vec3 encoded(vec3 linear) {
  vec3 l = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(l, vec3(1.0 / 2.4)) - 0.055, 12.92 * l,
             vec3(lessThan(l, vec3(0.0031308))));
}

vec3 with_kind(vec3 surface) {
  uint kind = branches ? kind_of(triangle) : 0u;
  if (kind == 1u) return mix(surface, branch_color, 0.85);
  if (kind == 2u) return mix(surface, singular_color, 0.85);
  return surface;
}

void main() {
  SurfacePoint p = surface_point(surface_triangle(triangle), gl_FragCoord.xy, gl_FragCoord.xy);
  vec3 surface = with_kind(with_pattern(base_color, p));
  color = vec4(encoded(lit(surface, p.view_normal, line_of_sight(p), up)), 1.0);
}
