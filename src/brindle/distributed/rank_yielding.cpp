#include "brindle/distributed/rank_yielding.h"

#include <algorithm>
#include <string>

#include "brindle/error.h"

namespace brindle {
namespace {

/// Triangles with an own vertex. Of the ranks that have one, the first that owns a vertex of it
/// counts it.
FrequencyTriangles triangles_around_own(const RankSurface& surface) {
  const RankGraph& graph = surface.graph;
  const std::vector<int> owner = owners(*surface.ranks, graph);
  FrequencyTriangles triangles;
  const auto add = [&](const Triangle& triangle) {
    const auto is_own = [&](Index v) { return v < graph.own; };
    if (std::ranges::none_of(triangle, is_own)) return;
    const int first = std::min({owner[triangle[0]], owner[triangle[1]], owner[triangle[2]]});
    triangles.corners.push_back(triangle);
    triangles.counted.push_back(first == surface.ranks->rank() ? 1 : 0);
  };
  for (const Triangle& triangle : surface.mesh.triangles) add(triangle);
  for (const Triangle& triangle : surface.ring) add(triangle);
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

std::shared_ptr<const YieldingSetting> rank_yielding_setting(const RankSurface& surface,
                                                             const Slack& slack) {
  Slack of_vertices = slack;
  of_vertices.by_vertex = owners_values(surface, slack.by_vertex);
  of_vertices.calm = owners_values(surface, slack.calm);
  auto setting = std::make_shared<YieldingSetting>();
  setting->slack = slack_by_vertex(of_vertices, surface.vertex_count());
  setting->slack.resize(surface.graph.node_count());
  exchange(*surface.ranks, surface.graph.halo, std::span(setting->slack));
  if (surface.ranks->size() == 1) {
    setting->triangles.corners = surface.mesh.triangles;
  } else {
    setting->triangles = triangles_around_own(surface);
  }
  setting->triangles.weights = calm_weights(setting->triangles.corners, of_vertices.calm);
  setting->adjacency = surface.graph.adjacency;
  return setting;
}

void check_on_all(const RankSurface& surface, const Slack& slack) {
  const std::size_t vertices = surface.vertex_of_piece.size();
  surface.ranks->together([&] { check(slack, vertices); });
  for (const auto* list : {&slack.by_vertex, &slack.calm}) {
    const bool is_given = surface.ranks->any(!list->empty());
    surface.ranks->together([&] {
      if (!is_given || !list->empty() || vertices == 0) return;
      throw Error("slack: other ranks have a number for each vertex, and this one has none; give " +
                  std::string("one to each vertex of all pieces"));
    });
  }
}

}  // namespace brindle
