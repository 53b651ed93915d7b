#include "brindle/pipeline/windings/twisted_forms.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {

double value_at(const Adjacency& adjacency, std::span<const float> directed, Index from, Index to) {
  const auto row = adjacency.of(from);
  const auto at = std::lower_bound(row.begin(), row.end(), to) - row.begin();
  return static_cast<double>(directed[adjacency.offsets[from] + static_cast<std::size_t>(at)]);
}

LoopWalk walk_round(const SurfaceLoop& loop, std::span<const Vec3> normals, const WaveSet& waves,
                    std::span<const Complex> z, PhaseShiftKind kind) {
  LoopWalk walk;
  const std::size_t count = loop.vertices.size();
  double radians = 0, along = 0, across = 0;
  int sense = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Index a = loop.vertices[i], b = loop.vertices[(i + 1) % count];
    if (waves.directions[a].isZero(0) || waves.directions[b].isZero(0)) return walk;
    walk.senses.push_back(sense);
    CornerWave here{waves.wave(a), z[a]}, there{waves.wave(b), z[b]};
    if (sense < 0) here = flipped(here);
    sense = here.wave.direction.dot(there.wave.direction) < 0 ? -1 : 1;
    if (sense < 0) there = flipped(there);
    radians += static_cast<double>(lifted_step(here, there, kind));
    const Vec3 way = there.wave.position - here.wave.position;
    const Vec3 waves_run = here.wave.direction + there.wave.direction;
    along += static_cast<double>(waves_run.dot(way));
    across += static_cast<double>(waves_run.dot((normals[a] + normals[b]).cross(way))) / 2;
  }
  if (sense < 0) return walk;
  walk.oriented = true;
  walk.periods = static_cast<int>(std::lround(radians / static_cast<double>(kTwoPi)));
  // If the phase grows along the path and waves point left of it, stripes drift to the right.
  walk.sign =
      std::abs(along) > std::abs(across) ? (walk.periods < 0 ? -1 : 1) : (across > 0 ? -1 : 1);
  return walk;
}

namespace {

/// Finds dual paths that carry a closed form: strips of triangles.
class CutFinder {
 public:
  CutFinder(const MeshEdges& edges, const TwistedForms& forms,
            const std::vector<SurfaceLoop>& loops)
      : edges_(edges), forms_(forms), loops_(loops) {
    boundary_of_.assign(edges.count(), -1);
    on_handle_.assign(edges.count(), false);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      for (std::size_t k = 0; k < loops[i].vertices.size(); ++k) {
        const Index e = edge_at(loops[i], k);
        if (loops[i].boundary) {
          boundary_of_[e] = static_cast<int>(i);
        } else {
          on_handle_[e] = true;
        }
      }
    }
  }

  /// Adds a closed form to `form` whose period is `scale` round the loop and 0 round all others,
  /// except for one boundary that is not `taken`.
  void add(std::size_t loop, const LoopWalk& walk, const std::vector<bool>& taken, double scale,
           std::vector<double>& form) {
    states_.clear();
    seen_.assign(4 * edges_.count(), false);
    const SurfaceLoop& way = loops_[loop];
    const std::size_t count = way.vertices.size();
    for (std::size_t k = way.boundary ? 0 : count - 1; k < count; ++k) {
      const Index e = edge_at(way, k);
      if (way.boundary && on_handle_[e]) continue;
      push(e, forms_.from(e, way.vertices[k], walk.senses[k]), edges_.triangles(e)[0], -1);
    }
    const std::optional<int> last = search(loop, taken);
    if (!last) {
      throw Error("windings: there is no way for a change round " + way.name +
                  (way.boundary ? ": name another boundary as well, or fewer"
                                : ": the field cannot be oriented across it"));
    }
    for (int i = *last; i >= 0; i = states_[i].before) {
      form[states_[i].edge] += scale * states_[i].value;
    }
  }

 private:
  struct State {
    Index edge;
    int value;
    Index next;  ///< triangle
    int before;
  };

  Index edge_at(const SurfaceLoop& loop, std::size_t k) const {
    const Index a = loop.vertices[k], b = loop.vertices[(k + 1) % loop.vertices.size()];
    return edges_.between(a, b);
  }

