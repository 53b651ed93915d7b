#include "brindle/direction_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"

namespace brindle {
namespace {

/// A vector closer to the normal than this (as a sine) has no direction in the tangent plane.
constexpr float kParallelToNormal = 1e-4f;

}  // namespace

Vec3 tangent_direction(const Vec3& vector, const Vec3& normal) {
  float length = vector.norm();
  // Squares may be out of the range of float although the vector is not.
  if (!(length > 0) || !std::isfinite(length)) length = vector.stableNorm();
  if (!(length > 0) || !std::isfinite(length) || normal.isZero(0)) return Vec3::Zero();
  const Vec3 unit = vector / length;
  const Vec3 tangent = unit - unit.dot(normal) * normal;
  const float sine = tangent.norm();
  if (!(sine > kParallelToNormal)) return Vec3::Zero();
  return tangent / sine;
}

DirectionField tangent_directions(std::span<const Vec3> vectors, std::span<const Vec3> normals) {
  DirectionField directions(vectors.size());
  parallel_for(vectors.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      directions[i] = tangent_direction(vectors[i], normals[i]);
    }
  });
  return directions;
}

DirectionField projected_direction_field(const Vec3& axis, std::span<const Vec3> normals) {
  if (!axis.allFinite() || axis.isZero(0)) {
    throw Error("the direction must be a finite vector other than 0,0,0");
  }
  return tangent_directions(std::vector<Vec3>(normals.size(), axis), normals);
}

DirectionField curvature_direction_field(std::span<const PrincipalCurvature> curvatures,
                                         CurvatureDirection direction) {
  DirectionField directions(curvatures.size());
  for (std::size_t i = 0; i < curvatures.size(); ++i) {
    directions[i] = direction == CurvatureDirection::maximum ? curvatures[i].maximum_direction
                                                             : curvatures[i].minimum_direction;
  }
  return directions;
}

DirectionField rotated(std::span<const Vec3> directions, std::span<const Vec3> normals,
                       float radians) {
  const float cosine = elementary::cos(radians), sine = elementary::sin(radians);
  DirectionField turned(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    turned[i] = cosine * directions[i] + sine * normals[i].cross(directions[i]);
  }
  return turned;
}

namespace {

/// The cosine of N times the angle between two vectors: Chebyshev's polynomial of its cosine.
float cosine_of_multiple(const Vec3& a, const Vec3& b, int symmetry) {
  const float lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  const float cosine = lengths > 0 ? a.dot(b) / lengths : 1;
  float last = 1, now = cosine;
  for (int n = 1; n < symmetry; ++n) {
    const float next = 2 * cosine * now - last;
    last = now;
    now = next;
  }
  return now;
}

/// The angle from one vector to another about a unit normal.
float angle_between(const Vec3& from, const Vec3& to, const Vec3& normal) {
  return elementary::atan2(normal.dot(from.cross(to)), from.dot(to));
}

}  // namespace

int field_index(const Vec3& normal, const std::array<Vec3, 3>& directions, int symmetry) {
  const Vec3 n = normal.stableNormalized();
  std::array<Vec3, 3> flat;
  for (int m = 0; m < 3; ++m) flat[m] = directions[m] - directions[m].dot(n) * n;
  // Three angles add up to a whole turn only if one is at least a third of it.
  const auto is_small = [&](int m) {
    return cosine_of_multiple(flat[m], flat[(m + 1) % 3], symmetry) > 0;
  };
  if (is_small(0) && is_small(1) && is_small(2)) return 0;
  const float turn = 2 * std::numbers::pi_v<float> / static_cast<float>(symmetry);
  float sum = 0;
  for (int m = 0; m < 3; ++m) {
    sum += std::remainder(angle_between(flat[m], flat[(m + 1) % 3], n), turn);
  }
  return static_cast<int>(std::lround(sum / turn));
}

namespace {

/// The index of a triangle; 0 if a corner has no direction.
int index_of(const Mesh& mesh, std::size_t triangle, std::span<const Vec3> directions,
             int symmetry) {
  const Triangle& corners = mesh.triangles[triangle];
  const std::array<Vec3, 3> d = {directions[corners[0]], directions[corners[1]],
                                 directions[corners[2]]};
  if (ranges::any_of(d, [](const Vec3& v) { return v.isZero(0); })) return 0;
  const Vec3& a = mesh.positions[corners[0]];
  const Vec3 normal = (mesh.positions[corners[1]] - a).cross(mesh.positions[corners[2]] - a);
  return field_index(normal, d, symmetry);
}

}  // namespace

