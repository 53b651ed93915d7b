#include "brindle/spacing_tolerance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/points.h"
#include "brindle/threads.h"
#include "brindle/waves/relaxed_frequency_solver.h"
#include "least_squares_reference.h"
#include "phase_graphs.h"
#include "progress_reports.h"

#ifdef BRINDLE_HAS_TBB
#include <tbb/task_arena.h>
#endif

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::kAxis;
using testing_support::least_squares;
using testing_support::LeastFrequencies;
using testing_support::Reports;
using testing_support::wavy_surface;
using testing_support::WavySurface;

Surface surface_of(const WavySurface& s) { return {s.mesh, s.neighborhood, s.normals}; }

FrequencyField yielded(const WavySurface& s, const Slack& slack) {
  const WaveSet waves{s.mesh.positions, s.waves.directions, s.waves.frequencies};
  return relaxed_frequencies(surface_of(s), waves, slack).frequencies;
}

Eigen::VectorXd relative(std::span<const float> g, const FrequencyField& f) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(f.size()));
  for (std::size_t i = 0; i < f.size(); ++i) {
    x[static_cast<Eigen::Index>(i)] = static_cast<double>(g[i]) / static_cast<double>(f[i]);
  }
  return x;
}

void expect_least(const WavySurface& s, const Slack& slack, std::span<const float> g) {
  testing_support::expect_least(LeastFrequencies(s.mesh, s.waves, slack),
                                relative(g, s.waves.frequencies));
}

TEST(RelaxedFrequencies, EnergyIsThatOfTheActiveSet) {
  for (const char* shape : {"torus,resolution=30", "trefoil,resolution=24", "box,resolution=8",
                            "mobius,resolution=16", "plane,resolution=30"}) {
    for (const float slack : {0.05f, 0.25f, 1.0f}) {
      SCOPED_TRACE(std::string(shape) + " " + std::to_string(slack));
      const auto s = wavy_surface(shape, kAxis, 20);
      expect_least(s, slack, yielded(s, slack));
    }
  }
}

/// Three sheets that meet along an edge, another far away, and a vertex of no triangle.
WavySurface odd_surface() {
  const Mesh plane = make_shape("plane,resolution=16");
  const auto columns = static_cast<Index>(plane.vertex_count());
  Mesh mesh;
  std::vector<Index> number(3 * columns);
  for (Index sheet = 0; sheet < 3; ++sheet) {
    const float angle = 2.1f * static_cast<float>(sheet);
    for (Index v = 0; v < columns; ++v) {
      const Vec3& p = plane.positions[v];
      const float x = p.x() - plane.positions[0].x();
      if (sheet > 0 && std::abs(x) < 1e-6f) {
        number[sheet * columns + v] = number[v];  // the common edge
        continue;
      }
      number[sheet * columns + v] = static_cast<Index>(mesh.positions.size());
      mesh.positions.emplace_back(x * std::cos(angle), x * std::sin(angle), p.y());
    }
    for (const Triangle& t : plane.triangles) {
      mesh.triangles.push_back({number[sheet * columns + t[0]], number[sheet * columns + t[1]],
                                number[sheet * columns + t[2]]});
    }
  }
  const auto first = static_cast<Index>(mesh.positions.size());
  for (const Vec3& p : plane.positions) mesh.positions.push_back(p + Vec3(30, 2, 1));
  for (const Triangle& t : plane.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  mesh.positions.emplace_back(5, 5, 5);
  WavySurface s = wavy_surface(std::move(mesh), kAxis, 30);
  for (std::size_t i = 0; i < s.waves.directions.size(); ++i) {
    const float angle = 2 * s.mesh.positions[i].z();
    if (s.normals[i].isZero(0)) continue;
    s.waves.directions[i] =
        tangent_direction(Vec3(std::cos(angle), 0.4f, std::sin(2 * angle)), s.normals[i]);
  }
  s.waves.directions[7].setZero();
  return s;
}

TEST(RelaxedFrequencies, TakesAnyTopology) {
  const WavySurface s = odd_surface();
  const FrequencyField g = yielded(s, 0.25f);
  expect_least(s, 0.25f, g);
  EXPECT_EQ(g.back(), s.waves.frequencies.back());
  EXPECT_EQ(g[7], s.waves.frequencies[7]);
}

TEST(RelaxedFrequencies, FollowsFrequenciesThatVary) {
  auto s = wavy_surface("torus,resolution=30", kAxis, 20);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> factor(0.7f, 1.5f);
  for (float& f : s.waves.frequencies) f *= factor(random);
  expect_least(s, 0.25f, yielded(s, 0.25f));
}

TEST(RelaxedFrequencies, StaysWhereThereIsNoCurl) {
  const auto s = wavy_surface("plane,resolution=40", kAxis, 20);
  const Eigen::VectorXd x = relative(yielded(s, 0.5f), s.waves.frequencies);
  // Floats leave a curl of their rounding, which a smooth change answers with as much more as the
  // Laplacian's condition says: the square of the resolution.
  const double rounding = 40.0 * 40.0 * std::numeric_limits<float>::epsilon() / 2;
  EXPECT_NEAR(x.maxCoeff(), 1, rounding);
  EXPECT_NEAR(x.minCoeff(), 1, rounding);
}

/// Waves around a point beside a plane: without curl where the frequency falls with the distance.
WavySurface fan(float distance) {
  auto s = wavy_surface("plane,resolution=40", kAxis, 20);
  const Vec3 centre(-distance, 0, 0);
  for (std::size_t i = 0; i < s.waves.directions.size(); ++i) {
    s.waves.directions[i] =
        tangent_direction(s.normals[i].cross(s.mesh.positions[i] - centre), s.normals[i]);
  }
  return s;
}

/// How far g times the distance from the centre varies, over its mean.
double spread(const WavySurface& s, float distance, std::span<const float> g) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double product =
        static_cast<double>(g[i] * (s.mesh.positions[i] - Vec3(-distance, 0, 0)).norm());
    sum += product;
    squares += product * product;
  }
  const double count = static_cast<double>(g.size()), mean = sum / count;
  return std::sqrt(squares / count - mean * mean) / mean;
}

