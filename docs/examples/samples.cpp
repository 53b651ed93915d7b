// Samples where two patterns cross. Built and run by the tests.
#include <cstdio>
#include <vector>

#include "brindle/brindle.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::TexturePattern pattern =
      brindle::texture_pattern(surface, brindle::smooth_direction_field(surface), 10);
  const std::vector<brindle::Sample> samples =
      brindle::stripe_samples(surface, pattern.u, pattern.v);
  std::printf("%zu samples\n", samples.size());
  brindle::write_samples("samples.csv", samples);
}
