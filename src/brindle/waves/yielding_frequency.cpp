#include "brindle/yielding_frequency.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/waves/neighbor_triangles.h"
#include "brindle/waves/slack_check.h"
#include "brindle/waves/yielding_solver.h"

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

}  // namespace

void check_slack(const Slack& slack, std::size_t vertices) {
  constexpr float kMost = std::numeric_limits<float>::max();
  const char* const remedy = "give a finite number of 0 or above";
  if (!(slack.everywhere >= 0 && slack.everywhere <= kMost)) {
    refuse_slack("it is " + std::to_string(slack.everywhere), remedy);
  }
  check_list(slack.by_vertex, vertices, "slacks");
  check_list(slack.calm, vertices, "numbers for calm");
  check_numbers(slack.by_vertex, kMost, "that", remedy);
  check_numbers(slack.calm, 1, "calm", "give a number from 0 to 1");
}

std::shared_ptr<const YieldingSetting> yielding_setting(const Surface& surface, const Slack& slack,
                                                        const Progress& progress) {
  const Mesh& mesh = surface.mesh;
  check_slack(slack, mesh.vertex_count());
  auto setting = std::make_shared<YieldingSetting>();
  setting->slack = slack_by_vertex(slack, mesh.vertex_count());
  FrequencyTriangles& triangles = setting->triangles;
  if (mesh.triangles.empty()) {
    Mesh joined;
    joined.positions = mesh.positions;
    joined.triangles = neighbor_triangles(mesh.positions, surface.normals, *surface.neighborhood,
                                          progress.part(0, 0.6));
    setting->adjacency =
        std::make_shared<const Adjacency>(vertex_neighborhood(joined, progress.part(0.6, 0.9)));
    triangles.corners = std::move(joined.triangles);
  } else {
    setting->adjacency = surface.neighborhood;
    triangles.corners = mesh.triangles;
  }
  progress.report(0.9);
  setting->calm = slack.calm;
  triangles.weights = calm_weights(triangles.corners, slack.calm);
  return setting;
}

struct YieldingFrequency::State {
  YieldingSolver solver;
};

YieldingFrequency::YieldingFrequency(const Surface& surface, const Slack& slack,
                                     const Progress& progress)
    : state_(std::make_unique<State>(
          State{YieldingSolver(yielding_setting(surface, slack, progress.step("frequency")))})) {}

YieldingFrequency::YieldingFrequency(std::unique_ptr<State> state) : state_(std::move(state)) {}

YieldingFrequency YieldingFrequency::sibling() const {
  return YieldingFrequency(std::make_unique<State>(State{state_->solver.sibling()}));
}

YieldingFrequency::~YieldingFrequency() = default;
YieldingFrequency::YieldingFrequency(YieldingFrequency&&) noexcept = default;
YieldingFrequency& YieldingFrequency::operator=(YieldingFrequency&&) noexcept = default;

std::span<const float> YieldingFrequency::solve(std::span<const Vec3> positions,
                                                std::span<const Vec3> directions,
                                                std::span<const float> wanted,
                                                const Progress& progress) {
  return state_->solver.solve({positions, directions, wanted}, progress);
}

void YieldingFrequency::keep() { state_->solver.keep(); }

std::span<const float> YieldingFrequency::frequencies() const {
  return state_->solver.frequencies();
}

void YieldingFrequency::restart() { state_->solver.restart(); }

const FrequencyChange& YieldingFrequency::change() const { return state_->solver.change(); }

}  // namespace brindle
