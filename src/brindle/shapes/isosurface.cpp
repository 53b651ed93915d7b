#include "brindle/shapes/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/shapes/index_map.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;
using Cell = Eigen::Vector3i;
using Tetrahedron = std::array<Index, 4>;

/// Measured ratio of lattice cells to edges of the triangles.
constexpr double kCellPerEdge = 1.29;
constexpr int kMaxCells = 1 << 12;  ///< along one axis
constexpr std::size_t kValuesPerReport = 1 << 12;
constexpr Index kNone = ~Index{0};
constexpr std::size_t kMovedPerReport = 1 << 12;  ///< vertices, with several evaluations each

/// Edges by their ends, in lists per lower-numbered end.
class EdgeList {
 public:
  explicit EdgeList(std::size_t points) : first_(points, kNone) {}

  /// The number of the edge between two points, in order of insertion, and whether it is new.
  std::pair<Index, bool> try_emplace(Index a, Index b) {
    if (a > b) std::swap(a, b);
    for (Index edge = first_[a]; edge != kNone; edge = edges_[edge].next) {
      if (edges_[edge].to == b) return {edge, false};
    }
    const auto added = static_cast<Index>(edges_.size());
    edges_.push_back({b, std::exchange(first_[a], added)});
    return {added, true};
  }

 private:
  struct Edge {
    Index to;
    Index next;  ///< with the same lower end; kNone: none
  };

  std::vector<Index> first_;
  std::vector<Edge> edges_;
};

/// The body-centred cubic lattice near the surface: points with values of the function, and all
/// tetrahedra that the surface crosses.
class Lattice {
 public:
  Lattice(const ImplicitFunction& function, const BoundingBox& box, double cell,
          const Progress& progress)
      : function_(function), progress_(progress), origin_(box.lower.cast<double>()), cell_(cell) {
    const Point extent = (box.upper - box.lower).cast<double>();
    // Tetrahedra extend one cell beyond the last cell on each axis.
    origin_ -= Point::Constant(1.5 * cell);
    const Cell cells = (extent / cell).array().ceil().cast<int>() + 3;
    descend(Cell::Zero(), cells, 0, 1);
    blocks_ = {};
    numbers_ = {};
  }

  std::vector<double> values;  ///< of the function, at all points
  std::vector<Tetrahedron> tetrahedra;

  Point position(Index point) const {
    const auto& [x, y, z] = halves_[point];
    return place({x, y, z});
  }

 private:
  /// The function at a point. Reports progress regularly.
  double value(const Point& at) {
    if (++asked_ % kValuesPerReport == 0) progress_.report(done_);
    return function_(at);
  }

  /// Bisects the range of cells [lower, upper) down to single cells near the surface. `begin` to
  /// `end` is the range's share of the progress.
  void descend(const Cell& lower, const Cell& upper, double begin, double end) {
    done_ = begin;
    const Cell size = upper - lower;
    const Point center = place(lower + upper);
    const double reach = 0.5 * cell_ * size.cast<double>().norm() + cell_;
    if (std::abs(value(center)) > reach) return;
    int axis = 0;
    if (size.maxCoeff(&axis) == 1) {
      add_cell(lower);
      return;
    }
    Cell middle_upper = upper, middle_lower = lower;
    middle_upper[axis] = middle_lower[axis] = lower[axis] + size[axis] / 2;
    const double middle = 0.5 * (begin + end);
    descend(lower, middle_upper, begin, middle);
    descend(middle_lower, upper, middle, end);
  }

  /// The tetrahedra between this cell's centre and those of the next cells along each axis.
  void add_cell(const Cell& cell) {
    const Cell center = 2 * cell + Cell::Ones();
    for (int axis = 0; axis < 3; ++axis) {
      const Cell step = 2 * Cell::Unit(axis);
      const Cell u = 2 * Cell::Unit((axis + 1) % 3), v = 2 * Cell::Unit((axis + 2) % 3);
      const Cell corner = 2 * cell + step;
      const std::array<Cell, 4> around = {corner, corner + u, corner + u + v, corner + v};
      for (int i = 0; i < 4; ++i) {
        add_tetrahedron(
            {point(center), point(center + step), point(around[i]), point(around[(i + 1) % 4])});
      }
    }
  }

