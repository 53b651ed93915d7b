/// Phase changes along edges and round loops, with signs relative to the waves' orientation.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/geometry/topology.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// The value of a directed edge, from an array with one value per directed edge.
double value_at(const Adjacency& adjacency, std::span<const float> directed, Index from, Index to);

/// One-forms on a line field. An edge's value belongs to the direction from its lower to its higher
/// vertex, and to the lower vertex's orientation.
class TwistedForms {
 public:
  /// `directions` has one entry per vertex. The arguments must outlive this object.
  TwistedForms(const Mesh& mesh, const MeshEdges& edges, const std::vector<Vec3>& directions)
      : mesh_(mesh), edges_(edges), signs_(edges.count()) {
    for (Index e = 0; e < edges.count(); ++e) {
      const auto [a, b] = edges.vertices[e];
      if (directions[a].isZero(0) || directions[b].isZero(0)) continue;
      signs_[e] = directions[a].dot(directions[b]) < 0 ? -1 : 1;
    }
  }

  /// 1 or -1: relative orientation of the waves at its ends; 0 if one has no wave.
  int sign(Index edge) const { return signs_[edge]; }

  /// Converts a value from `start`, in its orientation, to the edge's own value, or back.
  template <class Value>
  Value from(Index edge, Index start, Value value) const {
    return edges_.vertices[edge][0] == start ? value : -signs_[edge] * value;
  }

  /// Wave signs of the corners relative to the first, 1 or -1; nullopt if not orientable.
  std::optional<std::array<int, 3>> senses(Index triangle) const {
    const auto& own = edges_.of_triangle[triangle];
    const std::array<int, 3> senses = {1, signs_[own[0]], signs_[own[2]]};
    if (senses[1] * senses[2] * signs_[own[1]] != 1) return std::nullopt;
    return senses;
  }

  /// Contribution of edge m's value on the way round a triangle, in the first corner's orientation.
  int round(Index triangle, const std::array<int, 3>& senses, int m, int value) const {
    return senses[m] * from(edges_.of_triangle[triangle][m], mesh_.triangles[triangle][m], value);
  }

  /// The value of edge `out` in a form with `value` on edge `in` and 0 on the third edge; nullopt
  /// if the triangle is not orientable.
  std::optional<int> passed_on(Index triangle, int in, int out, int value) const {
    const auto own = senses(triangle);
    if (!own) return std::nullopt;
    return number(triangle, *own, out, -round(triangle, *own, in, value));
  }

  /// Inverse of `round`: the value of edge m that contributes `round`.
  int number(Index triangle, const std::array<int, 3>& senses, int m, int round) const {
    return from(edges_.of_triangle[triangle][m], mesh_.triangles[triangle][m], round * senses[m]);
  }

 private:
  const Mesh& mesh_;
  const MeshEdges& edges_;
  std::vector<int> signs_;
};

struct LoopWalk {
  bool oriented = false;    ///< the field is orientable along the loop and has waves there
  std::vector<int> senses;  ///< 1 or -1 by vertex: wave sign relative to the first
  int periods = 0;          ///< gained, in the first wave's orientation
  int sign = 1;             ///< from `periods` to the sign of `Winding`
  int winding() const { return sign * periods; }
};

LoopWalk walk_round(const SurfaceLoop& loop, std::span<const Vec3> normals, const WaveSet& waves,
                    std::span<const Complex> z, PhaseShiftKind kind);

// Closed one-forms of least norm with prescribed periods.

/// Periods to add round a loop, in the orientation of its first vertex's wave.
struct MissingPeriods {
  std::size_t loop;
  int periods;
};

/// Returns the harmonic one-form beta: d beta = 0, the given periods, least cotangent-weighted
/// norm. Its sign changes with the waves, since it lives on the field's orientation covering.
/// Result: its gradient at each vertex in that vertex's orientation, a tangent vector in radians
/// per unit length. `walks` has one entry per loop. A change round a boundary is balanced at the
/// nearest boundary that is not in `missing`. Throws Error if no path exists.
std::vector<Eigen::Vector3d> harmonic_change(const Surface& surface, const MeshEdges& edges,
                                             const std::vector<SurfaceLoop>& loops,
                                             const std::vector<LoopWalk>& walks,
                                             const std::vector<MissingPeriods>& missing,
                                             const std::vector<Vec3>& directions);

}  // namespace brindle
