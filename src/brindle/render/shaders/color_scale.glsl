// Colours of values.

uniform sampler1D color_map;  // linear light
uniform bool has_threshold;
uniform float threshold;
uniform vec3 beyond_color;

vec3 scale_color(float place) {
  if (has_threshold && place >= threshold) return beyond_color;
  float texels = float(textureSize(color_map, 0));
  return texture(color_map, (clamp(place, 0.0, 1.0) * (texels - 1.0) + 0.5) / texels).rgb;
}