TEST(RelaxedFrequencies, FallsWithTheDistanceFromACommonCentre) {
  const float distance = 8;
  const auto s = fan(distance);
  const double before = spread(s, distance, s.waves.frequencies);
  EXPECT_GT(before, 0.03);
  EXPECT_LT(spread(s, distance, yielded(s, 0.5f)), 0.5 * before);
}

#ifdef BRINDLE_HAS_NANOFLANN
TEST(RelaxedFrequencies, PointsAreJoinedToTheirNeighbours) {
  const float distance = 8;
  auto s = fan(distance);
  PointCloud cloud = make_point_cloud(s.mesh.positions, s.normals).cloud;
  const Surface points = make_point_surface(std::move(cloud));
  RelaxedFrequencySolver relaxed(relaxed_setting(points, 0.5f));
  const auto g = relaxed.solve({points.mesh.positions, s.waves.directions, s.waves.frequencies});
  EXPECT_LT(spread(s, distance, g), 0.5 * spread(s, distance, s.waves.frequencies));
  EXPECT_EQ(relaxed.change().share_at_bounds, 0);
}
#endif

TEST(RelaxedFrequencies, TurningDirectionsRoundChangesNothing) {
  auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  const FrequencyField before = yielded(s, 0.2f);
  flip_half(s.waves, 5);
  EXPECT_EQ(yielded(s, 0.2f), before);
}

double mean_difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).cwiseAbs().mean();
}

TEST(RelaxedFrequencies, MovingTurningAndScalingChangeLittle) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  const auto x = relative(yielded(s, 0.2f), s.waves.frequencies);
  const Eigen::Matrix3f turn = (Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized())).matrix();
  for (const float scale : {1e-12f, 1.0f, 1e12f}) {
    auto moved = s;
    for (Vec3& p : moved.mesh.positions) p = scale * (turn * p + Vec3(1, -2, 3));
    for (Vec3& n : moved.normals) n = turn * n;
    for (Vec3& d : moved.waves.directions) d = turn * d;
    for (float& f : moved.waves.frequencies) f /= scale;
    const auto y = relative(yielded(moved, 0.2f), moved.waves.frequencies);
    EXPECT_LT(mean_difference(x, y), 1e-3) << scale;
  }
}

TEST(RelaxedFrequencies, OrderOfVerticesChangesLittle) {
  const auto s = wavy_surface("torus,resolution=60", kAxis, 20);
  std::vector<Index> place(s.mesh.vertex_count());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), std::mt19937(2));
  Mesh mesh = s.mesh;
  for (std::size_t i = 0; i < place.size(); ++i) mesh.positions[place[i]] = s.mesh.positions[i];
  for (Triangle& t : mesh.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  const auto shuffled = wavy_surface(std::move(mesh), kAxis, 20);
  const FrequencyField g = yielded(s, 0.2f), h = yielded(shuffled, 0.2f);
  FrequencyField back(g.size());
  for (std::size_t i = 0; i < place.size(); ++i) back[i] = h[place[i]];
  EXPECT_LT(mean_difference(relative(g, s.waves.frequencies), relative(back, s.waves.frequencies)),
            5e-3);
  expect_least(s, 0.2f, back);
}

