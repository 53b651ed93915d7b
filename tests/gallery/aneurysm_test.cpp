#include "gallery/aneurysm.h"

#include <cmath>

#include <gtest/gtest.h>

namespace brindle {
namespace {

TEST(MembraneStress, OfASphereIsThatOfLaplace) {
  const double p = 16, t = 0.2, r = 3;
  const MembraneStress stress = membrane_stress(p, t, 1 / r, 1 / r, 0.01);
  EXPECT_DOUBLE_EQ(stress.first, p * r / (2 * t));
  EXPECT_DOUBLE_EQ(stress.second, p * r / (2 * t));
}

TEST(MembraneStress, OfATubeIsTwiceAsLargeAroundAsAlong) {
  const double p = 16, t = 0.2, r = 3;
  const MembraneStress stress = membrane_stress(p, t, 1 / r, 0, 0.01);
  EXPECT_DOUBLE_EQ(stress.first, p * r / t);
  EXPECT_DOUBLE_EQ(stress.second, p * r / (2 * t));
}

TEST(MembraneStress, HoldsThePressure) {
  for (const double k1 : {0.1, 0.5, 2.0}) {
    for (const double k2 : {-1.5, -0.1, 0.0, 0.1}) {
      const MembraneStress stress = membrane_stress(16, 0.2, k1, k2, 0.01);
      EXPECT_NEAR(stress.first * k1 + stress.second * k2, 16 / 0.2, 1e-9) << k1 << ' ' << k2;
    }
  }
}

}  // namespace
}  // namespace brindle
