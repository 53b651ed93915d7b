/// Changes of phase along edges and round loops, whose signs change with the waves that they belong
/// to.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/geometry/topology.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// The value of a directed edge, of one value for each.
double value_at(const Adjacency& adjacency, std::span<const float> directed, Index from, Index to);

/// One-forms whose values belong to edges, each from its lower vertex to its higher one and in the
/// lower one's sense.
class TwistedForms {
 public:
  /// `directions` has one entry per vertex. What is handed in must outlive this.
  TwistedForms(const Mesh& mesh, const MeshEdges& edges, const std::vector<Vec3>& directions)
      : mesh_(mesh), edges_(edges), signs_(edges.count()) {
    for (Index e = 0; e < edges.count(); ++e) {
      const auto [a, b] = edges.vertices[e];
      if (directions[a].isZero(0) || directions[b].isZero(0)) continue;
      signs_[e] = directions[a].dot(directions[b]) < 0 ? -1 : 1;
    }
  }

  /// 1 or -1: how its ends' waves run to each other; 0 without both waves.
  int sign(Index edge) const { return signs_[edge]; }

  /// The edge's own number for a value from `start` in that vertex's sense, and back.
  template <class Value>
  Value from(Index edge, Index start, Value value) const {
    return edges_.vertices[edge][0] == start ? value : -signs_[edge] * value;
  }

  /// How the corners' waves run to the first one's, 1 or -1; nothing if they have no orientation.
  std::optional<std::array<int, 3>> senses(Index triangle) const {
    const auto& own = edges_.of_triangle[triangle];
    const std::array<int, 3> senses = {1, signs_[own[0]], signs_[own[2]]};
    if (senses[1] * senses[2] * signs_[own[1]] != 1) return std::nullopt;
    return senses;
  }

  /// What a number of edge m of a triangle adds on the way round it, in the first corner's sense.
  int round(Index triangle, const std::array<int, 3>& senses, int m, int value) const {
    return senses[m] * from(edges_.of_triangle[triangle][m], mesh_.triangles[triangle][m], value);
  }

  /// The number that edge `out` of a triangle must have for a form that has `value` on its edge
  /// `in` and nothing on the third; nothing if the triangle has no orientation.
  std::optional<int> passed_on(Index triangle, int in, int out, int value) const {
    const auto own = senses(triangle);
    if (!own) return std::nullopt;
    return number(triangle, *own, out, -round(triangle, *own, in, value));
  }

  /// The number of edge m that adds `round` on the way round a triangle.
  int number(Index triangle, const std::array<int, 3>& senses, int m, int round) const {
    return from(edges_.of_triangle[triangle][m], mesh_.triangles[triangle][m], round * senses[m]);
  }

 private:
  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<int> signs_;
};

struct LoopWalk {
  bool oriented = false;    ///< the field can be oriented along the loop, and has waves there
  std::vector<int> senses;  ///< 1 or -1 of every vertex: whether its wave runs like the first one's
  int periods = 0;          ///< gained in the first one's sense
  int sign = 1;             ///< what makes of them the number of `Winding`
  int winding() const { return sign * periods; }
};

LoopWalk walk_round(const SurfaceLoop& loop, std::span<const Vec3> normals, const WaveSet& waves,
                    std::span<const Complex> z, PhaseShiftKind kind);

}  // namespace brindle
