// Finishes the picture from linear light: averages the kShadingSide x kShadingSide evaluations in a
// pixel, adds the background, encodes as sRGB and dithers, because rounding would show as bands in
// the gradient.

uniform sampler2D light;  // premultiplied alpha
uniform ivec2 tile_corner;    // in the finished picture, from the lower left
uniform vec2 picture_size;
uniform vec3 background_center;
uniform vec3 background_edge;
uniform bool transparent;

layout(location = 0) out vec4 color;

// The power 1 / 2.4 as a polynomial of the fourth root, within 0.01 levels of 255.
vec3 srgb(vec3 linear) {
  vec3 l = clamp(linear, 0.0, 1.0);
  vec3 s = sqrt(l);
  vec3 q = sqrt(s);
  vec3 encoded = s * (0.08132099 * s - 0.33546956 * q + 1.12264442) + 0.19615292 * q - 0.06461414;
  return mix(encoded, 12.92 * l, lessThan(l, vec3(0.0031308)));
}

// Jimenez 2014: interleaved gradient noise.
float dither(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main() {
  vec4 sum = vec4(0.0);
  ivec2 first = ivec2(gl_FragCoord.xy) * kShadingSide;
  for (int y = 0; y < kShadingSide; ++y) {
    for (int x = 0; x < kShadingSide; ++x) sum += texelFetch(light, first + ivec2(x, y), 0);
  }
  sum /= float(kShadingSide * kShadingSide);

  vec2 pixel = gl_FragCoord.xy + vec2(tile_corner);
  if (transparent) {
    color = vec4(srgb(sum.rgb / max(sum.a, 1e-6)), sum.a);
  } else {
    vec2 place = pixel / picture_size - vec2(0.5, 0.54);
    float away = smoothstep(0.0, 0.8, length(place));
    vec3 behind = mix(background_center, background_edge, away);
    color = vec4(srgb(sum.rgb + (1.0 - sum.a) * behind), 1.0);
  }
  color.rgb += dither(pixel) / 255.0;
}
