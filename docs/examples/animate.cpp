// Stripes that follow a changing field. Built and run by the tests.
#include <cstdio>

#include "brindle/pipeline/scene.h"
#include "brindle/pipeline/stripe_animator.h"
#include "brindle/surface/shapes.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const float frequency = 20 / bounding_box(surface.mesh).diagonal();
  brindle::Scene scene(surface, {.kind = brindle::SceneKind::vortices, .frequency = frequency});
  brindle::StripeAnimator animator(surface.neighborhood);
  for (int number = 0; number < 10; ++number) {
    const brindle::WaveSet& waves = scene.frame(number).waves;  // your own input, in your program
    const brindle::FrameResult frame =
        animator.frame({waves.positions, waves.directions, waves.frequencies});
    std::printf("frame %d: phases moved by %.3f radians on average\n", number, frame.phase_step);
  }
}
