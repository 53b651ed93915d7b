#include "brindle/geometry/topology.h"

#include <algorithm>
#include <tuple>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/topology.h"

namespace brindle {

/// Triangles are compared at their smallest corner.
std::vector<Index> first_with_same_corners(const Mesh& mesh) {
  struct Entry {
    Index middle, largest, triangle;
  };
  std::vector<Index> first(mesh.triangle_count());
  const VertexTriangles around = vertex_triangles(mesh);
  parallel_for(mesh.vertex_count(), [&](std::size_t begin, std::size_t end) {
    std::vector<Entry> entries;
    for (std::size_t v = begin; v < end; ++v) {
      entries.clear();
      for (const Index number : around.of(v)) {
        Triangle t = mesh.triangles[number];
        ranges::sort(t.begin(), t.end());
        if (t[0] == v) entries.push_back({t[1], t[2], number});
      }
      ranges::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
        return std::tie(x.middle, x.largest, x.triangle) <
               std::tie(y.middle, y.largest, y.triangle);
      });
      for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& entry = entries[i];
        const bool same = i > 0 && entries[i - 1].middle == entry.middle &&
                          entries[i - 1].largest == entry.largest;
        first[entry.triangle] = same ? first[entries[i - 1].triangle] : entry.triangle;
      }
    }
  });
  return first;
}

}  // namespace brindle