  void add_tetrahedron(const Tetrahedron& t) {
    const auto inside = std::count_if(t.begin(), t.end(), [&](Index p) { return values[p] < 0; });
    if (inside > 0 && inside < 4) tetrahedra.push_back(t);
  }

  /// Lattice coordinates are in half cells: all even at corners, all odd at centres.
  Point place(const Cell& halves) const { return origin_ + 0.5 * cell_ * halves.cast<double>(); }

  Index point(const Cell& halves) {
    Index& number = number_at(halves);
    if (number == kNone) {
      number = static_cast<Index>(values.size());
      halves_.push_back({static_cast<std::uint16_t>(halves[0]),
                         static_cast<std::uint16_t>(halves[1]),
                         static_cast<std::uint16_t>(halves[2])});
      values.push_back(value(place(halves)));
    }
    return number;
  }

  /// The storage of a point's number. Points of 4 x 4 x 4 cells, a corner and a centre each, are
  /// adjacent for locality.
  Index& number_at(const Cell& halves) {
    std::uint64_t block = 0;
    std::size_t place_in_block = static_cast<std::size_t>(halves[0]) & 1;
    for (int axis = 0; axis < 3; ++axis) {
      block = block << 21 | static_cast<std::uint64_t>(halves[axis]) >> 3;
      place_in_block = place_in_block << 2 | (static_cast<std::size_t>(halves[axis]) >> 1 & 3);
    }
    const auto [number, added] = blocks_.try_emplace(block, static_cast<Index>(numbers_.size()));
    if (added) numbers_.emplace_back().fill(kNone);
    return numbers_[number][place_in_block];
  }

  const ImplicitFunction& function_;
  const Progress& progress_;
  std::size_t asked_ = 0;
  double done_ = 0;
  Point origin_;
  double cell_;
  std::vector<std::array<std::uint16_t, 3>> halves_;  ///< a third of the size of positions
  IndexMap blocks_;  ///< the block of `numbers_` with a block's points
  std::deque<std::array<Index, 128>> numbers_;
};

Point crossing(const Lattice& lattice, Index a, Index b) {
  const double fa = lattice.values[a], fb = lattice.values[b];
  return lattice.position(a) + fa / (fa - fb) * (lattice.position(b) - lattice.position(a));
}

/// The tetrahedra at each lattice point, in compressed rows.
struct TetrahedraAround {
  std::vector<std::size_t> begin;  ///< one per point, and the end of the last
  std::vector<Index> tetrahedra;

  std::span<const Index> of(Index point) const {
    return {tetrahedra.data() + begin[point], begin[point + 1] - begin[point]};
  }
};

TetrahedraAround tetrahedra_around(const Lattice& lattice) {
  const auto& all = lattice.tetrahedra;
  TetrahedraAround around;
  // Counts are shifted by one, so that filling advances each offset to its final value.
  around.begin.assign(lattice.values.size() + 2, 0);
  for (const Tetrahedron& tetrahedron : all) {
    for (const Index point : tetrahedron) ++around.begin[point + 2];
  }
  std::partial_sum(around.begin.begin(), around.begin.end(), around.begin.begin());
  around.tetrahedra.resize(4 * all.size());
  for (std::size_t t = 0; t < all.size(); ++t) {
    for (const Index point : all[t]) {
      around.tetrahedra[around.begin[point + 1]++] = static_cast<Index>(t);
    }
  }
  around.begin.pop_back();
  return around;
}

/// Snapped lattice points and their positions.
class SnappedPoints {
 public:
  explicit SnappedPoints(std::size_t points) : number_(points, kNone) {}

  bool has(Index point) const { return number_[point] != kNone; }
  const Point& place(Index point) const { return places_[number_[point]]; }
  void move(Index point, const Point& place) {
    number_[point] = static_cast<Index>(places_.size());
    places_.push_back(place);
  }

 private:
  std::vector<Index> number_;  ///< of positions; kNone: not snapped
  std::vector<Point> places_;
};

