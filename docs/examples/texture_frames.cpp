// A texture that follows a field turned step by step. Built and run by the tests.
#include <cstdio>

#include "brindle/direction_field.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_animator.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const auto frequencies = brindle::constant_frequency_field(16, surface.mesh.vertex_count());
  const auto field = brindle::smooth_direction_field(surface);
  brindle::TextureAnimator animator(surface);
  for (int i = 0; i < 3; ++i) {
    const auto turned = brindle::rotated(field, surface.normals, 0.1f * static_cast<float>(i));
    const auto frame = animator.frame({{surface.mesh.positions, turned, frequencies}, {}, {}});
    std::printf("the seam has %zu edges, tiles are off by %.1f degrees\n",
                frame.pattern.seams.turned, frame.pattern.quality.angle_mean_deg);
  }
}
