#include "brindle/normals.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/normals_around.h"

namespace brindle {
namespace {

/// Contribution of an adjacent triangle to a vertex normal.
struct Corner {
  Vec3 normal;
  float angle;  ///< radians, at the vertex
  Index next;   ///< the other corners, in the triangle's winding
  Index previous;
};

/// Zero only for the zero vector; Eigen's `normalized` may lose tiny vectors.
Vec3 unit(const Vec3& v) {
  const double length = v.cast<double>().norm();
  return length > 0 ? (v.cast<double>() / length).cast<float>().eval() : Vec3::Zero();
}

/// Area vector: the normal times twice the area.
Eigen::Vector3d doubled_area(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c) {
  return (b - a).cross(c - a);
}

/// atan2(y, x) for y >= 0 and not both zero, exact to the last digit or two: Cephes' atan, inlined.
double angle_of(double y, double x) {
  using std::numbers::pi;
  const double width = std::abs(x);
  const bool is_steep = y > width;
  const double small = is_steep ? width : y, large = is_steep ? y : width;
  const bool is_diagonal = small > 0.66 * large;
  const double t = (is_diagonal ? small - large : small) / (is_diagonal ? small + large : large);
  const double z = t * t;
  const double p = (((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z -
                     7.500855792314704667340e1) *
                        z -
                    1.228866684490136173410e2) *
                       z -
                   6.485021904942025371773e1;
  const double q = ((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
                     4.328810604912902668951e2) *
                        z +
                    4.853903996359136964868e2) *
                       z +
                   1.945506571482613964425e2;
  double angle = t + t * (z * p / q);
  if (is_diagonal) angle += pi / 4;
  if (is_steep) angle = pi / 2 - angle;
  return x < 0 ? pi - angle : angle;
}

TriangleAngles angles_of(const Mesh& mesh, const Triangle& triangle) {
  std::array<Eigen::Vector3d, 3> p, edge;
  for (int c = 0; c < 3; ++c) p[c] = mesh.positions[triangle[c]].cast<double>();
  for (int c = 0; c < 3; ++c) edge[c] = p[(c + 1) % 3] - p[c];
  const Eigen::Vector3d cross = doubled_area(p[0], p[1], p[2]);
  const double area = cross.norm();
  if (!(area > 0)) return {Vec3::Zero(), {}};
  TriangleAngles result{(cross / area).cast<float>(), {}};
  for (int c = 0; c < 3; ++c) {
    result.angle[c] = static_cast<float>(angle_of(area, -edge[c].dot(edge[(c + 2) % 3])));
  }
  return result;
}

Corner corner_at(const Triangle& triangle, const TriangleAngles& angles, Index vertex,
                 bool is_turned) {
  const int c = corner_of(triangle, vertex);
  const Index next = triangle[(c + 1) % 3], previous = triangle[(c + 2) % 3];
  if (is_turned) return {-angles.normal, angles.angle[c], previous, next};
  return {angles.normal, angles.angle[c], next, previous};
}

bool has_repetition(std::vector<Index>& numbers) {
  constexpr std::size_t kFew = 12;
  if (numbers.size() > kFew) {
    ranges::sort(numbers.begin(), numbers.end());
    return std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end();
  }
  bool repeated = false;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) repeated |= numbers[i] == numbers[j];
  }
  return repeated;
}

/// Whether two triangles traverse a common edge in the same direction: they have opposite winding,
/// or the edge has more than two triangles.
bool winding_conflicts(const std::vector<Corner>& corners) {
  thread_local std::vector<Index> ends;
  for (const auto end : {&Corner::next, &Corner::previous}) {
    ends.clear();
    for (const Corner& corner : corners) ends.push_back(corner.*end);
    if (has_repetition(ends)) return true;
  }
  return false;
}

/// The unit vector n with the largest sum of angle |<normal, n>| among the averages that result
/// from aligning all normals to one of them.
Vec3 unsigned_average(const std::vector<Corner>& corners) {
  Vec3 best = Vec3::Zero();
  float best_agreement = 0;
  // Bounds the work at vertices with thousands of triangles.
  const std::size_t references = std::min<std::size_t>(corners.size(), 64);
  for (std::size_t r = 0; r < references; ++r) {
    const Corner& reference = corners[r];
    Vec3 sum = Vec3::Zero();
    for (const Corner& corner : corners) {
      const float sign = corner.normal.dot(reference.normal) < 0 ? -1.0f : 1.0f;
      sum += sign * corner.angle * corner.normal;
    }
    const Vec3 candidate = unit(sum);
    float agreement = 0;
    for (const Corner& corner : corners) {
      agreement += corner.angle * std::abs(corner.normal.dot(candidate));
    }
    // Ties within rounding keep the first reference, for any order of additions.
    if (agreement > best_agreement * 1.0001f) {
      best = candidate;
      best_agreement = agreement;
    }
  }
  return best;
}

Vec3 mean_normal(const std::vector<Corner>& corners) {
  Vec3 sum = Vec3::Zero();
  for (const Corner& corner : corners) sum += corner.angle * corner.normal;
  return unit(sum);
}

}  // namespace