/// Snaps lattice points that are close to a crossing on one of their edges.
SnappedPoints snap(const Lattice& lattice, double cell, const Progress& progress) {
  struct Candidate {
    double distance;
    Index point, other;
  };
  std::vector<Candidate> candidates;
  const auto add_candidate = [&](Index a, Index b) {
    const double distance = (crossing(lattice, a, b) - lattice.position(a)).norm();
    const double length = (lattice.position(a) - lattice.position(b)).norm();
    // The limits of Labelle and Shewchuk for axis-parallel and diagonal edges.
    const double limit = (length > 0.9 * cell ? 0.249 : 0.412) * length;
    if (distance < limit) candidates.push_back({distance, a, b});
  };
  EdgeList edges(lattice.values.size());
  for (std::size_t number = 0; number < lattice.tetrahedra.size(); ++number) {
    if (number % kReportSlice == 0) progress.tick();
    const Tetrahedron& t = lattice.tetrahedra[number];
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const Index a = t[i], b = t[j];
        if ((lattice.values[a] < 0) == (lattice.values[b] < 0)) continue;
        if (!edges.try_emplace(a, b).second) continue;
        add_candidate(a, b);
        add_candidate(b, a);
      }
    }
  }
  ticking_sort(
      candidates.begin(), candidates.end(), progress, [](const Candidate& x, const Candidate& y) {
        return std::tie(x.distance, x.point, x.other) < std::tie(y.distance, y.point, y.other);
      });
  const TetrahedraAround around = tetrahedra_around(lattice);
  std::vector<int> snapped_corners(lattice.tetrahedra.size(), 0);
  SnappedPoints snapped(lattice.values.size());
  for (std::size_t number = 0; number < candidates.size(); ++number) {
    if (number % kReportSlice == 0) progress.tick();
    const Index point = candidates[number].point, other = candidates[number].other;
    if (snapped.has(point) || snapped.has(other)) continue;
    // A tetrahedron whose corners are all on the surface is neither inside nor outside.
    const auto flat = [&](Index t) { return snapped_corners[t] == 3; };
    const std::span<const Index> at = around.of(point);
    if (std::any_of(at.begin(), at.end(), flat)) continue;
    snapped.move(point, crossing(lattice, point, other));
    for (const Index t : at) ++snapped_corners[t];
  }
  return snapped;
}

/// Triangulates the crossed tetrahedra of a lattice.
class Polygonizer {
 public:
  Polygonizer(const Lattice& lattice, const SnappedPoints& snapped, const Progress& progress)
      : lattice_(lattice),
        snapped_(snapped),
        vertex_of_point_(lattice.values.size(), kNone),
        edges_(lattice.values.size()) {
    for (std::size_t t = 0; t < lattice.tetrahedra.size(); ++t) {
      if (t % kReportSlice == 0) progress.tick();
      add(lattice.tetrahedra[t]);
    }
    for (const MadeTriangle& triangle : triangles_) {
      if (triangle.stays) mesh.triangles.push_back(triangle.corners);
    }
  }

  Mesh mesh;

 private:
  /// Faces of the lattice, in lists per lowest corner.
  struct MadeTriangle {
    Triangle corners;
    bool stays;
    Index next_face;
  };

  /// A vertex of the surface within a tetrahedron, and its position on the unsnapped lattice.
  struct Node {
    Index vertex;
    Point regular;
  };

  void add(const Tetrahedron& t) {
    std::vector<Index> inside, outside, on;
    for (const Index p : t) {
      (snapped_.has(p) ? on : lattice_.values[p] < 0 ? inside : outside).push_back(p);
    }
    std::vector<Node> nodes;
    for (const Index p : on) nodes.push_back(node_on(p));
    if (inside.size() == 2 && outside.size() == 2) {
      nodes = {node_between(inside[0], outside[0]), node_between(inside[0], outside[1]),
               node_between(inside[1], outside[1]), node_between(inside[1], outside[0])};
    } else {
      for (const Index a : inside) {
        for (const Index b : outside) nodes.push_back(node_between(a, b));
      }
    }
    if (nodes.size() < 3 || inside.size() + outside.size() == 0) return;
    // A point outside the triangles.
    const bool known_outside = !outside.empty();
    const Point side = lattice_.position(known_outside ? outside[0] : inside[0]);
    if (nodes.size() == 3) {
      add_triangle(nodes[0], nodes[1], nodes[2], side, known_outside, on.size() == 3);
    } else if (nodes.size() == 4) {
      add_quad(nodes, side);
    }
  }

