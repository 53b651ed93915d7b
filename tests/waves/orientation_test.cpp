#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;

std::size_t reflecting_edges(const PhaseGraph& graph) {
  return static_cast<std::size_t>(std::ranges::count(graph.reflecting, 1));
}

TEST(Orientation, UndoesRandomSignsOfAFieldThatCanBeOriented) {
  auto surface = wavy_surface("plane,resolution=30", Vec3(1, 0.3f, 0), 10);
  flip_half(surface.waves, 4);
  ASSERT_GT(reflecting_edges(surface.graph()), 0u);
  orient_alike(*surface.neighborhood, surface.waves.directions);
  EXPECT_EQ(reflecting_edges(surface.graph()), 0u);
}

TEST(Orientation, LeavesFewReflectingEdgesElsewhere) {
  auto surface = wavy_surface("sphere,resolution=20", Vec3(0.3f, 1, 0.2f), 10);
  const std::size_t before = reflecting_edges(surface.graph());
  flip_half(surface.waves, 4);
  orient_alike(*surface.neighborhood, surface.waves.directions);
  EXPECT_LE(reflecting_edges(surface.graph()), before + 20);
}

TEST(Orientation, ChangesNothingButSigns) {
  auto surface = wavy_surface("sphere,resolution=8", Vec3(0.3f, 1, 0.2f), 10);
  surface.waves.directions[5].setZero();
  flip_half(surface.waves, 6);
  const std::vector<Vec3> before = surface.waves.directions;
  orient_alike(*surface.neighborhood, surface.waves.directions);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_TRUE(surface.waves.directions[i] == before[i] ||
                surface.waves.directions[i] == -before[i]);
  }
  orient_like(before, surface.waves.directions);
  EXPECT_EQ(surface.waves.directions, before);
}

TEST(Orientation, OthersRunLikeThoseThatAreSettled) {
  auto surface = wavy_surface("plane,resolution=30", Vec3(1, 0.3f, 0), 10);
  const std::vector<Vec3> oriented = surface.waves.directions;
  std::vector<std::uint8_t> settled(oriented.size());
  settled[400] = 1;
  flip_half(surface.waves, 4);
  surface.waves.directions[400] = -oriented[400];
  orient_alike(*surface.neighborhood, settled, surface.waves.directions);
  for (std::size_t i = 0; i < oriented.size(); ++i) {
    EXPECT_EQ(surface.waves.directions[i], -oriented[i]) << i;
  }
  // All that are settled stay, whatever they are.
  flip_half(surface.waves, 5);
  const std::vector<Vec3> flipped = surface.waves.directions;
  const std::vector<std::uint8_t> all(flipped.size(), 1);
  orient_alike(*surface.neighborhood, all, surface.waves.directions);
  EXPECT_EQ(surface.waves.directions, flipped);
}

}  // namespace
}  // namespace brindle
