// From linear light to the finished picture: averages samples, lays the background underneath,
// encodes as sRGB and spreads the rounding, which would show as bands in the gradient.

uniform sampler2D light;  // premultiplied with alpha
uniform int supersampling;
uniform ivec2 tile_corner;    // in the finished picture, from the lower left
uniform vec2 picture_size;
uniform vec3 background_center;
uniform vec3 background_edge;
uniform bool transparent;

layout(location = 0) out vec4 color;

vec3 srgb(vec3 linear) {
  vec3 l = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(l, vec3(1.0 / 2.4)) - 0.055, 12.92 * l, lessThan(l, vec3(0.0031308)));
}

// Jimenez 2014: interleaved gradient noise.
float dither(vec2 pixel) {
  return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main() {
  vec4 sum = vec4(0.0);
  ivec2 first = ivec2(gl_FragCoord.xy) * supersampling;
  for (int y = 0; y < supersampling; ++y) {
    for (int x = 0; x < supersampling; ++x) sum += texelFetch(light, first + ivec2(x, y), 0);
  }
  sum /= float(supersampling * supersampling);

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