  void add_quad(const std::vector<Node>& n, const Point& outer) {
    const auto distance = [&](int a, int b) {
      return (mesh.positions[n[a].vertex] - mesh.positions[n[b].vertex]).norm();
    };
    if (distance(0, 2) <= distance(1, 3)) {
      add_triangle(n[0], n[1], n[2], outer, true);
      add_triangle(n[0], n[2], n[3], outer, true);
    } else {
      add_triangle(n[0], n[1], n[3], outer, true);
      add_triangle(n[1], n[2], n[3], outer, true);
    }
  }

  /// Winds the triangle so that `side` is outside, or inside. It is a face of the lattice if all
  /// corners were snapped.
  void add_triangle(const Node& a, const Node& b, const Node& c, const Point& side, bool outer,
                    bool is_face = false) {
    Triangle t = {a.vertex, b.vertex, c.vertex};
    const Point normal = (b.regular - a.regular).cross(c.regular - a.regular);
    if ((normal.dot(side - a.regular) > 0) != outer) std::swap(t[1], t[2]);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    if (!is_face) {
      triangles_.push_back({t, true, kNone});
      return;
    }
    // Both sides add a face; it is kept, once, only if one side is inside and the other outside.
    if (MadeTriangle* reversed = face({t[0], t[2], t[1]})) {
      reversed->stays = false;
    } else if (!face(t)) {
      const auto added = static_cast<Index>(triangles_.size());
      triangles_.push_back({t, true, std::exchange(first_face_[t[0]], added)});
    }
  }

  /// The face with these corners; null if there is none.
  MadeTriangle* face(const Triangle& corners) {
    for (Index t = first_face_[corners[0]]; t != kNone; t = triangles_[t].next_face) {
      if (triangles_[t].corners == corners) return &triangles_[t];
    }
    return nullptr;
  }

  Node node_on(Index point) {
    Index& vertex = vertex_of_point_[point];
    if (vertex == kNone) vertex = add_vertex(snapped_.place(point));
    return {vertex, lattice_.position(point)};
  }

  Node node_between(Index a, Index b) {
    const auto [edge, added] = edges_.try_emplace(a, b);
    if (added) vertex_of_edge_.push_back(add_vertex(crossing(lattice_, a, b)));
    return {vertex_of_edge_[edge], 0.5 * (lattice_.position(a) + lattice_.position(b))};
  }

  Index add_vertex(const Point& position) {
    mesh.positions.push_back(position.cast<float>());
    first_face_.push_back(kNone);
    return static_cast<Index>(mesh.positions.size() - 1);
  }

  const Lattice& lattice_;
  const SnappedPoints& snapped_;
  std::vector<Index> vertex_of_point_;
  EdgeList edges_;
  std::vector<Index> vertex_of_edge_;
  std::vector<Index> first_face_;  ///< of faces with this lowest corner
  std::vector<MadeTriangle> triangles_;
};

/// Removes vertices without triangles.
void drop_unused_vertices(Mesh& mesh) {
  std::vector<Index> number(mesh.vertex_count(), ~Index{0});
  std::vector<Vec3> positions;
  for (Triangle& triangle : mesh.triangles) {
    for (Index& v : triangle) {
      if (number[v] == ~Index{0}) {
        number[v] = static_cast<Index>(positions.size());
        positions.push_back(mesh.positions[v]);
      }
      v = number[v];
    }
  }
  mesh.positions = std::move(positions);
}

/// Forward differences, because evaluations are expensive; `value` is the function at `at`.
Point gradient(const ImplicitFunction& function, const Point& at, double value, double step) {
  Point result;
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = (function(at + step * Point::Unit(axis)) - value) / step;
  }
  return result;
}

/// Newton steps along the gradient, of at most `reach` each.
Point project(const ImplicitFunction& function, Point at, double reach, int steps) {
  for (int i = 0; i < steps; ++i) {
    const double value = function(at);
    const Point slope = gradient(function, at, value, 1e-4 * reach);
    Point move = -value / std::max(slope.squaredNorm(), 1e-6) * slope;
    if (move.norm() > reach) move *= reach / move.norm();
    at += move;
  }
  return at;
}

