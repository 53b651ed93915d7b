#include "brindle/pipeline/fields/averaged_normals.h"

#include <utility>

#include "brindle/pipeline/fields/surface_elements.h"

namespace brindle {
namespace {

class Averaging {
 public:
  explicit Averaging(NormalElements elements) : elements_(std::move(elements)) {
    elements_.graph.anchor.resize(normals().size());
    for (std::size_t i = 0; i < normals().size(); ++i) {
      if (normals()[i].isZero(0)) elements_.areas[i] = 0;  // which pulls at nothing
      across_.emplace_back(normals()[i].x(), normals()[i].y());
      up_.emplace_back(normals()[i].z());
    }
    averaged_across_ = across_;
    averaged_up_ = up_;
  }

  /// Begins with the last average, which is near.
  std::vector<Vec3> over(float radius, const Progress& progress) {
    average(radius, across_, averaged_across_, progress.part(0, 0.6));
    average(radius, up_, averaged_up_, progress.part(0.6, 1));
    std::vector<Vec3> averages(normals().size());
    for (std::size_t i = 0; i < averages.size(); ++i) {
      const Complex& across = averaged_across_[i];
      const Vec3 sum(across.real(), across.imag(), averaged_up_[i].real());
      constexpr float kNoDirection = 1e-3f;
      const bool has_direction = sum.norm() > kNoDirection && !normals()[i].isZero(0);
      averages[i] = has_direction ? Vec3(sum.normalized()) : normals()[i];
    }
    return averages;
  }

 private:
  std::span<const Vec3> normals() const { return elements_.normals; }

  void average(float radius, std::span<const Complex> values, std::vector<Complex>& averages,
               const Progress& progress) {
    // What decays as a screened field does over a length has twice that root mean square distance.
    std::vector<float> screening = elements_.areas;
    for (float& s : screening) s *= 4 / (radius * radius);
    PhaseGraph& graph = elements_.graph;
    for (std::size_t i = 0; i < values.size(); ++i) graph.anchor[i] = screening[i] * values[i];
    ScreenedOptions options = elements_.part;
    options.of_anchors = true;
    options.degrees = elements_.degrees;
    options.progress = progress;
    averages = smooth_screened(graph, screening, std::move(averages), options);
  }

  NormalElements elements_;
  std::vector<Complex> across_, up_, averaged_across_, averaged_up_;
};

NormalElements elements_of(const Surface& surface, const Progress& progress) {
  const std::vector<float> stiffness = edge_stiffness(surface, progress);
  return {surface.normals, areas_of_vertices(surface, areas_of_triangles(surface.mesh)),
          stiffness_sums(*surface.neighborhood, stiffness), stiffness_graph(surface, stiffness)};
}

constexpr double kBeforeAverages = 0.2;

}  // namespace

std::vector<std::vector<Vec3>> averaged_normals(NormalElements elements,
                                                std::span<const float> radii,
                                                const Progress& progress) {
  Averaging averaging(std::move(elements));
  std::vector<std::vector<Vec3>> normals;
  for (const float radius : radii) {
    const double each = 1 / static_cast<double>(radii.size());
    const auto done = static_cast<double>(normals.size());
    normals.push_back(averaging.over(radius, progress.part(done * each, (done + 1) * each)));
  }
  return normals;
}

std::vector<std::vector<Vec3>> averaged_normals(const Surface& surface,
                                                std::span<const float> radii,
                                                const Progress& progress) {
  return averaged_normals(elements_of(surface, progress.part(0, kBeforeAverages)), radii,
                          progress.part(kBeforeAverages, 1));
}

}  // namespace brindle
