// Stripes that follow a turning field. Built and run by the tests.
#include <cmath>
#include <cstdio>
#include <vector>

#include "brindle/direction_field.h"
#include "brindle/shapes.h"
#include "brindle/stripe_animator.h"
#include "brindle/surface.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const std::size_t vertices = surface.mesh.vertex_count();
  const std::vector<float> frequencies(vertices, 20 / bounding_box(surface.mesh).diagonal());
  brindle::StripeAnimator animator(surface.neighborhood);
  for (int number = 0; number < 10; ++number) {
    const float angle = 0.02f * static_cast<float>(number);  // your own input, in your program
    const auto directions = brindle::projected_direction_field(
        {std::cos(angle), std::sin(angle), 0.3f}, surface.normals);
    const brindle::FrameResult frame =
        animator.frame({surface.mesh.positions, directions, frequencies});
    std::printf("frame %d: phases moved by %.3f radians on average\n", number, frame.phase_step);
  }
}