#ifdef BRINDLE_HAS_TBB
TEST(RelaxedFrequencies, IsTheSameForEveryNumberOfThreads) {
  const auto s = wavy_surface("torus,resolution=200", kAxis, 40);
  const auto run = [&](int threads) {
    FrequencyField g;
    const ThreadLimit limit(threads);
    tbb::task_arena(threads).execute([&] { g = yielded(s, 0.2f); });
    return g;
  };
  const FrequencyField alone = run(1);
  EXPECT_EQ(run(2), alone);
  EXPECT_EQ(run(8), alone);
}
#endif  // BRINDLE_HAS_TBB

TEST(RelaxedFrequencies, KeepsOnlyWhatWasFound) {
  auto s = wavy_surface("torus,resolution=40", kAxis, 20);
  RelaxedFrequencySolver once(relaxed_setting(surface_of(s), 0.2f)), again = once.sibling();
  again.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});  // nothing
  const auto next = [&](RelaxedFrequencySolver& relaxed) {
    relaxed.solve({s.mesh.positions, s.waves.directions, s.waves.frequencies});
    relaxed.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});
    return FrequencyField(relaxed.frequencies().begin(), relaxed.frequencies().end());
  };
  const FrequencyField first = next(once);
  EXPECT_EQ(next(again), first);
  again.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});
  EXPECT_TRUE(std::ranges::equal(again.frequencies(), first));
  s.waves.directions = rotated(s.waves.directions, s.normals, 0.1f);
  const Progress stop([](const ProgressReport&) { return false; });
  again.restart();
  EXPECT_THROW(again.solve({s.mesh.positions, s.waves.directions, s.waves.frequencies}, stop),
               Cancelled);
  again.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});
  EXPECT_TRUE(std::ranges::equal(again.frequencies(), first));
  once.restart();
  EXPECT_EQ(next(again), next(once));
}

TEST(RelaxedFrequencies, FramesKeepUpWithFieldsThatTurn) {
  auto s = wavy_surface("torus,resolution=40", kAxis, 20);
  RelaxedFrequencySolver relaxed(relaxed_setting(surface_of(s), 0.2f));
  for (int n = 0; n < 12; ++n) {
    s.waves.directions = rotated(s.waves.directions, s.normals, 0.02f);
    const auto g = relaxed.solve({s.mesh.positions, s.waves.directions, s.waves.frequencies});
    relaxed.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});
    EXPECT_LE(relaxed.change().sweeps, n == 0 ? 80 : 6);
    expect_least(s, 0.2f, g);
    EXPECT_TRUE(std::ranges::equal(g, relaxed.frequencies()));
  }
}

TEST(RelaxedFrequencies, WhatIsNotKeptLeavesNoTrace) {
  auto s = wavy_surface("torus,resolution=40", kAxis, 20);
  const DirectionField other = rotated(s.waves.directions, s.normals, 0.3f);
  const auto see = [&](bool disturbed) {
    RelaxedFrequencySolver relaxed(relaxed_setting(surface_of(s), 0.2f));
    FrequencyField seen;
    for (int n = 0; n < 3; ++n) {
      if (disturbed) relaxed.solve({s.mesh.positions, other, s.waves.frequencies});
      Reports cancelled(3);
      if (disturbed && n == 0) {
        EXPECT_THROW(
            relaxed.solve({s.mesh.positions, other, s.waves.frequencies}, cancelled.progress()),
            Cancelled);
      }
      relaxed.solve({s.mesh.positions, s.waves.directions, s.waves.frequencies});
      relaxed.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});
      const auto g = relaxed.frequencies();
      seen.insert(seen.end(), g.begin(), g.end());
    }
    return seen;
  };
  EXPECT_EQ(see(true), see(false));
}

TEST(RelaxedFrequencies, SlackOfEachVertexIsKept) {
  const auto s = wavy_surface("torus,resolution=40", kAxis, 20);
  Slack slack;
  for (const Vec3& p : s.mesh.positions) slack.by_vertex.push_back(p.x() > 0 ? 0.3f : 0.0f);
  const auto x = relative(yielded(s, slack), s.waves.frequencies);
  for (std::size_t i = 0; i < slack.by_vertex.size(); ++i) {
    const double most = 1 + static_cast<double>(slack.by_vertex[i]);
    EXPECT_LE(x[static_cast<Eigen::Index>(i)], most * (1 + 1e-6));
    EXPECT_GE(x[static_cast<Eigen::Index>(i)], (1 - 1e-6) / most);
  }
  EXPECT_GT(x.maxCoeff(), 1.15);
}