/// The mean of the centroids of the triangles around a vertex, weighted by area.
Point balance_point(const Mesh& mesh, std::span<const Index> around) {
  Point sum = Point::Zero();
  double total = 0;
  for (const Index t : around) {
    const auto& [i, j, k] = mesh.triangles[t];
    const Point a = mesh.positions[i].cast<double>();
    const Point b = mesh.positions[j].cast<double>(), c = mesh.positions[k].cast<double>();
    const double area = (b - a).cross(c - a).norm();
    sum += area * (a + b + c) / 3;
    total += area;
  }
  return total > 0 ? Point(sum / total) : sum;
}

void relax(const ImplicitFunction& function, Mesh& mesh, double edge_length, int steps,
           const Progress& progress) {
  const VertexTriangles around = vertex_triangles(mesh);
  std::vector<Vec3> moved(mesh.vertex_count());
  parallel_for(
      mesh.vertex_count(), progress,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          const Point at = balance_point(mesh, around.of(v));
          moved[v] = project(function, at, 0.5 * edge_length, steps).cast<float>();
        }
      },
      256, kMovedPerReport);
  mesh.positions = std::move(moved);
}

Mesh polygonize(const Lattice& lattice, const SnappedPoints& snapped, const Progress& progress) {
  Mesh mesh = std::move(Polygonizer(lattice, snapped, progress).mesh);
  drop_unused_vertices(mesh);
  return mesh;
}

/// The number of cells of a coarse grid that the surface crosses, within `reach` of their centres.
std::size_t cells_near(const ImplicitFunction& function, const Point& lower, const Point& size,
                       int most) {
  const Point middle = lower + 0.5 * size;
  if (std::abs(function(middle)) > 0.5 * size.norm()) return 0;
  if (most == 0) return 1;
  int axis = 0;
  size.maxCoeff(&axis);
  Point half = size, upper = lower;
  half[axis] *= 0.5;
  upper[axis] += half[axis];
  return cells_near(function, lower, half, most - 1) + cells_near(function, upper, half, most - 1);
}

/// Rejects surfaces beyond the memory limit. Their area is estimated from cells of a coarse grid
/// near the surface.
void check_room(const ImplicitFunction& function, const BoundingBox& box, float edge_length) {
  constexpr int kHalvings = 12;
  // Measured on built-in shapes; the estimate is right within a factor of two.
  constexpr double kVerticesPerFace = 0.6;  ///< of a cell near the surface
  constexpr double kBytesPerVertex = 560;   ///< including the lattice
  const Point size = (box.upper - box.lower).cast<double>();
  const auto near =
      static_cast<double>(cells_near(function, box.lower.cast<double>(), size, kHalvings));
  const double cell = std::cbrt(size.prod() / (1 << kHalvings));
  const double vertices = near * kVerticesPerFace * std::pow(cell / edge_length, 2);
  check_fits(vertices, kBytesPerVertex, "the surface", "vertices", [&](double most) {
    const double longest = edge_length * std::sqrt(vertices / most);
    return "edges of length " + rounded_up(longest) + " would do";
  });
}

Eigen::Vector3d position_at(const Mesh& mesh, Index half_edge) {
  return mesh.positions[vertex_at(mesh.triangles, half_edge)].cast<double>();
}

/// The cotangent of the angle opposite a half-edge.
double opposite_cotangent(const Mesh& mesh, Index h) {
  const Eigen::Vector3d apex = position_at(mesh, previous_in_triangle(h));
  const Eigen::Vector3d a = position_at(mesh, h) - apex;
  const Eigen::Vector3d b = position_at(mesh, next_in_triangle(h)) - apex;
  return a.dot(b) / std::max(a.cross(b).norm(), 1e-30);
}

/// Whether an edge connects the origin of `h` with vertex `to`.
bool has_edge(const Mesh& mesh, const std::vector<Index>& twins, Index h, Index to) {
  const Index start = h;
  do {
    if (vertex_at(mesh.triangles, next_in_triangle(h)) == to) return true;
    h = twins[previous_in_triangle(h)];
  } while (h != start);
  return false;
}

/// Whether the flipped triangles face the same side as the old ones.
bool flip_keeps_side(const Mesh& mesh, const Triangle& one, const Triangle& other, Index h,
                     Index twin) {
  const Vec3 old = triangle_normal(mesh, mesh.triangles[h / 3]) +
                   triangle_normal(mesh, mesh.triangles[twin / 3]);
  return triangle_normal(mesh, one).dot(old) > 0.2f && triangle_normal(mesh, other).dot(old) > 0.2f;
}