  void push(Index edge, int value, Index next, int before) {
    const std::size_t side = edges_.triangles(edge)[0] == next ? 0 : 1;
    const std::size_t key = 4 * edge + 2 * side + (value > 0 ? 1 : 0);
    if (seen_[key]) return;
    seen_[key] = true;
    states_.push_back({edge, value, next, before});
  }

  /// Breadth-first search. Returns the last state of the path; appends the end edge unless it is
  /// the start edge.
  std::optional<int> search(std::size_t loop, const std::vector<bool>& taken) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State state = states_[i];
      const auto& own = edges_.of_triangle[state.next];
      const int in = static_cast<int>(std::find(own.begin(), own.end(), state.edge) - own.begin());
      for (int out = 0; out < 3; ++out) {
        if (out == in) continue;
        const auto value = forms_.passed_on(state.next, in, out, state.value);
        if (!value) break;
        const Index e = own[out];
        if (!loops_[loop].boundary && e == states_[0].edge && *value == states_[0].value) {
          return static_cast<int>(i);
        }
        if (on_handle_[e]) continue;
        const int boundary = boundary_of_[e];
        if (boundary >= 0) {
          if (!loops_[loop].boundary || taken[boundary]) continue;
          states_.push_back({e, *value, kNoTriangle, static_cast<int>(i)});
          return static_cast<int>(states_.size() - 1);
        }
        const auto sides = edges_.triangles(e);
        push(e, *value, sides[0] == state.next ? sides[1] : sides[0], static_cast<int>(i));
      }
    }
    return std::nullopt;
  }

  const MeshEdges& edges_;
  const TwistedForms& forms_;
  const std::vector<SurfaceLoop>& loops_;
  std::vector<int> boundary_of_;
  std::vector<bool> on_handle_;
  std::vector<State> states_;
  std::vector<bool> seen_;
};

/// Cotangent weights, clamped above zero, since obtuse triangles make them negative.
std::vector<double> form_weights(const Surface& surface, const MeshEdges& edges) {
  const Adjacency& adjacency = *surface.neighborhood;
  const std::vector<float> directed = cotangent_weights(surface.mesh, adjacency);
  std::vector<double> weights(edges.count());
  for (Index e = 0; e < edges.count(); ++e) {
    const auto [a, b] = edges.vertices[e];
    weights[e] = std::max(0.02, value_at(adjacency, directed, b, a) - 0.5);
  }
  return weights;
}

/// Subtracts the exact part of `form`: the remainder has the least norm.
void make_harmonic(const TwistedForms& forms, const MeshEdges& edges,
                   const std::vector<double>& weights, std::size_t vertices,
                   std::vector<double>& form) {
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(vertices));
  std::vector<double> diagonal(vertices, 0);
  for (Index e = 0; e < edges.count(); ++e) {
    const int sign = forms.sign(e);
    if (sign == 0) continue;
    const auto [a, b] = edges.vertices[e];
    diagonal[a] += weights[e];
    diagonal[b] += weights[e];
    entries.emplace_back(a, b, -sign * weights[e]);
    entries.emplace_back(b, a, -sign * weights[e]);
    right[a] += weights[e] * form[e];
    right[b] -= sign * weights[e] * form[e];
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    // Functions are unique up to a constant where the field is orientable.
    const double own = diagonal[v] > 0 ? (1 + 1e-9) * diagonal[v] : 1;
    entries.emplace_back(static_cast<int>(v), static_cast<int>(v), own);
  }
  const auto size = static_cast<Eigen::Index>(vertices);
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper,
                           Eigen::IncompleteCholesky<double>>
      solver(matrix);
  solver.setTolerance(1e-8);
  const Eigen::VectorXd function = solver.solve(right);
  for (Index e = 0; e < edges.count(); ++e) {
    const auto [a, b] = edges.vertices[e];
    form[e] = forms.sign(e) == 0 ? 0 : form[e] + forms.sign(e) * function[b] - function[a];
  }
}

/// Vertices whose edges are nearly collinear, as in slivers. Across that line their gradients are
/// rounding errors divided by almost zero.
class Slivers {
 public:
  explicit Slivers(const std::vector<Eigen::Matrix2d>& products) {
    for (Index v = 0; v < products.size(); ++v) {
      const double trace = products[v].trace();
      if (products[v].determinant() < kThin * trace * trace) vertices_.push_back(v);
    }
  }

