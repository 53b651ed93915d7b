#include "brindle/boundary_phases.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

struct Sleeve {
  Surface surface = make_surface(make_shape("cylinder,resolution=24"));
  WaveSet waves{surface.mesh.positions, projected_direction_field(Vec3::UnitZ(), surface.normals),
                constant_frequency_field(5, surface.mesh.vertex_count())};
};

TEST(BoundaryPhases, AreGivenAtBothRimsAndNowhereElse) {
  const Sleeve sleeve;
  const auto phases = boundary_phases(sleeve.surface, sleeve.waves, 0.25f);
  for (std::size_t v = 0; v < phases.size(); ++v) {
    const float z = sleeve.surface.mesh.positions[v].z();
    EXPECT_NEAR(std::abs(phases[v]), std::abs(z) > 0.999f ? 1 : 0, 1e-6);
    if (phases[v] == Complex(0)) continue;
    // A quarter of a period inwards, sin Phi is 1.
    const float way = z > 0 ? -0.25f : 0.25f;
    const float inside = std::arg(phases[v]) + 2 * std::numbers::pi_v<float> * way;
    EXPECT_NEAR(std::sin(inside), 1, 1e-5);
  }
}

TEST(BoundaryPhases, DoNotDependOnHowDirectionsAreSigned) {
  Sleeve sleeve;
  const auto before = boundary_phases(sleeve.surface, sleeve.waves, 0.3f);
  const auto flipped = testing_support::flip_half(sleeve.waves, 7);
  const auto after = boundary_phases(sleeve.surface, sleeve.waves, 0.3f);
  for (std::size_t v = 0; v < before.size(); ++v) {
    const Complex expected = flipped[v] ? -std::conj(before[v]) : before[v];
    EXPECT_NEAR(std::abs(after[v] - expected), 0, 1e-6);
  }
}

TEST(BoundaryPhases, AreNotGivenWhereStripesRunAcrossTheRim) {
  Sleeve sleeve;
  sleeve.waves.directions =
      rotated(sleeve.waves.directions, sleeve.surface.normals, std::numbers::pi_v<float> / 2);
  for (const Complex& z : boundary_phases(sleeve.surface, sleeve.waves, 0)) {
    EXPECT_EQ(z, Complex(0));
  }
}

TEST(BoundaryPhases, RefuseWhatIsNoPhase) {
  Sleeve sleeve;
  EXPECT_THROW(boundary_phases(sleeve.surface, sleeve.waves, NAN), Error);
  EXPECT_THROW(boundary_phases(sleeve.surface, {}, 0), Error);
}

}  // namespace
}  // namespace brindle
