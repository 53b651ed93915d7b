#include "brindle/spacing_tolerance.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/waves/relaxed_frequency_solver.h"
#include "brindle/waves/wave_check.h"

namespace brindle {
namespace {

[[noreturn]] void refuse_slack(const std::string& what, const std::string& remedy) {
  throw Error("slack: " + what + "; " + remedy);
}

void check_list(const std::vector<float>& list, std::size_t vertices, const char* what) {
  if (list.empty() || list.size() == vertices) return;
  refuse_slack("there are " + std::to_string(list.size()) + " " + what + " for " +
                   std::to_string(vertices) + " vertices",
               "give one to each, or none");
}

void check_numbers(const std::vector<float>& list, float most, const char* what,
                   const char* remedy) {
  const auto bad =
      std::find_if_not(list.begin(), list.end(), [most](float s) { return s >= 0 && s <= most; });
  if (bad == list.end()) return;
  refuse_slack(std::string(what) + " of vertex " + std::to_string(bad - list.begin()) + " is " +
                   std::to_string(*bad),
               remedy);
}

// ---- Triangles of points -----------------------------------------------------------------------

constexpr float kLargestAngle = 2 * std::numbers::pi_v<float> / 3;
constexpr float kSmallestAngle = 0.02f;

/// The neighbours of `i` sorted by their angle about its normal, counter-clockwise.
std::vector<std::pair<float, Index>> around(std::span<const Vec3> positions, const Vec3& normal,
                                            const Adjacency& neighborhood, Index i) {
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<std::pair<float, Index>> result;
  for (const Index j : neighborhood.of(i)) {
    const Vec3 edge = positions[j] - positions[i];
    result.emplace_back(elementary::atan2(edge.dot(y), edge.dot(x)), j);
  }
  ranges::sort(result.begin(), result.end());
  return result;
}

/// The corners in ascending order, the same from each of them.
Triangle from_smallest(Index a, Index b, Index c) {
  Triangle triangle = {a, b, c};
  ranges::sort(triangle.begin(), triangle.end());
  return triangle;
}

/// The triangles of every point with a normal and two consecutive neighbours, seen along the
/// normal, at an angle below 120 degrees. Each is listed once. They overlap, and edges between
/// neighbours need not be edges of the neighbourhood.
std::vector<Triangle> neighbor_triangles(std::span<const Vec3> positions,
                                         std::span<const Vec3> normals,
                                         const Adjacency& neighborhood, const Progress& progress) {
  std::vector<Triangle> triangles;
  for (Index i = 0; i < neighborhood.node_count(); ++i) {
    if (i % kReportSlice == 0) progress.tick();
    if (normals[i].isZero(0)) continue;
    const auto ring = around(positions, normals[i], neighborhood, i);
    for (std::size_t k = 0; k < ring.size() && ring.size() > 1; ++k) {
      const bool last = k + 1 == ring.size();
      const auto& [next_angle, next] = ring[last ? 0 : k + 1];
      const float angle =
          next_angle - ring[k].first + (last ? 2 * std::numbers::pi_v<float> : 0.0f);
      if (angle < kSmallestAngle || angle > kLargestAngle) continue;
      triangles.push_back(from_smallest(i, ring[k].second, next));
    }
  }
  ticking_sort(triangles.begin(), triangles.end(), progress, std::less<>());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

}  // namespace

void check_slack(const Slack& slack, std::size_t vertices) {
  constexpr float kMost = std::numeric_limits<float>::max();
  const char* const remedy = "give a finite number of 0 or above";
  if (!(slack.everywhere >= 0 && slack.everywhere <= kMost)) {
    refuse_slack("it is " + std::to_string(slack.everywhere), remedy);
  }
  check_list(slack.by_vertex, vertices, "slacks");
  check_list(slack.branch_penalty, vertices, "numbers for branch_penalty");
  check_numbers(slack.by_vertex, kMost, "that", remedy);
  check_numbers(slack.branch_penalty, 1, "avoid_branches", "give a number from 0 to 1");
}

std::shared_ptr<const RelaxedFrequencySetting> relaxed_setting(const Surface& surface,
                                                               const Slack& slack,
                                                               const Progress& progress) {
  const Mesh& mesh = surface.mesh;
  check_slack(slack, mesh.vertex_count());
  auto setting = std::make_shared<RelaxedFrequencySetting>();
  setting->slack = slack_by_vertex(slack, mesh.vertex_count());
  FrequencyTriangles& triangles = setting->triangles;
  if (mesh.triangles.empty()) {
    Mesh joined;
    joined.positions = mesh.positions;
    joined.triangles =
        neighbor_triangles(mesh.positions, surface.normals, *surface.neighborhood, progress);
    setting->adjacency = std::make_shared<const Adjacency>(vertex_neighborhood(joined));
    triangles.corners = std::move(joined.triangles);
  } else {
    setting->adjacency = surface.neighborhood;
    triangles.corners = mesh.triangles;
  }
  progress.tick();
  setting->branch_penalty = slack.branch_penalty;
  triangles.weights = penalty_weights(triangles.corners, slack.branch_penalty);
  return setting;
}

RelaxedFrequencies relaxed_frequencies(const Surface& surface, const WaveSet& waves,
                                       const Slack& slack, const Progress& progress) {
  JobStages stages(progress, {{"frequency", 1}});
  const Progress relaxing = stages.begin("frequency");
  // Point clouds have to be triangulated first.
  const double begins = surface.mesh.triangles.empty() ? 0.3 : 0.02;
  RelaxedFrequencySolver solver(relaxed_setting(surface, slack, relaxing.part(0, begins)));
  const std::span<const float> frequencies = solver.solve(
      {waves.positions, waves.directions, waves.frequencies}, relaxing.part(begins, 1));
  stages.finish();
  return {{frequencies.begin(), frequencies.end()}, solver.change()};
}

}  // namespace brindle
