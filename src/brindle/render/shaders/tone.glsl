// How light a white surface would look, 0 to 1, even to the eye.
float tone_at(SurfacePoint p) {
  vec3 light = lit_here(vec3(1.0), p.view_normal, line_of_sight(p));
  return pow(clamp(dot(light, vec3(0.2126, 0.7152, 0.0722)), 0.0, 1.0), 1.0 / 2.2);
}
