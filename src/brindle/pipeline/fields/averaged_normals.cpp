#include "brindle/pipeline/fields/averaged_normals.h"

#include <array>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/phases/screened.h"
#include "brindle/pipeline/fields/surface_elements.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

class Averaging {
 public:
  Averaging(const Surface& surface, const Progress& progress) : normals_(surface.normals) {
    const std::vector<float> stiffness = edge_stiffness(surface, progress);
    areas_ = areas_of_vertices(surface, areas_of_triangles(surface.mesh));
    degrees_ = stiffness_sums(*surface.neighborhood, stiffness);
    graph_ = stiffness_graph(surface, stiffness);
    graph_.anchor.resize(normals_.size());
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      if (normals_[i].isZero(0)) areas_[i] = 0;  // no anchor
      across_.emplace_back(normals_[i].x(), normals_[i].y());
      up_.emplace_back(normals_[i].z());
    }
    averaged_across_ = across_;
    averaged_up_ = up_;
  }

  /// Starts from the previous average, which is close.
  std::vector<Vec3> over(float radius, const Progress& progress) {
    average(radius, across_, averaged_across_, progress.part(0, 0.6));
    average(radius, up_, averaged_up_, progress.part(0.6, 1));
    std::vector<Vec3> averages(normals_.size());
    for (std::size_t i = 0; i < averages.size(); ++i) {
      const Complex& across = averaged_across_[i];
      const Vec3 sum(across.real(), across.imag(), averaged_up_[i].real());
      constexpr float kNoDirection = 1e-3f;
      const bool has_direction = sum.norm() > kNoDirection && !normals_[i].isZero(0);
      averages[i] = has_direction ? Vec3(sum.normalized()) : normals_[i];
    }
    return averages;
  }

 private:
  void average(float radius, std::span<const Complex> values, std::vector<Complex>& averages,
               const Progress& progress) {
    // With decay length l, a screened field has a root mean square distance of 2 l.
    std::vector<float> screening = areas_;
    for (float& s : screening) s *= 4 / (radius * radius);
    for (std::size_t i = 0; i < values.size(); ++i) graph_.anchor[i] = screening[i] * values[i];
    averages = smooth_screened(graph_, screening, std::move(averages),
                               {.of_anchors = true, .degrees = degrees_, .progress = progress});
  }

  std::span<const Vec3> normals_;
  std::vector<float> areas_;    ///< of vertices
  std::vector<float> degrees_;  ///< sums of stiffness
  PhaseGraph graph_;            ///< coupled by the stiffness of edges
  std::vector<Complex> across_, up_, averaged_across_, averaged_up_;
};

constexpr double kBeforeAverages = 0.2;

/// Multiples of the requested radius.
constexpr std::array<float, 3> kFarther = {1, 2, 4};

}  // namespace

std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress) {
  Averaging averaging(surface, progress.part(0, kBeforeAverages));
  const Progress averages = progress.part(kBeforeAverages, 1);
  std::vector<std::vector<Vec3>> normals;
  for (const float radius : radii) {
    const double each = 1 / static_cast<double>(radii.size());
    const auto done = static_cast<double>(normals.size());
    normals.push_back(averaging.over(radius, averages.part(done * each, (done + 1) * each)));
  }
  return normals;
}

std::vector<float> averaging_radii(float normal_radius, bool goes_on) {
  std::vector<float> radii(goes_on ? 1 : kFarther.size());
  for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = kFarther[i] * normal_radius;
  return radii;
}

void turn_to_normals(std::span<const Vec3> from, std::span<const Vec3> to, DirectionField& field) {
  parallel_for(field.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (field[i].isZero(0) || from[i] == to[i]) continue;
      // On fine folds the new normal may be that of the opposite side: mirror the direction.
      const bool folded = from[i].dot(to[i]) < kOppositeSides;
      field[i] =
          tangent_direction(transported(field[i], from[i], folded ? Vec3(-to[i]) : to[i]), to[i]);
    }
  });
}

std::vector<Complex> values_at(FieldOnNormals field, std::span<const Vec3> normals, int symmetry) {
  turn_to_normals(field.normals, normals, field.directions);
  std::vector<Complex> u(normals.size());
  parallel_for(u.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      u[i] = representation(field.directions[i], normals[i], symmetry);
    }
  });
  return u;
}

}  // namespace brindle
