// What lets depth be seen.

uniform vec2 depth_range;  // of all surfaces: distances of the nearest and of the farthest point
uniform vec3 haze_color;

vec3 with_depth_cue(vec3 light, SurfacePoint p) {
  if (kDepthCue == 0) return light;
  float depth =
      clamp((-p.view_position.z - depth_range.x) / (depth_range.y - depth_range.x), 0.0, 1.0);
  if (kDepthCue == 2) return mix(light, haze_color, 0.85 * depth * depth * (3.0 - 2.0 * depth));
  // From red to blue through violet: between the ends, green would be a third landmark.
  vec3 near = vec3(0.86, 0.07, 0.05), far = vec3(0.05, 0.12, 0.80);
  vec3 hue = mix(near, far, smoothstep(0.0, 1.0, depth));
  float brightness = dot(light, vec3(0.2126, 0.7152, 0.0722));
  // Dark strokes stay dark, light surfaces take the hue.
  return hue * brightness * 1.3 + 0.12 * light;
}