  /// Replaces outliers among their gradients by the mean of the neighbours'.
  void smooth(const Surface& surface, const std::vector<Vec3>& directions,
              std::vector<Eigen::Vector3d>& gradients) const {
    std::vector<Eigen::Vector3d> smoothed;
    for (const Index v : vertices_)
      smoothed.push_back(smooth_one(v, surface, directions, gradients));
    for (std::size_t i = 0; i < vertices_.size(); ++i) gradients[vertices_[i]] = smoothed[i];
  }

 private:
  static constexpr double kThin = 1e-3;
  static constexpr double kStandsOut = 2;

  Eigen::Vector3d smooth_one(Index v, const Surface& surface, const std::vector<Vec3>& directions,
                             const std::vector<Eigen::Vector3d>& gradients) const {
    double largest = 0, count = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Index w : surface.neighborhood->of(v)) {
      if (ranges::binary_search(vertices_, w) || directions[w].isZero(0)) continue;
      largest = std::max(largest, gradients[w].norm());
      sum += (directions[v].dot(directions[w]) < 0 ? -1 : 1) * gradients[w];
      ++count;
    }
    if (count == 0 || gradients[v].norm() <= kStandsOut * largest) return gradients[v];
    const Eigen::Vector3d normal = surface.normals[v].cast<double>();
    const Eigen::Vector3d mean = sum / count;
    return mean - mean.dot(normal) * normal;
  }

  std::vector<Index> vertices_;  ///< in ascending order
};

/// Per vertex, the tangent vector whose products with its edges best fit the form (least squares).
std::vector<Eigen::Vector3d> gradients(const TwistedForms& forms, const Surface& surface,
                                       const MeshEdges& edges, const std::vector<double>& weights,
                                       const std::vector<double>& form,
                                       const std::vector<Vec3>& directions) {
  const std::size_t count = surface.mesh.vertex_count();
  std::vector<Eigen::Matrix2d> left(count, Eigen::Matrix2d::Zero());
  std::vector<Eigen::Vector2d> right(count, Eigen::Vector2d::Zero());
  const auto plane = [&](Index v, const Vec3& way) {
    const TangentBasis basis = tangent_basis(surface.normals[v]);
    return Eigen::Vector2d(basis.x.dot(way), basis.y.dot(way));
  };
  for (Index e = 0; e < edges.count(); ++e) {
    if (forms.sign(e) == 0) continue;
    const auto [a, b] = edges.vertices[e];
    const Vec3 way = surface.mesh.positions[b] - surface.mesh.positions[a];
    const auto add = [&](Index v, const Vec3& from_v, double value) {
      const Eigen::Vector2d flat = plane(v, from_v);
      left[v] += weights[e] * flat * flat.transpose();
      right[v] += weights[e] * value * flat;
    };
    add(a, way, form[e]);
    add(b, -way, -forms.sign(e) * form[e]);
  }
  std::vector<Eigen::Vector3d> result(count, Eigen::Vector3d::Zero());
  for (Index v = 0; v < count; ++v) {
    if (!(left[v].determinant() > 1e-12 * left[v].squaredNorm())) continue;
    const Eigen::Vector2d flat = left[v].inverse() * right[v];
    const TangentBasis basis = tangent_basis(surface.normals[v]);
    result[v] = flat.x() * basis.x.cast<double>() + flat.y() * basis.y.cast<double>();
  }
  Slivers(left).smooth(surface, directions, result);
  return result;
}

}  // namespace

std::vector<Eigen::Vector3d> harmonic_change(const Surface& surface, const MeshEdges& edges,
                                             const std::vector<SurfaceLoop>& loops,
                                             const std::vector<LoopWalk>& walks,
                                             const std::vector<MissingPeriods>& missing,
                                             const std::vector<Vec3>& directions) {
  const TwistedForms forms(surface.mesh, edges, directions);
  CutFinder cuts(edges, forms, loops);
  std::vector<bool> taken(loops.size());
  for (const MissingPeriods& m : missing) taken[m.loop] = true;
  std::vector<double> form(edges.count(), 0);
  for (const MissingPeriods& m : missing) {
    if (m.periods == 0) continue;
    cuts.add(m.loop, walks[m.loop], taken, 2 * std::numbers::pi * m.periods, form);
  }
  const std::vector<double> weights = form_weights(surface, edges);
  make_harmonic(forms, edges, weights, surface.mesh.vertex_count(), form);
  return gradients(forms, surface, edges, weights, form, directions);
}

}  // namespace brindle
