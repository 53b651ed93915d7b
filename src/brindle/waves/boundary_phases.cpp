#include "brindle/boundary_phases.h"

#include <cmath>
#include <numbers>

#include "brindle/base/elementary.h"
#include "brindle/error.h"
#include "brindle/geometry/crease_edges.h"

namespace brindle {
namespace {

constexpr float kInside = 1e-3f;
constexpr float kAcross = 0.7f;  // cosine of 45 degrees

/// Unit vectors from boundary vertices into the surface; zero at others.
std::vector<Vec3> ways_inwards(const Surface& surface) {
  const Mesh& mesh = surface.mesh;
  const MeshEdges edges = joined_edges(surface);
  std::vector<Vec3> inwards(mesh.vertex_count(), Vec3::Zero());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    for (std::size_t m = 0; m < 3; ++m) {
      if (edges.triangle_count(edges.of_triangle[t][m]) != 1) continue;
      const Index a = triangle[m], b = triangle[(m + 1) % 3], c = triangle[(m + 2) % 3];
      const Vec3 along = (mesh.positions[b] - mesh.positions[a]).stableNormalized();
      const Vec3 way = mesh.positions[c] - mesh.positions[a];
      const Vec3 inward = (way - way.dot(along) * along).stableNormalized();
      inwards[a] += inward;
      inwards[b] += inward;
    }
  }
  for (Vec3& inward : inwards) inward.stableNormalize();
  return inwards;
}

}  // namespace

std::vector<Complex> boundary_phases(const Surface& surface, const WaveSet& waves, float periods) {
  if (!std::isfinite(periods)) throw Error("the phase at boundaries must be a finite number");
  const std::size_t count = surface.mesh.vertex_count();
  if (waves.directions.size() != count) {
    throw Error("the phase at boundaries needs one wave for each of " + std::to_string(count) +
                " vertices");
  }
  float share = periods - std::floor(periods);
  if (share < kInside || share > 1 - kInside) share = kInside;
  const Complex phase = elementary::polar(1.0f, std::numbers::pi_v<float> * (0.5f - 2 * share));
  const std::vector<Vec3> inwards = ways_inwards(surface);
  std::vector<Complex> phases(count, Complex(0));
  for (std::size_t v = 0; v < count; ++v) {
    const float across = waves.directions[v].dot(inwards[v]);
    if (std::abs(across) < kAcross) continue;
    phases[v] = across > 0 ? phase : -std::conj(phase);
  }
  return phases;
}

}  // namespace brindle
