#include "brindle/waves/direction_graph.h"

#include <memory>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;

TEST(TangentBasis, IsOrthonormalAndRightHandedForEveryNormal) {
  std::mt19937 random(1);
  std::normal_distribution<float> component;
  for (int n = 0; n < 1000; ++n) {
    const Vec3 normal = Vec3(component(random), component(random), component(random)).normalized();
    const TangentBasis basis = tangent_basis(normal);
    EXPECT_NEAR(basis.x.norm(), 1, 1e-5);
    EXPECT_NEAR(basis.x.dot(basis.y), 0, 1e-5);
    EXPECT_LT((basis.x.cross(basis.y) - normal).norm(), 1e-5);
  }
  EXPECT_LT(
      (tangent_basis(Vec3(0, 0, -1)).x.cross(tangent_basis(Vec3(0, 0, -1)).y) - Vec3(0, 0, -1))
          .norm(),
      1e-6);
}

TEST(DirectionGraph, RefusesNormalsThatAreNone) {
  auto surface = testing_support::wavy_surface("sphere,resolution=6", Vec3(0, 1, 0.2f), 3);
  EXPECT_THROW(build_direction_graph(surface.neighborhood, std::span(surface.normals).first(5), 2),
               Error);
  surface.normals[3].x() = std::nanf("");
  EXPECT_THROW(build_direction_graph(surface.neighborhood, surface.normals, 2), Error);
}

TEST(DirectionGraph, DirectionsSurviveTheirRepresentation) {
  const auto surface = wavy_surface("sphere,resolution=8", Vec3(0, 1, 0), 5);
  for (const int symmetry : {1, 2, 4}) {
    std::vector<Complex> u;
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
      u.push_back(representation(surface.waves.directions[i], surface.normals[i], symmetry));
    }
    const auto directions = directions_of(u, surface.normals, symmetry);
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (surface.waves.directions[i].isZero(0)) continue;
      EXPECT_LT(std::abs(representation(directions[i], surface.normals[i], symmetry) - u[i]), 1e-4);
      EXPECT_NEAR(directions[i].dot(surface.normals[i]), 0, 1e-5);
    }
  }
}

TEST(DirectionGraph, AParallelFieldOnACylinderHasNoEnergy) {
  const auto surface = wavy_surface("cylinder,resolution=48", Vec3(0, 0, 1), 5);
  const PhaseGraph graph = build_direction_graph(surface.neighborhood, surface.normals, 2);
  std::vector<Complex> u;
  for (std::size_t i = 0; i < surface.normals.size(); ++i) {
    u.push_back(representation(surface.waves.directions[i], surface.normals[i], 2));
  }
  EXPECT_LT(energy(graph, u), 1e-7);
}

TEST(DirectionGraph, IsSymmetricAlsoAcrossNormalsOnOppositeSides) {
  auto surface = wavy_surface("sphere,resolution=6", Vec3(0, 1, 0), 5);
  for (std::size_t i = 0; i < surface.normals.size(); i += 3) {
    surface.normals[i] = -surface.normals[i];
  }
  const PhaseGraph graph = build_direction_graph(surface.neighborhood, surface.normals, 2);
  const Adjacency& adjacency = *graph.adjacency;
  std::size_t reflecting = 0;
  for (Index i = 0; i < graph.node_count(); ++i) {
    for (Index edge = adjacency.offsets[i]; edge < adjacency.offsets[i + 1]; ++edge) {
      const auto row = adjacency.of(adjacency.neighbors[edge]);
      const Index back = adjacency.offsets[adjacency.neighbors[edge]] +
                         static_cast<Index>(std::ranges::lower_bound(row, i) - row.begin());
      const Complex expected =
          graph.reflecting[edge] ? graph.coupling[edge] : std::conj(graph.coupling[edge]);
      EXPECT_LT(std::abs(graph.coupling[back] - expected), 1e-4f);
      reflecting += graph.reflecting[edge];
    }
  }
  EXPECT_GT(reflecting, 0u);
}

TEST(DirectionGraph, TakesABendBeyondARightAngleForABend) {
  // Two neighbours on either side of a fold along x.
  const auto adjacency = std::make_shared<const Adjacency>(Adjacency{{0, 1, 2}, {1, 0}});
  for (const float degrees : {60.0f, 89.0f, 91.0f, 110.0f, 120.0f, 150.0f}) {
    const Eigen::AngleAxisf fold(degrees * 3.14159265f / 180, Vec3::UnitX());
    const std::vector<Vec3> normals = {Vec3::UnitZ(), fold * Vec3::UnitZ()};
    const bool bends = degrees < 114;
    const PhaseGraph graph = build_direction_graph(adjacency, normals, 1);
    const PhaseGraph weighted =
        build_weighted_direction_graph(adjacency, normals, 1, std::vector<float>(2, 1.0f));
    EXPECT_EQ(graph.reflecting[0], bends ? 0 : 1) << degrees;
    EXPECT_EQ(weighted.reflecting, graph.reflecting) << degrees;
    // A direction askew runs on round the fold, or, on the other side, is seen in a mirror.
    const Vec3 direction = Vec3(0.6f, 0.8f, 0);
    const Vec3 across = fold * Vec3::UnitY();
    const Vec3 onwards = 0.6f * Vec3::UnitX() + (bends ? 0.8f : -0.8f) * across;
    const std::vector<Complex> u = {representation(direction, normals[0], 1),
                                    representation(onwards, normals[1], 1)};
    EXPECT_LT(energy(graph, u), 1e-10) << degrees;
  }
}

TEST(DirectionGraph, TurningNormalsRoundLeavesTheEnergyOfAField) {
  auto surface = wavy_surface("sphere,resolution=6", Vec3(0.2f, 1, 0), 5);
  const auto field_energy = [&] {
    std::vector<Complex> u;
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
      u.push_back(representation(surface.waves.directions[i], surface.normals[i], 2));
    }
    return energy(build_direction_graph(surface.neighborhood, surface.normals, 2), u);
  };
  const double before = field_energy();
  for (std::size_t i = 0; i < surface.normals.size(); i += 2) {
    surface.normals[i] = -surface.normals[i];
  }
  EXPECT_NEAR(field_energy(), before, 1e-5);
}

}  // namespace
}  // namespace brindle
