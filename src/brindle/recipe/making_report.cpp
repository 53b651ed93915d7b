#include "brindle/recipe/making_report.h"

#include <algorithm>
#include <cstdlib>

#include "brindle/base/text.h"

namespace brindle {
namespace {

std::string text_of(const Winding& winding) { return winding ? std::to_string(*winding) : "none"; }

std::string names_of(const MakingFigures& figures, const std::vector<std::size_t>& boundaries) {
  std::string names;
  for (std::size_t k = 0; k < boundaries.size(); ++k) {
    const char* const before = k == 0 ? "" : k + 1 < boundaries.size() ? ", " : " and ";
    names += before + figures.loops[boundaries[k]].name;
  }
  return names;
}

// Lines on components whose winding numbers at boundaries do not add up, with the reason.
std::string differences(const MakingFigures& figures) {
  std::string text;
  for (const WindingSum& sum : figures.sums) {
    const std::size_t first = sum.boundaries[0], second = sum.boundaries[1];
    const bool pair = sum.boundaries.size() == 2;
    if (pair ? figures.windings[first] == figures.windings[second] : sum.periods == 0) continue;
    const std::string names = names_of(figures, sum.boundaries);
    const std::string how =
        pair ? " differ" : formatted(" do not add up, by %d", std::abs(sum.periods));
    text += "   " + names + how +
            formatted(": of %zu branches and singularities, some lie between\n",
                      figures.branches[first]);
  }
  return text;
}

}  // namespace

void add_to_json(const MakingFigures& figures, nlohmann::ordered_json& json) {
  auto loops = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < figures.loops.size(); ++i) {
    const auto number = [](const Winding& winding) {
      return winding ? nlohmann::ordered_json(*winding) : nlohmann::ordered_json(nullptr);
    };
    const Eigen::Vector3d& center = figures.centers[i];
    nlohmann::ordered_json loop = {{"name", figures.loops[i].name},
                                   {"length", figures.loops[i].length},
                                   {"center", {center.x(), center.y(), center.z()}},
                                   {"winding", number(figures.windings[i])},
                                   {"branches_of_component", figures.branches[i]}};
    if (!figures.windings_before.empty()) {
      loop["winding_before"] = number(figures.windings_before[i]);
    }
    loops.push_back(std::move(loop));
  }
  if (!loops.empty()) json["loops"] = std::move(loops);
  if (!figures.windings_before.empty()) {
    json["turned"] = {{"energy_before", figures.energy_before},
                      {"largest_deg", figures.largest_turn_deg},
                      {"mean_deg", figures.mean_turn_deg},
                      {"largest_frequency_change", figures.largest_frequency_change}};
  }
  if (figures.cancelled_branches) {
    const CancelledBranches& cancelled = *figures.cancelled_branches;
    json["cancelled_branches"] = {{"pairs", cancelled.pairs},
                                  {"branches_before", cancelled.branches_before},
                                  {"energy_before", cancelled.energy_before}};
  }
  if (figures.fixed_vertices > 0) json["boundary_vertices_fixed"] = figures.fixed_vertices;
}

std::string lines_of(const MakingFigures& figures) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostWindings, figures.loops.size()); ++i) {
    const std::string before =
        figures.windings_before.empty() ? "" : ", before " + text_of(figures.windings_before[i]);
    text += formatted("%s%s %s%s", i == 0 ? "   windings: " : "; ", figures.loops[i].name.c_str(),
                      text_of(figures.windings[i]).c_str(), before.c_str());
  }
  if (figures.loops.size() > kMostWindings) {
    text += formatted("; and %zu more in the report", figures.loops.size() - kMostWindings);
  }
  if (!text.empty()) text += '\n';
  return text + remarks_of(figures);
}

std::string remarks_of(const MakingFigures& figures) {
  std::string text = differences(figures);
  if (!figures.windings_before.empty()) {
    text += formatted(
        "   the field is turned by up to %.2f degrees, %.2f on average, frequencies by up to %.1f "
        "%%; energy %.6f before\n",
        figures.largest_turn_deg, figures.mean_turn_deg, 100 * figures.largest_frequency_change,
        figures.energy_before);
  }
  if (figures.cancelled_branches) {
    const CancelledBranches& cancelled = *figures.cancelled_branches;
    text += formatted(
        "   %zu branch pairs cancelled: %zu branches before, %zu after; energy "
        "%.6f before, %.6f after\n",
        cancelled.pairs, cancelled.branches_before, cancelled.branches_after,
        cancelled.energy_before, cancelled.energy_after);
  }
  return text;
}

}  // namespace brindle
