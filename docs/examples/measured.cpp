// Stripes along noisy data, seen at the scale of the stripes. Built and run by the tests.
#include <cmath>
#include <cstdio>

#include "brindle/measured_field.h"
#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("molecule"));
  brindle::MeasuredField measured;
  for (const brindle::Vec3& p : surface.mesh.positions) {
    const float noise = std::sin(4e4f * p.x());
    measured.directions.push_back({-p.y() + 0.3f * noise, p.x(), 0.5f});
  }
  const brindle::FrequencyField frequencies(measured.directions.size(), 12.0f);
  brindle::FieldSmoothing smoothing(surface, {.periods = 1});
  const brindle::SmoothedField field = smoothing.frame(measured, frequencies);
  const brindle::StripePattern pattern =
      brindle::stripe_pattern(surface, field.directions, frequencies);
  std::printf("turned by %.1f degrees, %zu branches\n", smoothing.metrics().turned_median_deg,
              pattern.quality.branches);
}
