// The integral of a tent from -1 to t.
float tent_integral(float t) {
  float s = clamp(t, -1.0, 1.0);
  return s < 0.0 ? 0.5 * (1.0 + s) * (1.0 + s) : 1.0 - 0.5 * (1.0 - s) * (1.0 - s);
}

// The share of a pixel that a stripe covers: a periodic pulse of this width around u = 0, in
// periods, symmetric in u, filtered with a tent two pixels wide (a box filter, twice). Finer
// stripes become their mean. `footprint` is the width of a pixel in periods.
float covered_share(float u, float footprint, float width) {
  footprint = max(footprint, 1e-6);
  if (footprint > 1.5) return width;
  u -= floor(u + 0.5);
  float coverage = 0.0;
  for (float period = -2.0; period <= 2.0; period += 1.0) {
    coverage += tent_integral((u - period + 0.5 * width) / footprint) -
                tent_integral((u - period - 0.5 * width) / footprint);
  }
  return mix(coverage, width, smoothstep(0.75, 1.25, footprint));
}