/// Flips the edge if that is valid; returns whether it did.
bool flip(Mesh& mesh, std::vector<Index>& twins, Index h) {
  const Index t = twins[h];
  const Index h_next = next_in_triangle(h), h_previous = previous_in_triangle(h);
  const Index t_next = next_in_triangle(t), t_previous = previous_in_triangle(t);
  const Index a = vertex_at(mesh.triangles, h), b = vertex_at(mesh.triangles, t);
  const Index c = vertex_at(mesh.triangles, h_previous), d = vertex_at(mesh.triangles, t_previous);
  const Triangle one = {c, a, d}, other = {d, b, c};
  if (c == d || has_edge(mesh, twins, h_previous, d)) return false;
  if (!flip_keeps_side(mesh, one, other, h, t)) return false;
  const std::array<Index, 4> outside = {twins[h_previous], twins[t_next], twins[t_previous],
                                        twins[h_next]};
  const Index first = 3 * (h / 3), second = 3 * (t / 3);
  mesh.triangles[h / 3] = one;
  mesh.triangles[t / 3] = other;
  const std::array<std::pair<Index, Index>, 5> pairs = {{{first, outside[0]},
                                                         {first + 1, outside[1]},
                                                         {second, outside[2]},
                                                         {second + 1, outside[3]},
                                                         {first + 2, second + 2}}};
  for (const auto& [inner, outer] : pairs) {
    twins[inner] = outer;
    twins[outer] = inner;
  }
  return true;
}

/// Flips edges until each is locally Delaunay (opposite angles of at most 180 degrees in total),
/// for at most `rounds` passes. Skips flips that would duplicate an edge or fold the surface.
/// Maintains `twins`, those of the mesh (`manifold_twins`). Exceptions of `progress` leave some
/// edges flipped.
void flip_to_delaunay(Mesh& mesh, std::vector<Index>& twins, int rounds, const Progress& progress) {
  // The cotangents add up to less than 0 if the angles exceed 180 degrees in total. The margin
  // avoids cycles of flips for cocircular corners.
  constexpr double kLimit = -1e-3;
  for (int round = 0; round < rounds; ++round) {
    bool flipped = false;
    for (Index h = 0; h < twins.size(); ++h) {
      if (h % kReportSlice == 0) progress.tick();
      const Index twin = twins[h];
      if (h < twin && opposite_cotangent(mesh, h) + opposite_cotangent(mesh, twin) < kLimit) {
        flipped = flip(mesh, twins, h) || flipped;
      }
    }
    if (!flipped) return;
  }
}

}  // namespace

Mesh isosurface(const ImplicitFunction& function, const BoundingBox& box, float edge_length,
                const Progress& progress) {
  const double cell = kCellPerEdge * edge_length;
  const double extent = (box.upper - box.lower).maxCoeff();
  if (!(edge_length > 0) || !(extent / cell < kMaxCells)) {
    throw Error("edges of length " + std::to_string(edge_length) +
                " are too short for an implicit surface of size " + std::to_string(extent) +
                "; lower the resolution");
  }
  check_room(function, box, edge_length);
  Mesh mesh;
  std::optional<std::vector<Index>> twins;
  {
    const Lattice lattice(function, box, cell, progress.part(0, 0.2));
    const SnappedPoints snapped = snap(lattice, cell, progress);
    progress.report(0.28);
    mesh = polygonize(lattice, snapped, progress);
    progress.report(0.36);
    twins = manifold_twins(mesh);
    progress.report(0.44);
    if (!twins) {
      // Snapping may pinch parts hardly thicker than a cell, so repeat without snapping.
      mesh = polygonize(lattice, SnappedPoints(lattice.values.size()), progress);
      twins = manifold_twins(mesh);
    }
  }
  if (!twins) throw Error("the implicit surface leaves its box; enlarge the box");
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    const Progress of_round =
        progress.part(0.5 + 0.5 * round / kRounds, 0.5 + 0.5 * (round + 1) / kRounds);
    of_round.report(0);
    flip_to_delaunay(mesh, *twins, 3, of_round);
    relax(function, mesh, edge_length, round + 1 < kRounds ? 1 : 3, of_round);
  }
  return mesh;
}

}  // namespace brindle
