// Stripes on points without triangles. Built and run by the tests.
#include <cstdio>

#include "brindle/frequency_field.h"
#include "brindle/points.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"

int main() {
  const brindle::Mesh mesh = brindle::make_shape("torus");  // or read_points("scan.ply").cloud
  brindle::LoadedPoints loaded = brindle::make_point_cloud(mesh.positions);
  const brindle::Surface points = brindle::make_point_surface(std::move(loaded.cloud));
  const brindle::StripePattern pattern = brindle::stripe_pattern(
      points, {points.mesh.positions, brindle::smooth_direction_field(points),
               brindle::constant_frequency_field(12, points.mesh.vertex_count())});
  // pattern.solution.z: one phase exp(i Phi) per point, for SplatDrawing and point_samples
  std::printf("%zu points, energy %.4f, angles off by %.1f degrees\n", points.normals.size(),
              pattern.solution.energy, pattern.quality.angle_error_mean_deg);
}