Vec3 triangle_normal(const Mesh& mesh, const Triangle& triangle) {
  const auto at = [&](int c) -> Eigen::Vector3d {
    return mesh.positions[triangle[c]].cast<double>();
  };
  const Eigen::Vector3d cross = doubled_area(at(0), at(1), at(2));
  const double area = cross.norm();
  if (!(area > 0)) return Vec3::Zero();
  return (cross / area).cast<float>();
}

std::vector<Vec3> vertex_normals(const Mesh& mesh) {
  return vertex_normals(mesh, vertex_triangles(mesh));
}

std::vector<Vec3> vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                                 const Progress& progress) {
  std::vector<TriangleAngles> angles;
  std::vector<Vec3> normals;
  if (!fill_vertex_normals(mesh, around, {}, angles, normals, progress)) return normals;
  const std::vector<std::uint8_t> turned = triangles_to_turn(mesh, around);
  if (!turned.empty()) fill_vertex_normals(mesh, around, turned, angles, normals, progress);
  return normals;
}

bool fill_vertex_normals(const Mesh& mesh, const VertexTriangles& around,
                         std::span<const std::uint8_t> turned, std::vector<TriangleAngles>& angles,
                         std::vector<Vec3>& normals, const Progress& progress) {
  angles.resize(mesh.triangle_count());
  parallel_for(angles.size(), progress.part(0, 0.5), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) angles[t] = angles_of(mesh, mesh.triangles[t]);
  });
  normals.resize(mesh.vertex_count());
  std::atomic<bool> any_conflict = false;
  parallel_for(mesh.vertex_count(), progress.part(0.5, 1), [&](std::size_t begin, std::size_t end) {
    thread_local std::vector<Corner> corners;
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      corners.clear();
      for (const Index t : around.of(v)) {
        const bool is_turned = !turned.empty() && turned[t] != 0;
        corners.push_back(corner_at(mesh.triangles[t], angles[t], v, is_turned));
      }
      const bool conflict = winding_conflicts(corners);
      if (conflict) any_conflict.store(true, std::memory_order_relaxed);
      normals[v] = conflict ? unsigned_average(corners) : mean_normal(corners);
    }
  });
  return any_conflict;
}

namespace {

struct WoundNeighbor {
  Index triangle;
  bool against;  ///< of opposite winding: both traverse the edge in the same direction
};

/// The only triangle along an edge from `a` to `b` besides `t`, which traverses it in this order.
std::optional<WoundNeighbor> neighbor_along(const Mesh& mesh, const VertexTriangles& around,
                                            Index t, Index a, Index b) {
  std::optional<WoundNeighbor> found;
  for (const Index other : around.of(a)) {
    if (other == t) continue;
    const Triangle& triangle = mesh.triangles[other];
    const int c = corner_of(triangle, a);
    const bool leaves = triangle[(c + 1) % 3] == b;
    if (!leaves && triangle[(c + 2) % 3] != b) continue;
    if (found) return std::nullopt;
    found = WoundNeighbor{other, leaves};
  }
  return found;
}

/// Walks components and marks triangles against their first one.
class WindingWalk {
 public:
  WindingWalk(const Mesh& mesh, const VertexTriangles& around,
              std::span<const CreaseNeighbors> links)
      : mesh_(mesh), around_(around), turned_(mesh.triangle_count(), kUnseen) {
    const auto add_all = [&](const auto& add) {
      for (const CreaseNeighbors& link : links) {
        add(link.first, {link.second, link.against});
        add(link.second, {link.first, link.against});
      }
    };
    if (!links.empty()) links_ = compressed_rows<WoundNeighbor>(turned_.size(), add_all);
  }

