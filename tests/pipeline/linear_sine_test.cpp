// What programs show that know values at vertices alone, and lines between them (docs/paraview.md).
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/fragment_phase.h"
#include "brindle/frequency_field.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

/// The period over how far a vertex's edges run along its wave, the median of all vertices.
double edges_per_period(const Surface& surface, const WaveSet& waves) {
  std::vector<double> edges;
  for (Index v = 0; v < waves.directions.size(); ++v) {
    double sum = 0;
    const auto neighbors = surface.neighborhood->of(v);
    for (const Index n : neighbors) {
      const Vec3 edge = surface.mesh.positions[n] - surface.mesh.positions[v];
      sum += std::abs(static_cast<double>(edge.dot(waves.directions[v])));
    }
    edges.push_back(static_cast<double>(neighbors.size()) / (sum * waves.frequencies[v]));
  }
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  return *middle;
}

struct Shown {
  double edges_per_period = 0;
  double sine_wrong = 0;    ///< share of the area where the interpolated sine has the wrong sign
  double cosine_wrong = 0;  ///< the same of the cosine, in the sense of the first corner
};

/// Stripes of a line field, askew to the lines of regular meshes: every other direction, at random,
/// points the other way.
Shown shown(const Surface& surface, float stripes) {
  WaveSet waves{
      surface.mesh.positions, rotated(smooth_direction_field(surface), surface.normals, 0.5f),
      constant_frequency_field(frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal()),
                               surface.mesh.vertex_count())};
  testing_support::flip_half(waves, 5);
  const StripePattern pattern = stripe_pattern(surface, waves);
  const std::vector<Complex>& z = pattern.solution.z;
  Shown result{edges_per_period(surface, waves)};
  double area = 0;
  constexpr int kSteps = 4;
  for (const Triangle& t : surface.mesh.triangles) {
    const auto corners = corner_waves(t, waves, z);
    const auto& p = surface.mesh.positions;
    const double weight = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; i + j < kSteps; ++j) {
        const Vec3 b = (Vec3(static_cast<float>(i), static_cast<float>(j),
                             static_cast<float>(kSteps - 1 - i - j)) +
                        Vec3::Constant(1.0f / 3)) /
                       static_cast<float>(kSteps);
        const Complex there = fragment_phase(corners, b).z;
        const Complex mean = b[0] * z[t[0]] + b[1] * z[t[1]] + b[2] * z[t[2]];
        area += weight;
        result.sine_wrong += (mean.imag() > 0) != (there.imag() > 0) ? weight : 0;
        result.cosine_wrong += (mean.real() > 0) != (there.real() > 0) ? weight : 0;
      }
    }
  }
  result.sine_wrong /= area;
  result.cosine_wrong /= area;
  return result;
}

TEST(LinearSine, ShowsStripesFromSixEdgesAPeriod) {
  for (const std::string shape : {"torus,resolution=128", "sphere,resolution=24", "trefoil"}) {
    const Surface surface = make_surface(make_shape(shape));
    double last = 1;
    const double once = shown(surface, 10).edges_per_period * 10;
    for (const double edges : {2.0, 3.0, 4.0, 6.0, 8.0, 12.0}) {
      const Shown now = shown(surface, static_cast<float>(once / edges));
      SCOPED_TRACE(shape + (" at " + std::to_string(edges)) + " edges a period: sine wrong in " +
                   std::to_string(now.sine_wrong) + " of the area, cosine in " +
                   std::to_string(now.cosine_wrong));
      EXPECT_NEAR(now.edges_per_period, edges, 0.05 * edges);
      EXPECT_LT(now.sine_wrong, last);
      last = now.sine_wrong;
      if (edges >= 6) {
        EXPECT_LT(now.sine_wrong, 0.05);
      }
      // However many edges there are: every other direction points the other way.
      EXPECT_GT(now.cosine_wrong, 0.3);
    }
  }
}

}  // namespace
}  // namespace brindle
