// Unit directions towards a key light and a weak fill.
struct Lights {
  vec3 key;
  vec3 fill;
};

// A soft key light, a weak fill, light from sky and ground, and a thin rim. `view_normal` is that
// of the visible side; `sight` runs from the viewer to the point. Both may have any length.
vec3 lit_by(Lights lights, vec3 surface, vec3 view_normal, vec3 sight, vec3 up) {
  vec3 n = normalize(view_normal);
  vec3 v = normalize(-sight);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  float key = clamp((dot(n, lights.key) + 0.25) / 1.25, 0.0, 1.0);
  float fill = clamp((dot(n, lights.fill) + 0.40) / 1.40, 0.0, 1.0);
  float sky = 0.5 + 0.5 * dot(n, up);
  vec3 light = key * vec3(0.66, 0.64, 0.61) + fill * vec3(0.12, 0.13, 0.15) +
               mix(vec3(0.17, 0.165, 0.16), vec3(0.30, 0.31, 0.33), sky);
  light *= mix(0.62, 1.0, smoothstep(0.0, 0.55, facing));
  float gloss = pow(clamp(dot(n, normalize(lights.key + v)), 0.0, 1.0), 40.0);
  vec3 reflected = surface * light + vec3(0.035 * gloss);
  reflected += vec3(0.03) * pow(1.0 - facing, 4.0) * sky;
  return reflected;
}

// The key from the upper left and the fill from the right.
Lights usual_lights() {
  return Lights(normalize(vec3(-0.45, 0.70, 0.75)), normalize(vec3(0.85, 0.05, 0.50)));
}

vec3 lit(vec3 surface, vec3 view_normal, vec3 sight, vec3 up) {
  return lit_by(usual_lights(), surface, view_normal, sight, up);
}
