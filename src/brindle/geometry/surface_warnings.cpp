#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "brindle/base/standard.h"
#include "brindle/geometry/topology.h"
#include "brindle/surface.h"

namespace brindle {
namespace {

/// How many edges of one triangle stand exactly where others do.
std::size_t coinciding_boundary_edges(const Surface& surface) {
  const std::vector<Index> first = first_at_each_place(surface.mesh.positions);
  bool any = false;
  for (Index v = 0; v < first.size(); ++v) {
    any = any || (first[v] != v && !surface.neighborhood->of(v).empty());
  }
  if (!any) return 0;
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  std::vector<std::array<Index, 2>> places;
  for (std::size_t e = 0; e < edges.count(); ++e) {
    if (edges.triangle_counts[e] != 1) continue;
    std::array<Index, 2> place{first[edges.vertices[e][0]], first[edges.vertices[e][1]]};
    if (place[0] > place[1]) std::swap(place[0], place[1]);
    if (place[0] != place[1]) places.push_back(place);
  }
  ranges::sort(places.begin(), places.end());
  std::size_t count = 0;
  for (auto begin = places.begin(); begin != places.end();) {
    const auto end = std::find_if(begin, places.end(), [&](const auto& p) { return p != *begin; });
    if (end - begin > 1) count += static_cast<std::size_t>(end - begin);
    begin = end;
  }
  return count;
}

}  // namespace

std::vector<std::string> surface_warnings(const Surface& surface, const std::string& join) {
  const std::size_t count = coinciding_boundary_edges(surface);
  if (count == 0) return {};
  return {std::to_string(count) +
          " boundary edges stand exactly where others do, and the surface is cut there, so that "
          "stripes end; vertices at one place are not joined: " +
          join};
}

}  // namespace brindle
