// Vertex values of the strokes and colours of a surface.

layout(std430, binding = 0) readonly buffer StyleValues { float style_values[]; };
layout(std430, binding = 1) readonly buffer SecondWaves { vec4 second_waves[]; };
layout(std430, binding = 2) readonly buffer SecondPhases { vec2 second_phases[]; };

const uint kStyleValues = 8u;  // per vertex: width, opacity and colour of the first strokes, of the second ones, colour of the surface, value of regions
const uint kPlaceOfSurface = 6u;
const uint kValueOfRegion = 7u;
const uint kSizeOfTile = 0u;  // shares the place of strokes, as does the next
const uint kPlaceOfMotif = 1u;
const float kNoValue = -1e30;

// The value at a point; far below zero if a corner has none.
float style_value(SurfacePoint p, uint which) {
  vec3 values;
  for (int m = 0; m < 3; ++m) values[m] = style_values[kStyleValues * p.vertices[m] + which];
  if (min(values.x, min(values.y, values.z)) <= kNoValue) return kNoValue;
  return dot(values, p.barycentric);
}

// The colour map.

uniform sampler1D color_map;  // linear light
uniform bool has_threshold;
uniform float threshold;
uniform vec3 beyond_color;

vec3 scale_color(float place) {
  if (has_threshold && place >= threshold) return beyond_color;
  float texels = float(textureSize(color_map, 0));
  return texture(color_map, (clamp(place, 0.0, 1.0) * (texels - 1.0) + 0.5) / texels).rgb;
}
