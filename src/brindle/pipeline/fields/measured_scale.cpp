#include "brindle/pipeline/fields/measured_scale.h"

#include <algorithm>
#include <tuple>

#include "brindle/base/standard.h"
#include "brindle/direction_field.h"
#include "brindle/geometry/topology.h"

namespace brindle {

FoundSingularities opposite_singularities(const Surface& surface, std::span<const Vec3> directions,
                                          int symmetry, std::span<const float> frequencies,
                                          float reach) {
  FoundSingularities found;
  const std::vector<SingularTriangle> singular =
      singular_triangles(surface.mesh, directions, symmetry);
  found.count = singular.size();

  // Singularities of negative index, by corner.
  std::vector<std::vector<Index>> negative_at(surface.mesh.vertex_count());
  for (const SingularTriangle& at : singular) {
    if (at.index > 0) continue;
    for (const Index v : surface.mesh.triangles[at.triangle]) negative_at[v].push_back(at.triangle);
  }
  PeriodWalk walk(surface, frequencies);
  std::vector<OppositeSingularities> near;
  for (const SingularTriangle& at : singular) {
    if (at.index < 0) continue;
    walk.from(surface.mesh.triangles[at.triangle], reach, [&](Index v, float distance) {
      for (const Index t : negative_at[v]) near.push_back({at.triangle, t, distance});
      return true;
    });
  }
  ranges::sort(near, {}, [](const OppositeSingularities& pair) {
    return std::tuple(pair.distance, pair.positive, pair.negative);
  });
  std::vector<bool> is_taken(surface.mesh.triangle_count());
  for (const OppositeSingularities& pair : near) {
    if (is_taken[pair.positive] || is_taken[pair.negative]) continue;
    is_taken[pair.positive] = is_taken[pair.negative] = true;
    found.pairs.push_back(pair);
  }
  return found;
}

}  // namespace brindle