  std::vector<std::uint8_t> turned() {
    for (Index start = 0; start < turned_.size(); ++start) {
      if (turned_[start] == kUnseen) turn_component(start);
    }
    const bool any = ranges::find(turned_, std::uint8_t{1}) != turned_.end();
    return any ? std::move(turned_) : std::vector<std::uint8_t>();
  }

 private:
  static constexpr std::uint8_t kUnseen = 2;

  void turn_component(Index start) {
    component_.assign(1, start);
    turned_[start] = 0;
    orientable_ = closed_ = true;
    for (std::size_t next = 0; next < component_.size(); ++next) visit_neighbors(component_[next]);
    std::size_t against = 0;
    for (const Index t : component_) against += turned_[t];
    if (!orientable_ || against == 0) return stay();
    const double volume = closed_ ? six_volumes() : 0;
    const bool reversed = volume != 0 ? volume < 0 : 2 * against > component_.size();
    for (const Index t : component_) turned_[t] ^= reversed ? 1 : 0;
  }

  void stay() {
    for (const Index t : component_) turned_[t] = 0;
  }

  /// Six times the volume within the component after turning; positive if it is wound outwards.
  double six_volumes() const {
    const Vec3& origin = mesh_.positions[mesh_.triangles[component_[0]][0]];
    double sum = 0;
    for (const Index t : component_) {
      std::array<Eigen::Vector3d, 3> p;
      for (std::size_t c = 0; c < 3; ++c) {
        p[c] = (mesh_.positions[mesh_.triangles[t][c]] - origin).cast<double>();
      }
      sum += (turned_[t] != 0 ? -1 : 1) * p[0].dot(p[1].cross(p[2]));
    }
    return sum;
  }

  void visit_neighbors(Index t) {
    const Triangle& triangle = mesh_.triangles[t];
    for (int m = 0; m < 3; ++m) {
      const Index a = triangle[m], b = triangle[(m + 1) % 3];
      if (a == b) continue;
      const auto found = neighbor_along(mesh_, around_, t, a, b);
      if (found) reach(t, *found);
      closed_ = closed_ && found;
    }
    if (links_.entries.empty()) return;
    for (const WoundNeighbor& neighbor : links_.of(t)) reach(t, neighbor);
  }

  void reach(Index from, const WoundNeighbor& to) {
    const std::uint8_t turned = turned_[from] ^ (to.against ? 1 : 0);
    if (turned_[to.triangle] == kUnseen) {
      turned_[to.triangle] = turned;
      component_.push_back(to.triangle);
    } else if (turned_[to.triangle] != turned) {
      orientable_ = false;
    }
  }

  const Mesh& mesh_;
  const VertexTriangles& around_;
  CompressedRows<WoundNeighbor> links_;
  std::vector<std::uint8_t> turned_;
  std::vector<Index> component_;
  bool orientable_ = true, closed_ = true;
};

}  // namespace

std::vector<CreaseNeighbors> triangles_over_creases(const Mesh& mesh, const VertexTriangles& around,
                                                    const Creases& creases) {
  std::vector<CreaseNeighbors> links;
  for (const auto& [first, second] : creases.edges) {
    const auto a = neighbor_along(mesh, around, kNoTriangle, first[0], first[1]);
    const auto b = neighbor_along(mesh, around, kNoTriangle, second[0], second[1]);
    if (!a || !b || a->triangle == b->triangle) continue;
    links.push_back({a->triangle, b->triangle, a->against == b->against});
  }
  return links;
}

std::vector<std::uint8_t> triangles_to_turn(const Mesh& mesh, const VertexTriangles& around,
                                            std::span<const CreaseNeighbors> links) {
  return WindingWalk(mesh, around, links).turned();
}

