/// A phase graph with every kind of coupling, for the tests of solvers.
#pragma once

#include <random>

#include "phase_graphs.h"

namespace brindle::testing_support {

/// A torus whose directions run either way: a graph with direct and reflecting edges, and a random
/// anchor per node if asked for.
inline PhaseGraph reflecting_graph(bool anchored) {
  auto surface = wavy_surface("torus,resolution=40", Vec3(0.3f, 0.9f, 0.2f), 12);
  flip_half(surface.waves, 5);
  PhaseGraph graph = surface.graph();
  std::mt19937 random(3);
  std::normal_distribution<float> component;
  for (std::size_t i = 0; anchored && i < graph.node_count(); ++i) {
    graph.anchor.emplace_back(component(random), component(random));
  }
  return graph;
}

}  // namespace brindle::testing_support
