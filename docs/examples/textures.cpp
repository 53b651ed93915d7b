// A checkerboard over a torus, and how square it is. Built and run by the tests.
#include <cstdio>

#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::WaveSet waves{surface.mesh.positions, brindle::smooth_direction_field(surface),
                               brindle::constant_frequency_field(16, surface.mesh.vertex_count())};
  const brindle::TexturePattern texture = brindle::texture_pattern(surface, waves);
  std::printf("angles are off by %.1f degrees on average, the seam has %zu edges\n",
              texture.quality.angle_mean_deg, texture.seams.turned);
  const brindle::TextureFragment fragment =
      brindle::texture_fragment(texture.waves.u[0], texture.waves.v[0], {0.2f, 0.3f, 0.5f});
  std::printf("u = %.3f, v = %.3f\n", brindle::texture_coordinate(fragment.u.z),
              brindle::texture_coordinate(fragment.v.z));
}