/// The mean of ratios over vertices that `part` has.
double mean_ratio(const WavySurface& s, std::span<const float> g, const std::vector<float>& part) {
  const Eigen::VectorXd mass = least_squares(s.mesh, s.waves).mass;
  const Eigen::VectorXd x = relative(g, s.waves.frequencies);
  double sum = 0, area = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double weight = mass[static_cast<Eigen::Index>(i)] * static_cast<double>(part[i]);
    sum += weight * x[static_cast<Eigen::Index>(i)];
    area += weight;
  }
  return sum / area;
}

std::vector<float> left_half(const Mesh& mesh) {
  std::vector<float> branch_penalty;
  for (const Vec3& p : mesh.positions) branch_penalty.push_back(p.x() < 0 ? 1.0f : 0.0f);
  return branch_penalty;
}

TEST(RelaxedFrequencies, MeanStaysWhatWasAskedFor) {
  for (const char* shape : {"torus,resolution=60", "trefoil,resolution=60", "box,resolution=20"}) {
    auto s = wavy_surface(shape, kAxis, 40);
    const std::vector<float> all(s.mesh.vertex_count(), 1), branch_penalty = left_half(s.mesh);
    for (const float slack : {0.1f, 0.25f, 0.5f, 3.0f}) {
      SCOPED_TRACE(std::string(shape) + " " + std::to_string(slack));
      EXPECT_NEAR(mean_ratio(s, yielded(s, slack), all), 1, 1e-4);
      Slack with_penalty = slack;
      with_penalty.branch_penalty = branch_penalty;
      RelaxedFrequencySolver relaxed(relaxed_setting(surface_of(s), with_penalty));
      for (int n = 0; n < 4; ++n) {
        const auto g = relaxed.solve({s.mesh.positions, s.waves.directions, s.waves.frequencies});
        relaxed.keep({s.mesh.positions, s.waves.directions, s.waves.frequencies});
        EXPECT_NEAR(mean_ratio(s, g, all), 1, 1e-4);
        EXPECT_NEAR(mean_ratio(s, g, branch_penalty), 1, 0.03);
        s.waves.directions = rotated(s.waves.directions, s.normals, 0.02f);
      }
    }
  }
}

TEST(RelaxedFrequencies, ChangeSaysWhatHasBecomeOfIt) {
  const auto s = wavy_surface("torus,resolution=40", kAxis, 20);
  RelaxedFrequencySolver relaxed(relaxed_setting(surface_of(s), 0.1f));
  const auto g = relaxed.solve({s.mesh.positions, s.waves.directions, s.waves.frequencies});
  const auto x = relative(g, s.waves.frequencies);
  const FrequencyChange& change = relaxed.change();
  EXPECT_NEAR(change.ratio_min, x.minCoeff(), 1e-6);
  EXPECT_NEAR(change.ratio_max, x.maxCoeff(), 1e-6);
  const Eigen::VectorXd mass = least_squares(s.mesh, s.waves).mass;
  EXPECT_NEAR(change.ratio_mean, mass.dot(x) / mass.sum(), 1e-6);
  EXPECT_GT(change.share_at_bounds, 0.01);
  EXPECT_LT(change.share_at_bounds, 1);
  EXPECT_GT(change.sweeps, 2);
  EXPECT_LT(change.residual, 0.05);
}

TEST(RelaxedFrequencies, NothingAtAllIsFine) {
  RelaxedFrequencySolver relaxed(relaxed_setting(make_surface({}), 0.1f));
  EXPECT_TRUE(relaxed.solve({}).empty());
}

TEST(RelaxedFrequencies, RefusesWhatIsNoSlack) {
  const auto s = wavy_surface("torus,resolution=10", kAxis, 5);
  const std::size_t count = s.mesh.vertex_count();
  const auto refuse = [&](const Slack& slack, const std::string& what) {
    try {
      relaxed_frequencies(surface_of(s), s.waves, slack);
      FAIL() << what;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {-0.1f, nan, infinity}) refuse(bad, "finite number of 0");
  Slack slack;
  slack.by_vertex.assign(count, 0.1f);
  for (const float bad : {-0.1f, nan, infinity}) {
    slack.by_vertex[3] = bad;
    refuse(slack, "vertex 3");
  }
  slack.by_vertex.resize(2);
  refuse(slack, "one to each");
  slack = 0.1f;
  slack.branch_penalty.assign(count, 0.5f);
  for (const float bad : {-0.1f, 1.1f, nan}) {
    slack.branch_penalty[5] = bad;
    refuse(slack, "avoid_branches of vertex 5");
  }
}

}  // namespace
}  // namespace brindle
