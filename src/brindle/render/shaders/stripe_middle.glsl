// Whether a stripe covers the middle of a pixel, 1 or 0: the unfiltered stripes of
// stripe_coverage.glsl.
float covered_share(float u, float footprint, float width) {
  return abs(u - floor(u + 0.5)) <= 0.5 * width && width > 0.0 ? 1.0 : 0.0;
}
