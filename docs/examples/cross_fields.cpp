// A texture along both waves of a cross field. Built and run by the tests.
#include <cstdio>

#include "brindle/cross_texture.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("box"));
  const brindle::WaveSet waves{
      surface.mesh.positions,
      brindle::smooth_direction_field(surface, {.symmetry = 4, .curvature_anchor = 0.1f}),
      brindle::constant_frequency_field(16, surface.mesh.vertex_count())};
  const brindle::CrossPattern cross = brindle::cross_pattern(surface, waves);
  const brindle::CrossTexture texture = brindle::cross_texture(surface, cross);
  // texture.pattern.waves: U and V at every corner of texture.surface.mesh, for SurfaceDrawing
  std::printf("%zu singularities, %zu branches, angles of tiles off by %.2f degrees\n",
              cross.quality.field_singularities, cross.quality.branches,
              texture.pattern.quality.angle_mean_deg);
}
