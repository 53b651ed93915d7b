// Samples where two patterns cross. Built and run by the tests.
#include <cstdio>
#include <vector>

#include "brindle/files.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_pattern.h"

int main() {
  const brindle::Surface surface = brindle::make_surface(brindle::make_shape("torus"));
  const brindle::Mesh& mesh = surface.mesh;
  const brindle::TexturePattern pattern = brindle::texture_pattern(
      surface, {mesh.positions, brindle::smooth_direction_field(surface),
                brindle::constant_frequency_field(10, mesh.vertex_count())});
  std::vector<brindle::Sample> samples =
      brindle::wave_samples(mesh, surface.normals, brindle::sampled_waves(mesh, pattern.waves.u),
                            brindle::sampled_waves(mesh, pattern.waves.v));
  brindle::drop_doubles(samples);
  std::printf("%zu samples\n", samples.size());
  brindle::write_samples("samples.csv", samples);
}
