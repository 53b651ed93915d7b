// Level stripes on a mesh. Built and run by the tests.
#include <cstdio>

#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("vessels"));
  const float frequency = 50 / bounding_box(surface.mesh).diagonal();
  const brindle::StripePattern pattern = brindle::stripe_pattern(
      surface, brindle::projected_direction_field({0, 0, 1}, surface.normals), frequency);
  // pattern.solution.z: one phase exp(i Phi) per vertex; pattern.corners: linear phases by triangle
  std::printf("energy %.4f, %zu branches, angles off by %.1f degrees\n", pattern.solution.energy,
              pattern.quality.branches, pattern.quality.angle_error_mean_deg);
}
