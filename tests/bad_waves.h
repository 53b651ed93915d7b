/// Waves with one value that no wave can have, for the tests of several rooms.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/phase_graph.h"
#include "test_numbers.h"

namespace brindle::testing_support {

/// Calls `take` with every kind of bad value at the vertex and expects an Error that names it.
inline void expect_refused(const WaveSet& waves, std::size_t vertex,
                           const std::function<void(const WaveSet&)>& take) {
  std::vector<WaveSet> all;
  for (const float frequency : {kNaN, kInfinity, 0.0f, -1.0f}) {
    all.push_back(waves);
    all.back().frequencies[vertex] = frequency;
  }
  for (const float x : {kNaN, kInfinity, -kInfinity}) {
    all.push_back(waves);
    all.back().positions[vertex].y() = x;
    all.push_back(waves);
    all.back().directions[vertex].z() = x;
  }
  for (const float length : {0.5f, 0.9f, 1.1f, 1e-20f}) {
    all.push_back(waves);
    all.back().directions[vertex] *= length;
  }
  // Also where there is no wave.
  all.push_back(waves);
  all.back().directions[vertex].setZero();
  all.back().frequencies[vertex] = 0;
  for (std::size_t n = 0; n < all.size(); ++n) {
    // A later vertex is not the first.
    all[n].frequencies[vertex + 1] = kNaN;
    try {
      take(all[n]);
      ADD_FAILURE() << "bad waves " << n << " were taken";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("vertex " + std::to_string(vertex) + " "),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace brindle::testing_support
