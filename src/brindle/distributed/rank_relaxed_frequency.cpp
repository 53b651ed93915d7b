#include "brindle/distributed/rank_relaxed_frequency.h"

#include <algorithm>

#include "brindle/error.h"
#include "brindle/waves/slack_check.h"

namespace brindle {
namespace {

/// A triangle belongs to the first rank that owns one of its vertices. A single rank owns all.
FrequencyTriangles frequency_triangles(const RankSurface& surface) {
  FrequencyTriangles triangles{triangles_around_own(surface).triangles, {}, {}};
  if (surface.ranks->size() == 1) return triangles;
  const std::vector<int> owner = owners(*surface.ranks, surface.graph);
  for (const auto& [a, b, c] : triangles.corners) {
    const int first = std::min({owner[a], owner[b], owner[c]});
    triangles.counted.push_back(first == surface.ranks->rank() ? 1 : 0);
  }
  return triangles;
}

}  // namespace

std::vector<float> owners_values(const RankSurface& surface, std::span<const float> of_piece) {
  if (!surface.ranks->any(!of_piece.empty())) return {};
  std::vector<float> values(surface.vertex_count());
  for (std::size_t p = 0; p < of_piece.size(); ++p) {
    values[surface.vertex_of_piece[p]] = of_piece[p];
  }
  surface.exchange_all(std::span(values));
  return values;
}

std::shared_ptr<const RelaxedFrequencySetting> rank_relaxed_setting(const RankSurface& surface,
                                                                    const Slack& slack) {
  Slack of_vertices = slack;
  of_vertices.by_vertex = owners_values(surface, slack.by_vertex);
  of_vertices.branch_penalty = owners_values(surface, slack.branch_penalty);
  auto setting = std::make_shared<RelaxedFrequencySetting>();
  setting->slack = slack_by_vertex(of_vertices, surface.vertex_count());
  setting->slack.resize(surface.graph.node_count());
  exchange(*surface.ranks, surface.graph.halo, std::span(setting->slack));
  setting->branch_penalty = of_vertices.branch_penalty;
  setting->triangles = frequency_triangles(surface);
  setting->triangles.weights =
      penalty_weights(setting->triangles.corners, of_vertices.branch_penalty);
  setting->adjacency = surface.graph.adjacency;
  return setting;
}

void check_on_all(const RankSurface& surface, const Slack& slack) {
  const std::size_t vertices = surface.vertex_of_piece.size();
  surface.ranks->throw_on_all([&] { check_slack(slack, vertices); });
  for (const auto* list : {&slack.by_vertex, &slack.branch_penalty}) {
    const bool is_given = surface.ranks->any(!list->empty());
    surface.ranks->throw_on_all([&] {
      if (!is_given || !list->empty() || vertices == 0) return;
      throw Error(
          "slack: other ranks have a number for each vertex, and this one has none; give one to "
          "each vertex of all pieces");
    });
  }
}

}  // namespace brindle
