#include "brindle/recipe/fabrication_report.h"

#include <algorithm>
#include <cstdlib>

#include "brindle/base/text.h"

namespace brindle {
namespace {

std::string text_of(const Winding& winding) { return winding ? std::to_string(*winding) : "none"; }

std::string names_of(const FabricationMetrics& metrics,
                     const std::vector<std::size_t>& boundaries) {
  std::string names;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const char* const before = k == 0 ? "" : k + 1 < boundaries.size() ? ", " : " and ";
    names += before + metrics.loops[boundaries[k]].name;
  }
  return names;
}

// Lines on components whose winding numbers at boundaries do not add up, with the reason.
std::string differences(const FabricationMetrics& metrics) {
  std::string text;
  for (const WindingSum& sum : metrics.sums) {
    const std::size_t first = sum.boundaries[0], second = sum.boundaries[1];
    const bool pair = sum.boundaries.size() == 2;
    if (pair ? metrics.windings[first] == metrics.windings[second] : sum.periods == 0) continue;
    const std::string names = names_of(metrics, sum.boundaries);
    const std::string how =
        pair ? " differ" : formatted(" do not add up, by %d", std::abs(sum.periods));
    text += "   " + names + how +
            formatted(": of %zu branches and singularities, some lie between\n",
                      metrics.branches[first]);
  }
  return text;
}

}  // namespace

void add_to_json(const FabricationMetrics& metrics, nlohmann::ordered_json& json) {
  auto loops = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < metrics.loops.size(); ++i) {
    const auto number = [](const Winding& winding) {
      return winding ? nlohmann::ordered_json(*winding) : nlohmann::ordered_json(nullptr);
    };
    const Eigen::Vector3d& center = metrics.centers[i];
    nlohmann::ordered_json loop = {{"name", metrics.loops[i].name},
                                   {"length", metrics.loops[i].length},
                                   {"center", {center.x(), center.y(), center.z()}},
                                   {"winding", number(metrics.windings[i])},
                                   {"branches_of_component", metrics.branches[i]}};
    if (!metrics.windings_before.empty()) {
      loop["winding_before"] = number(metrics.windings_before[i]);
    }
    loops.push_back(std::move(loop));
  }
  if (!loops.empty()) json["loops"] = std::move(loops);
  if (!metrics.windings_before.empty()) {
    json["turned"] = {{"energy_before", metrics.energy_before},
                      {"largest_deg", metrics.largest_turn_deg},
                      {"mean_deg", metrics.mean_turn_deg},
                      {"largest_frequency_change", metrics.largest_frequency_change}};
  }
  if (metrics.cancelled_branches) {
    const CancelledBranches& cancelled = *metrics.cancelled_branches;
    json["cancelled_branches"] = {{"pairs", cancelled.pairs},
                                  {"branches_before", cancelled.branches_before},
                                  {"energy_before", cancelled.energy_before}};
  }
  if (metrics.fixed_vertices > 0) json["boundary_vertices_fixed"] = metrics.fixed_vertices;
}

std::string lines_of(const FabricationMetrics& metrics) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostWindings, metrics.loops.size()); ++i) {
    const std::string before =
        metrics.windings_before.empty() ? "" : ", before " + text_of(metrics.windings_before[i]);
    text += formatted("%s%s %s%s", i == 0 ? "   windings: " : "; ", metrics.loops[i].name.c_str(),
                      text_of(metrics.windings[i]).c_str(), before.c_str());
  }
  if (metrics.loops.size() > kMostWindings) {
    text += formatted("; and %zu more in the report", metrics.loops.size() - kMostWindings);
  }
  if (!text.empty()) text += '\n';
  return text + remarks_of(metrics);
}

std::string remarks_of(const FabricationMetrics& metrics) {
  std::string text = differences(metrics);
  if (!metrics.windings_before.empty()) {
    text += formatted(
        "   the field is turned by up to %.2f degrees, %.2f on average, frequencies by up to %.1f "
        "%%; energy %.6f before\n",
        metrics.largest_turn_deg, metrics.mean_turn_deg, 100 * metrics.largest_frequency_change,
        metrics.energy_before);
  }
  if (metrics.cancelled_branches) {
    const CancelledBranches& cancelled = *metrics.cancelled_branches;
    text += formatted(
        "   %zu branch pairs cancelled: %zu branches before, %zu after; energy "
        "%.6f before, %.6f after\n",
        cancelled.pairs, cancelled.branches_before, cancelled.branches_after,
        cancelled.energy_before, cancelled.energy_after);
  }
  return text;
}

}  // namespace brindle
