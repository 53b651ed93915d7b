// A disc with a thin light border, which sets it off from dark stripes.

in vec2 disc;
flat in vec3 mark_color;

layout(location = 0) out vec4 color;

void main() {
  float radius = length(disc);
  float pixel = max(length(vec2(dFdx(disc.x), dFdy(disc.y))) * 0.7071, 1e-4);
  float alpha = clamp((1.0 - radius) / pixel, 0.0, 1.0);
  float inside = clamp((0.78 - radius) / pixel + 0.5, 0.0, 1.0);
  color = vec4(mix(vec3(0.95), mark_color, inside) * alpha, alpha);
}
