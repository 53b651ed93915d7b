#include "brindle/waves/direction_graph.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"

namespace brindle {
namespace {

float angle_of(const Vec3& direction, const TangentBasis& basis) {
  return elementary::atan2(direction.dot(basis.y), direction.dot(basis.x));
}

struct Transport {
  float radians;    ///< the angle at i of a direction with angle 0 at j
  bool reflecting;  ///< angles at i are counted in the opposite sense
};

Transport transport(const Vec3& n_j, const Vec3& n_i) {
  const bool reflecting = n_j.dot(n_i) < kOppositeSides;
  const Vec3 x = transported(tangent_basis(n_j).x, n_j, reflecting ? Vec3(-n_i) : n_i);
  return {angle_of(x, tangent_basis(n_i)), reflecting};
}

void check_normals(const Adjacency& adjacency, std::span<const Vec3> normals) {
  if (normals.size() != adjacency.node_count()) {
    throw Error("direction graph: there must be one normal for each of " +
                std::to_string(adjacency.node_count()) + " vertices");
  }
  const auto bad = std::find_if_not(normals.begin(), normals.end(),
                                    [](const Vec3& normal) { return normal.allFinite(); });
  if (bad == normals.end()) return;
  throw Error("direction graph: the normal of vertex " + std::to_string(bad - normals.begin()) +
              " is not finite; give a unit vector, or zero for no direction");
}

/// `couple(i, j, edge)` gives the coupling of directions at neighbours and whether it reflects.
template <class Couple>
PhaseGraph coupled_directions(std::shared_ptr<const Adjacency> adjacency, const Progress& progress,
                              const Couple& couple) {
  PhaseGraph graph;
  graph.coupling.resize(adjacency->directed_edge_count());
  graph.reflecting.resize(adjacency->directed_edge_count());
  parallel_for(adjacency->node_count(), progress, [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < end; ++i) {
      for (Index edge = adjacency->offsets[i]; edge < adjacency->offsets[i + 1]; ++edge) {
        const auto [coupling, reflecting] = couple(i, adjacency->neighbors[edge], edge);
        graph.coupling[edge] = coupling;
        graph.reflecting[edge] = reflecting;
      }
    }
  });
  graph.adjacency = std::move(adjacency);
  return graph;
}

}  // namespace

TangentBasis tangent_basis(const Vec3& normal) {
  // Duff et al. 2017: branch-free except for the sign, and accurate near the pole.
  const float sign = std::copysign(1.0f, normal.z());
  const float a = -1 / (sign + normal.z());
  const float b = normal.x() * normal.y() * a;
  return {{1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x()},
          {b, sign + normal.y() * normal.y() * a, -normal.y()}};
}

std::size_t count_opposite_edges(const Adjacency& adjacency, std::span<const Vec3> normals) {
  std::size_t count = 0;
  for (Index i = 0; i < adjacency.node_count(); ++i) {
    for (const Index j : adjacency.of(i)) count += normals[i].dot(normals[j]) < kOppositeSides;
  }
  return count;
}

Vec3 transported(const Vec3& vector, const Vec3& from, const Vec3& to) {
  const Vec3 axis = from.cross(to);
  const float cosine = from.dot(to);
  return vector * cosine + axis.cross(vector) + axis * (axis.dot(vector) / (1 + cosine));
}

PhaseGraph build_direction_graph(std::shared_ptr<const Adjacency> adjacency,
                                 std::span<const Vec3> normals, int symmetry,
                                 const Progress& progress) {
  check_normals(*adjacency, normals);
  return coupled_directions(std::move(adjacency), progress, [&](Index i, Index j, Index) {
    const Transport t = transport(normals[j], normals[i]);
    return std::pair(elementary::polar(1.0f, static_cast<float>(symmetry) * t.radians),
                     t.reflecting);
  });
}

PhaseGraph build_weighted_direction_graph(std::shared_ptr<const Adjacency> adjacency,
                                          std::span<const Vec3> normals, int symmetry,
                                          std::span<const float> weights,
                                          const Progress& progress) {
  check_normals(*adjacency, normals);
  std::vector<TangentBasis> bases(normals.size());
  parallel_for(normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) bases[i] = tangent_basis(normals[i]);
  });
  return coupled_directions(std::move(adjacency), progress, [&](Index i, Index j, Index edge) {
    const bool reflecting = normals[j].dot(normals[i]) < kOppositeSides;
    const Vec3 x = transported(bases[j].x, normals[j], reflecting ? Vec3(-normals[i]) : normals[i]);
    const Complex turn(x.dot(bases[i].x), x.dot(bases[i].y));
    Complex power = turn;
    for (int n = 1; n < symmetry; ++n) power *= turn;
    return std::pair(weights[edge] * power, reflecting);
  });
}

PhaseGraph direction_graph_of(const Surface& surface, int symmetry, const Progress& progress) {
  if (surface.creases.empty()) {
    return build_direction_graph(surface.neighborhood, surface.normals, symmetry, progress);
  }
  constexpr float kAcrossCreases = 0.02f;
  const auto linked_to = neighbors_over_creases(surface);
  const Adjacency& linked = *linked_to;
  std::vector<float> weights(linked.directed_edge_count(), 1);
  for (Index i = 0; i < linked.node_count(); ++i) {
    for (Index edge = linked.offsets[i]; edge < linked.offsets[i + 1]; ++edge) {
      const Index j = linked.neighbors[edge];
      if (surface.mesh.positions[i] == surface.mesh.positions[j]) weights[edge] = kAcrossCreases;
    }
  }
  return build_weighted_direction_graph(linked_to, surface.normals, symmetry, weights, progress);
}

Complex representation(const Vec3& direction, const Vec3& normal, int symmetry) {
  if (direction.isZero(0)) return 0;
  const float theta = angle_of(direction, tangent_basis(normal));
  return elementary::polar(1.0f, static_cast<float>(symmetry) * theta);
}

namespace {

/// The square root of a unit number whose real part is not below 0.
Complex principal_root(const Complex& u) {
  if (u.real() >= 0) {
    const float real = std::sqrt((1 + u.real()) / 2);
    return {real, u.imag() / (2 * real)};
  }
  const float imaginary = std::copysign(std::sqrt((1 - u.real()) / 2), u.imag());
  return {u.imag() / (2 * imaginary), imaginary};
}

}  // namespace

Complex unit_root(const Complex& u, int symmetry) {
  if (u == Complex(0)) return 1;
  if (symmetry != 1 && symmetry != 2 && symmetry != 4) {
    return elementary::polar(1.0f, elementary::arg(u) / static_cast<float>(symmetry));
  }
  Complex root = u / std::sqrt(std::norm(u));
  for (int n = symmetry; n > 1; n /= 2) root = principal_root(root);
  return root;
}

DirectionField directions_of(std::span<const Complex> u, std::span<const Vec3> normals,
                             int symmetry, const Progress& progress) {
  DirectionField directions(u.size());
  parallel_for(u.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float theta = elementary::arg(u[i]) / static_cast<float>(symmetry);
      const TangentBasis basis = tangent_basis(normals[i]);
      directions[i] =
          normals[i].isZero(0)
              ? Vec3(Vec3::Zero())
              : Vec3(elementary::cos(theta) * basis.x + elementary::sin(theta) * basis.y);
    }
  });
  return directions;
}

}  // namespace brindle
