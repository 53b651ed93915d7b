// Crosses of a field that is turned step by step. Built and run by the tests.
#include <cstdio>

#include "brindle/cross_animator.h"
#include "brindle/direction_field.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("box"));
  const auto frequencies = brindle::constant_frequency_field(16, surface.mesh.vertex_count());
  const auto field = brindle::smooth_direction_field(surface, {.symmetry = 4});
  brindle::CrossAnimator animator(surface);
  for (int i = 0; i < 3; ++i) {
    const auto turned = brindle::rotated(field, surface.normals, 0.1f * static_cast<float>(i));
    const auto frame = animator.frame({{surface.mesh.positions, turned, frequencies}, {}});
    std::printf("%zu branches, tiles are off by %.1f degrees\n", frame.quality.branches,
                frame.texture.angle_mean_deg);
  }
}
