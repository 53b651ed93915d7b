#include <cstdio>

#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const auto pattern = brindle::stripe_pattern(
      surface, {surface.mesh.positions, brindle::smooth_direction_field(surface),
                brindle::constant_frequency_field(10, surface.mesh.vertex_count())});
  std::printf("energy %.4f, %zu branches\n", pattern.solution.energy, pattern.quality.branches);
}
