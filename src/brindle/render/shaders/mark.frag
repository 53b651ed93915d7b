// A disc with a thin light border, to stand out from dark stripes.

in vec2 disc;
flat in vec3 mark_color;

layout(location = 0) out vec4 color;

// The share of the pixel's samples with nothing in front of the disc.
float seen() {
  vec4 before = mix(vec4(0.0), vec4(1.0), lessThan(vec4(gl_FragCoord.z), depths_around(vec2(0.0))));
  return 0.25 * dot(before, vec4(1.0));
}

void main() {
  float radius = length(disc);
  float pixel = max(length(vec2(dFdx(disc.x), dFdy(disc.y))) * 0.7071, 1e-4);
  float alpha = clamp((1.0 - radius) / pixel, 0.0, 1.0) * seen();
  float inside = clamp((0.78 - radius) / pixel + 0.5, 0.0, 1.0);
  color = vec4(mix(vec3(0.95), mark_color, inside) * alpha, alpha);
}
