// A point of a triangle by its position in the picture. Barycentric weights and their derivatives
// are exact: they follow from the corners' clip coordinates, without neighbouring pixels.

uniform mat4 view_from_world;
uniform mat4 clip_from_view;
uniform vec4 tile;         // as in visible_triangles.vert
uniform vec2 target_size;  // in pixels
uniform bool smooth_normals;

struct SurfaceTriangle {
  uint number;
  uvec3 vertices;
  mat3 positions;  // relative to `origin`
  mat3 view;       // positions in view coordinates
  mat3 clip;       // x, y and w in clip coordinates
};

struct SurfacePoint {
  uint triangle;
  uvec3 vertices;
  vec3 barycentric, barycentric_dx, barycentric_dy;  // derivatives per pixel
  vec2 way_to_centre;  // from this point to the pixel's centre, in pixels
  vec3 view_position;
  vec3 view_normal;  // of the visible side
};

bool is_orthographic() { return clip_from_view[3][3] == 1.0; }

// From the viewer to the point, of any length.
vec3 line_of_sight(SurfacePoint p) {
  return is_orthographic() ? vec3(0.0, 0.0, -1.0) : p.view_position;
}

SurfaceTriangle surface_triangle(uint number) {
  SurfaceTriangle t;
  t.number = number;
  t.vertices = vertices_of(number);
  for (int m = 0; m < 3; ++m) {
    t.positions[m] = position_of(t.vertices[m]) - origin;
    t.view[m] = (view_from_world * vec4(t.positions[m], 1.0)).xyz;
    vec4 clip = clip_from_view * vec4(t.view[m], 1.0);
    t.clip[m] = vec3(clip.xy * tile.xy + clip.w * tile.zw, clip.w);
  }
  return t;
}

// Vertex normals, with the sign of this triangle's winding, from which neighbours may differ.
vec3 view_normal_at(SurfaceTriangle t, vec3 weights) {
  vec3 facet = cross(t.positions[1] - t.positions[0], t.positions[2] - t.positions[0]);
  if (dot(facet, facet) > 0.0) facet = normalize(facet);
  vec3 normal = facet;
  if (smooth_normals) {
    normal = vec3(0.0);
    for (int m = 0; m < 3; ++m) {
      vec3 n = normal_of(t.vertices[m]);
      float length_squared = dot(n, n);
      n = dot(n, facet) < 0.0 ? -n : n;
      normal += weights[m] * (length_squared > 0.0 ? n * inversesqrt(length_squared) : facet);
    }
  }
  return mat3(view_from_world) * normal;
}

// `place` is a point of the picture that the triangle covers, `centre` that of its pixel; both in
// pixels from the lower left.
SurfacePoint surface_point(SurfaceTriangle t, vec2 place, vec2 centre) {
  vec2 ndc = 2.0 * place / target_size - 1.0;
  vec2 pixel = 2.0 / target_size;
  vec3 w = vec3(t.clip[0].z, t.clip[1].z, t.clip[2].z);
  // Relative to the place: corners are close to it, and differences of large numbers lose
  // precision.
  vec3 x = vec3(t.clip[0].x, t.clip[1].x, t.clip[2].x) - ndc.x * w;
  vec3 y = vec3(t.clip[0].y, t.clip[1].y, t.clip[2].y) - ndc.y * w;
  vec3 areas = x.yzx * y.zxy - y.yzx * x.zxy;
  vec3 areas_dx = pixel.x * (y.yzx * w.zxy - w.yzx * y.zxy);
  vec3 areas_dy = pixel.y * (w.yzx * x.zxy - x.yzx * w.zxy);
  float sum = areas.x + areas.y + areas.z;
  bool seen_on_edge = sum == 0.0;
  float scale = seen_on_edge ? 0.0 : 1.0 / sum;

  SurfacePoint p;
  p.triangle = t.number;
  p.vertices = t.vertices;
  // Rounding may make a weight slightly negative.
  p.barycentric = seen_on_edge ? vec3(1.0) : max(areas * scale, vec3(0.0));
  p.barycentric /= p.barycentric.x + p.barycentric.y + p.barycentric.z;
  p.barycentric_dx = scale * (areas_dx - p.barycentric * (areas_dx.x + areas_dx.y + areas_dx.z));
  p.barycentric_dy = scale * (areas_dy - p.barycentric * (areas_dy.x + areas_dy.y + areas_dy.z));
  p.way_to_centre = centre - place;
  p.view_position = t.view * p.barycentric;
  p.view_normal = view_normal_at(t, p.barycentric) * (sum < 0.0 ? -1.0 : 1.0);
  return p;
}
