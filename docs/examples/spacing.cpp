// Stripes whose spacing yields. Built and run by the tests.
#include <cstdio>

#include "brindle/brindle.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("trefoil"));
  const auto field = brindle::projected_direction_field({0.31f, 0.9f, 0.27f}, surface.normals);
  for (const float slack : {0.0f, 0.1f, 0.25f, 0.5f}) {
    brindle::StripeOptions options;
    options.slack = slack;
    const brindle::StripePattern pattern = brindle::stripe_pattern(surface, field, 13, options);
    std::printf("slack %.2f: %zu branches, angle error %.2f degrees\n", static_cast<double>(slack),
                pattern.quality.branches, pattern.quality.angle_error_mean_deg);
  }
}
