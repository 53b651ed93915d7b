// What is drawn hangs together: no specks beside the stripes, also where few triangles carry them.
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/fragment_phase.h"
#include "brindle/frequency_field.h"
#include "brindle/geometry/topology.h"
#include "brindle/shapes.h"
#include "brindle/stripe_pattern.h"

namespace brindle {
namespace {

/// Points of all triangles, `kStepsPerEdge` along every edge, those of shared edges once.
constexpr int kStepsPerEdge = 14;

class Lattice {
 public:
  Lattice(const Surface& surface, const StripePattern& pattern)
      : mesh_(surface.mesh), edges_(mesh_edges(surface.mesh, *surface.neighborhood)) {
    first_of_edges_ = mesh_.vertex_count();
    first_of_triangles_ = first_of_edges_ + edges_.count() * (kStepsPerEdge - 1);
    constexpr std::size_t kInside = (kStepsPerEdge - 1) * (kStepsPerEdge - 2) / 2;
    const std::size_t count = first_of_triangles_ + mesh_.triangle_count() * kInside;
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    striped_.resize(count);
    area_.resize(count);
    for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) add(t, pattern);
  }

  /// How many pieces of stripe or ground are smaller than `area` and end at no boundary.
  int pieces_below(double area) const {
    std::vector<double> sums(parent_.size());
    std::vector<bool> open(parent_.size());
    for (std::size_t p = 0; p < parent_.size(); ++p) sums[root(p)] += area_[p];
    for (Index e = 0; e < edges_.count(); ++e) {
      if (edges_.triangle_count(e) == 2) continue;
      for (const Index v : edges_.vertices[e]) open[root(v)] = true;
      for (std::size_t k = 0; k + 1 < kStepsPerEdge; ++k) {
        open[root(first_of_edges_ + e * (kStepsPerEdge - 1) + k)] = true;
      }
    }
    int below = 0;
    for (std::size_t p = 0; p < parent_.size(); ++p) {
      below += root(p) == p && sums[p] > 0 && sums[p] < area && !open[p];
    }
    return below;
  }

 private:
  using Place = std::array<int, 3>;  // weights of the corners, of kStepsPerEdge

  std::size_t point(std::size_t t, const Place& place) const {
    constexpr std::size_t kInside = (kStepsPerEdge - 1) * (kStepsPerEdge - 2) / 2;
    const Triangle& triangle = mesh_.triangles[t];
    for (std::size_t m = 0; m < 3; ++m) {
      if (place[m] == kStepsPerEdge) return triangle[m];
    }
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t next = (m + 1) % 3;
      if (place[(m + 2) % 3] != 0) continue;
      const int along = triangle[m] < triangle[next] ? place[next] : place[m];
      return first_of_edges_ + edges_.of_triangle[t][m] * (kStepsPerEdge - 1) +
             static_cast<std::size_t>(along - 1);
    }
    const auto row = static_cast<std::size_t>(place[1] - 1);
    const auto column = static_cast<std::size_t>(place[2] - 1);
    const std::size_t before =
        row * (kStepsPerEdge - 2) - row * (row - 1) / 2;  // in shorter and shorter rows
    return first_of_triangles_ + t * kInside + before + column;
  }

  void add(std::size_t t, const StripePattern& pattern) {
    const Triangle& triangle = mesh_.triangles[t];
    const auto corners = corner_waves(triangle, pattern.waves, pattern.solution.z);
    const auto& p = mesh_.positions;
    const double area =
        0.5 * (p[triangle[1]] - p[triangle[0]]).cross(p[triangle[2]] - p[triangle[0]]).norm();
    for (int i = 0; i <= kStepsPerEdge; ++i) {
      for (int j = 0; i + j <= kStepsPerEdge; ++j) {
        const Place place = {kStepsPerEdge - i - j, i, j};
        const Vec3 b = Vec3(static_cast<float>(place[0]), static_cast<float>(place[1]),
                            static_cast<float>(place[2])) /
                       static_cast<float>(kStepsPerEdge);
        const std::size_t here = point(t, place);
        striped_[here] = fragment_phase(corners, b).z.imag() > 0;
        area_[here] += 2 * area / ((kStepsPerEdge + 1) * (kStepsPerEdge + 2));
      }
    }
    for (int i = 0; i <= kStepsPerEdge; ++i) {
      for (int j = 0; i + j < kStepsPerEdge; ++j) {
        const std::size_t a = point(t, {kStepsPerEdge - i - j, i, j});
        const std::size_t b = point(t, {kStepsPerEdge - i - j - 1, i + 1, j});
        const std::size_t c = point(t, {kStepsPerEdge - i - j - 1, i, j + 1});
        join(a, b);
        join(b, c);
        join(c, a);
      }
    }
  }

  std::size_t root(std::size_t p) const {
    while (parent_[p] != p) p = parent_[p];
    return p;
  }

  void join(std::size_t a, std::size_t b) {
    if (striped_[a] != striped_[b]) return;
    const std::size_t to = root(b);
    parent_[root(a)] = to;
    for (std::size_t p = a; parent_[p] != p;) p = std::exchange(parent_[p], to);
    for (std::size_t p = b; parent_[p] != p;) p = std::exchange(parent_[p], to);
  }

  const Mesh& mesh_;
  MeshEdges edges_;
  std::size_t first_of_edges_ = 0, first_of_triangles_ = 0;
  std::vector<std::size_t> parent_;
  std::vector<bool> striped_;
  std::vector<double> area_;
};

TEST(Specks, AreNotDrawnOnCoarseSurfaces) {
  std::size_t singular = 0;
  for (const std::string shape : {"trefoil,resolution=14", "vessels,resolution=36",
                                  "molecule,resolution=16", "box,resolution=14"}) {
    const Surface surface = make_surface(make_shape(shape));
    const DirectionField field =
        projected_direction_field(Vec3(0.31f, 0.9f, 0.27f).normalized(), surface.normals);
    for (const float stripes : {20.0f, 40.0f}) {
      const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
      const StripePattern pattern = stripe_pattern(surface, field, frequency);
      // A tenth of a period wide and long.
      EXPECT_EQ(Lattice(surface, pattern).pieces_below(0.01 / (frequency * frequency)), 0)
          << shape << " with " << stripes << " stripes";
      singular += pattern.quality.field_singularities;
    }
  }
  EXPECT_GT(singular, 300u);
}

}  // namespace
}  // namespace brindle
