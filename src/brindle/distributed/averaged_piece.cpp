#include "brindle/distributed/averaged_piece.h"

#include <utility>

#include "brindle/distributed/surface/whole_on_first.h"
#include "brindle/pipeline/fields/averaged_normals.h"
#include "brindle/pipeline/fields/surface_elements.h"

namespace brindle {
namespace {

/// All triangles around own vertices have nodes as corners: what an own vertex and its edges count
/// follows from what is here.
NormalElements elements_of(const RankSurface& surface) {
  const std::size_t nodes = surface.graph.node_count();
  Surface of_nodes;
  of_nodes.mesh = triangles_around_own(surface);
  of_nodes.mesh.positions.resize(nodes);
  of_nodes.neighborhood = surface.graph.adjacency;
  const std::vector<float> stiffness = edge_stiffness(of_nodes);
  NormalElements elements;
  elements.normals = std::span(surface.normals).first(nodes);
  elements.areas = areas_of_vertices(of_nodes, areas_of_triangles(of_nodes.mesh));
  elements.degrees = stiffness_sums(*of_nodes.neighborhood, stiffness);
  elements.graph = stiffness_graph(of_nodes, stiffness);
  elements.part = part_of_ranks(surface);
  return elements;
}

}  // namespace

ScreenedOptions part_of_ranks(const RankSurface& surface) {
  ScreenedOptions part;
  part.own = surface.graph.own;
  part.exchange = [&surface](std::span<Complex> values) {
    exchange(*surface.ranks, surface.graph.halo, values);
  };
  part.total = [&surface](double here) { return surface.ranks->sum(here); };
  return part;
}

std::vector<std::vector<Vec3>> averaged_normals(const RankSurface& surface,
                                                std::span<const float> radii) {
  NormalElements elements;
  surface.ranks->together([&] { elements = elements_of(surface); });
  std::vector<std::vector<Vec3>> averages = averaged_normals(std::move(elements), radii);
  for (std::vector<Vec3>& normals : averages) {
    normals.resize(surface.vertex_count());
    surface.exchange_all(std::span(normals));
  }
  return averages;
}

std::vector<std::vector<Vec3>> averaged_on_first(const RankSurface& surface,
                                                 std::span<const float> radii) {
  const WholeOnFirst whole(surface);
  std::vector<std::vector<Vec3>> averages(radii.size());
  surface.ranks->together([&] {
    if (whole.is_first()) averages = averaged_normals(whole.surface(), radii);
  });
  for (std::vector<Vec3>& normals : averages) {
    normals = received_vectors(whole.to_vertices(sent_vectors(normals)));
  }
  return averages;
}

}  // namespace brindle
