#include "brindle/pipeline/fields/averaged_normals.h"

#include <utility>

#include "brindle/phases/screened.h"
#include "brindle/pipeline/fields/surface_elements.h"

namespace brindle {
namespace {

class Averaging {
 public:
  Averaging(const Surface& surface, const Progress& progress)
      : normals_(surface.normals),
        areas_(areas_of_vertices(surface, areas_of_triangles(surface.mesh))) {
    const std::vector<float> stiffness = edge_stiffness(surface, progress);
    degrees_ = stiffness_sums(*surface.neighborhood, stiffness);
    graph_ = stiffness_graph(surface, stiffness);
    graph_.anchor.resize(normals_.size());
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      if (normals_[i].isZero(0)) areas_[i] = 0;  // which pulls at nothing
      across_.emplace_back(normals_[i].x(), normals_[i].y());
      up_.emplace_back(normals_[i].z());
    }
    averaged_across_ = across_;
    averaged_up_ = up_;
  }

  /// Begins with the last average, which is near.
  std::vector<Vec3> over(float radius, const Progress& progress) {
    average(radius, across_, averaged_across_, progress.part(0, 0.6));
    average(radius, up_, averaged_up_, progress.part(0.6, 1));
    std::vector<Vec3> normals(normals_.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Complex& across = averaged_across_[i];
      const Vec3 sum(across.real(), across.imag(), averaged_up_[i].real());
      constexpr float kNoDirection = 1e-3f;
      const bool has_direction = sum.norm() > kNoDirection && !normals_[i].isZero(0);
      normals[i] = has_direction ? Vec3(sum.normalized()) : normals_[i];
    }
    return normals;
  }

 private:
  void average(float radius, std::span<const Complex> values, std::vector<Complex>& averages,
               const Progress& progress) {
    // What decays as a screened field does over a length has twice that root mean square distance.
    std::vector<float> screening = areas_;
    for (float& s : screening) s *= 4 / (radius * radius);
    for (std::size_t i = 0; i < values.size(); ++i) graph_.anchor[i] = screening[i] * values[i];
    averages = smooth_screened(graph_, screening, std::move(averages),
                               {.of_anchors = true, .degrees = degrees_, .progress = progress});
  }

  std::span<const Vec3> normals_;
  std::vector<float> areas_, degrees_;
  PhaseGraph graph_;
  std::vector<Complex> across_, up_, averaged_across_, averaged_up_;
};

}  // namespace

std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress) {
  constexpr double kBefore = 0.2;
  Averaging averaging(surface, progress.part(0, kBefore));
  std::vector<std::vector<Vec3>> normals;
  for (const float radius : radii) {
    const auto done = static_cast<double>(normals.size());
    const double each = (1 - kBefore) / static_cast<double>(radii.size());
    normals.push_back(
        averaging.over(radius, progress.part(kBefore + done * each, kBefore + (done + 1) * each)));
  }
  return normals;
}

}  // namespace brindle
