// Copies results per pixel to all its samples.

uniform usampler2D pixels;
uniform sampler2D pixel_depths;
uniform int samples;  // along a pixel's side

layout(location = 0) out uint visible;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) / samples;
  visible = texelFetch(pixels, pixel, 0).r;
  if (visible == 0u) discard;
  gl_FragDepth = texelFetch(pixel_depths, pixel, 0).r;
}