namespace {

/// Two unit vectors that span the plane orthogonal to `normal`.
std::pair<Eigen::Vector3d, Eigen::Vector3d> tangent_basis(const Eigen::Vector3d& normal) {
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  const Eigen::Vector3d first = normal.cross(Eigen::Vector3d::Unit(axis)).normalized();
  return {first, normal.cross(first)};
}

/// The symmetric shape operator ((a, b), (b, c)) in a tangent basis: as (a, b, c), the
/// least-squares solution of S e = dn over the edges e, each scaled to unit length.
struct ShapeOperatorFit {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double weight = 0;

  void add(const Eigen::Vector2d& e, const Eigen::Vector2d& dn) {
    const double w = 1 / e.squaredNorm();
    const double x = e[0], y = e[1];
    matrix +=
        w * Eigen::Matrix3d{{x * x, x * y, 0}, {x * y, x * x + y * y, x * y}, {0, x * y, y * y}};
    right += w * Eigen::Vector3d(x * dn[0], y * dn[0] + x * dn[1], y * dn[1]);
    weight += 1;
  }

  Eigen::Vector3d solve() const {
    // If all edges are collinear, the curvature across them is unknown: 0.
    return (matrix + 1e-9 * weight * Eigen::Matrix3d::Identity()).ldlt().solve(right);
  }
};

PrincipalCurvature principal(const Eigen::Vector3d& shape, const Eigen::Vector3d& first,
                             const Eigen::Vector3d& second) {
  const double mean = 0.5 * (shape[0] + shape[2]), half = 0.5 * (shape[0] - shape[2]);
  const double radius = std::hypot(half, shape[1]);
  const double angle = 0.5 * elementary::atan2(shape[1], half);
  // Along `angle` the curvature is mean + radius, across it mean - radius.
  const Eigen::Vector3d along = elementary::cos(angle) * first + elementary::sin(angle) * second;
  const Eigen::Vector3d across = elementary::cos(angle) * second - elementary::sin(angle) * first;
  PrincipalCurvature result{static_cast<float>(mean + radius), static_cast<float>(mean - radius),
                            along.cast<float>(), across.cast<float>()};
  if (std::abs(mean - radius) > std::abs(mean + radius)) {
    std::swap(result.maximum, result.minimum);
    std::swap(result.maximum_direction, result.minimum_direction);
  }
  return result;
}

PrincipalCurvature curvature_at(std::size_t v, std::span<const Vec3> positions,
                                std::span<const Vec3> normals, const Adjacency& neighborhood) {
  const Eigen::Vector3d normal = normals[v].cast<double>();
  if (normal.isZero()) return {};
  const auto [first, second] = tangent_basis(normal);
  const auto flat = [&, &b1 = first, &b2 = second](const Eigen::Vector3d& x) {
    return Eigen::Vector2d(x.dot(b1), x.dot(b2));
  };
  ShapeOperatorFit fit;
  for (const Index neighbor : neighborhood.of(static_cast<Index>(v))) {
    const Eigen::Vector3d other = normals[neighbor].cast<double>();
    const Eigen::Vector2d e =
        flat(positions[neighbor].cast<double>() - positions[v].cast<double>());
    if (other.isZero() || e.isZero(0)) continue;
    // Neighbours may have opposite winding.
    fit.add(e, flat(normal.dot(other) < 0 ? -other : other));
  }
  if (fit.weight == 0) return {};
  return principal(fit.solve(), first, second);
}

}  // namespace

std::vector<PrincipalCurvature> principal_curvatures(std::span<const Vec3> positions,
                                                     std::span<const Vec3> normals,
                                                     const Adjacency& neighborhood,
                                                     const Progress& progress) {
  JobStages stages(progress, {{"curvature", 1}});
  const Progress stage = stages.begin("curvature");
  std::vector<PrincipalCurvature> curvatures(positions.size());
  parallel_for(positions.size(), stage, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      curvatures[v] = curvature_at(v, positions, normals, neighborhood);
    }
  });
  stages.finish();
  return curvatures;
}

}  // namespace brindle
