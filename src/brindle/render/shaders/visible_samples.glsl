// The visibility pass at a pixel: two by two samples around its centre.

uniform usampler2D visible;       // one more than the number of the triangle, 0: nothing
uniform sampler2D visible_depth;  // nothing: 1

// In the order of textureGather: from the upper left, clockwise.
const vec4 kSampleX = vec4(-0.25, 0.25, 0.25, -0.25);
const vec4 kSampleY = vec4(0.25, 0.25, -0.25, -0.25);

vec4 shares(bvec4 chosen) { return mix(vec4(0.0), vec4(1.0), chosen); }

// The mean position of the samples with share 1, from the pixel's centre.
vec2 middle_of(vec4 share) {
  return vec2(dot(share, kSampleX), dot(share, kSampleY)) / dot(share, vec4(1.0));
}

vec2 samples_of_pixel() { return 2.0 * floor(gl_FragCoord.xy) + vec2(1.0); }

uvec4 triangles_here() {
  return textureGather(visible, samples_of_pixel() / vec2(textureSize(visible, 0)));
}

// The depths of four samples at an offset in samples.
vec4 depths_around(vec2 offset) {
  return textureGather(visible_depth,
                       (samples_of_pixel() + offset) / vec2(textureSize(visible_depth, 0)));
}