std::vector<SingularTriangle> singular_triangles(const Mesh& mesh, std::span<const Vec3> directions,
                                                 int symmetry) {
  std::vector<int> indices(mesh.triangle_count());
  parallel_for(indices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) indices[t] = index_of(mesh, t, directions, symmetry);
  });
  std::vector<SingularTriangle> singular;
  for (Index t = 0; t < indices.size(); ++t) {
    if (indices[t] != 0) singular.push_back({t, indices[t]});
  }
  return singular;
}

std::size_t count_singularities(const Mesh& mesh, std::span<const Vec3> directions, int symmetry) {
  return singular_triangles(mesh, directions, symmetry).size();
}

namespace {

enum class Visit : std::uint8_t { not_yet, queued, done };

/// Visits vertices breadth-first.
class OrientationWalk {
 public:
  /// `creased` is the surface if neighbours may be on two sides of a crease, else null.
  OrientationWalk(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress, const Surface* creased = nullptr)
      : neighborhood_(neighborhood),
        creased_(creased),
        directions_(directions),
        progress_(progress),
        visits_(directions.size(), Visit::not_yet) {
    queue_.reserve(directions.size());
  }

  void settle(Index vertex) { visits_[vertex] = Visit::done; }

  void enter(Index vertex) {
    if (visits_[vertex] != Visit::not_yet) return;
    visits_[vertex] = Visit::queued;
    queue_.push_back(vertex);
  }

  void enter_neighbors(Index vertex) {
    for (const Index neighbor : neighborhood_.of(vertex)) {
      // Vertices without a wave propagate no sign.
      if (!directions_[neighbor].isZero(0)) enter(neighbor);
    }
  }

  void run() {
    for (; next_ < queue_.size(); ++next_) {
      if (next_ % kReportSlice == 0) progress_.tick();
      const Index vertex = queue_[next_];
      if (runs_against_neighbors(vertex)) {
        directions_[vertex] = -directions_[vertex];
      }
      visits_[vertex] = Visit::done;
      enter_neighbors(vertex);
    }
  }

 private:
  float agreement(Index i, Index j) const {
    if (creased_ == nullptr || creased_->mesh.positions[i] != creased_->mesh.positions[j]) {
      return directions_[i].dot(directions_[j]);
    }
    return cosine_across(directions_[j], creased_->normals[j], directions_[i],
                         creased_->normals[i]);
  }

  /// Decides by the sum of signed cosines to the neighbours that are done.
  bool runs_against_neighbors(Index vertex) const {
    float sum = 0;
    for (const Index neighbor : neighborhood_.of(vertex)) {
      if (visits_[neighbor] == Visit::done) sum += agreement(vertex, neighbor);
    }
    return sum < 0;
  }

  const Adjacency& neighborhood_;
  const Surface* creased_;
  std::span<Vec3> directions_;
  const Progress& progress_;
  std::vector<Visit> visits_;
  std::vector<Index> queue_;
  std::size_t next_ = 0;
};

/// Starts at the first vertex of every component not yet reached.
void walk_all(OrientationWalk& walk, std::size_t count) {
  for (Index start = 0; start < count; ++start) {
    walk.enter(start);
    walk.run();
  }
}

}  // namespace

void orient_alike(const Adjacency& neighborhood, std::span<Vec3> directions,
                  const Progress& progress) {
  OrientationWalk walk(neighborhood, directions, progress);
  walk_all(walk, directions.size());
}

void orient_alike(const Surface& surface, std::span<Vec3> directions, const Progress& progress) {
  const auto neighbors = neighbors_over_creases(surface);
  OrientationWalk walk(*neighbors, directions, progress,
                       surface.creases.empty() ? nullptr : &surface);
  walk_all(walk, directions.size());
}

void orient_alike(const Adjacency& neighborhood, std::span<const std::uint8_t> settled,
                  std::span<Vec3> directions) {
  const Progress silent;
  OrientationWalk walk(neighborhood, directions, silent);
  for (Index vertex = 0; vertex < settled.size(); ++vertex) {
    if (settled[vertex] != 0) walk.settle(vertex);
  }
  for (Index vertex = 0; vertex < settled.size(); ++vertex) {
    if (settled[vertex] != 0 && !directions[vertex].isZero(0)) walk.enter_neighbors(vertex);
  }
  walk.run();
  walk_all(walk, directions.size());
}

void orient_like(std::span<const Vec3> reference, std::span<Vec3> directions) {
  parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (directions[i].dot(reference[i]) < 0) directions[i] = -directions[i];
    }
  });
}

}  // namespace brindle
