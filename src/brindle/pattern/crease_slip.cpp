#include "brindle/crease_slip.h"

#include <cmath>
#include <numbers>

#include "brindle/base/elementary.h"
#include "brindle/waves/crease_links.h"

namespace brindle {
namespace {

/// The slip between two waves at one vertex in degrees, 0 to 180; nullopt if either is missing.
std::optional<double> slip_between(const Surface& surface, const WaveSet& waves,
                                   std::span<const Complex> z, Index i, Index j) {
  const Vec3 &d_i = waves.directions[i], &d_j = waves.directions[j];
  if (d_i.isZero(0) || d_j.isZero(0)) return std::nullopt;
  const float cosine = cosine_across(d_j, surface.normals[j], d_i, surface.normals[i]);
  const Complex seen = cosine < 0 ? -std::conj(z[j]) : z[j];
  return std::abs(elementary::arg(z[i] * std::conj(seen))) * 180 / std::numbers::pi;
}

}  // namespace

std::optional<CreaseSlip> crease_slip(const Surface& surface, const WaveSet& waves,
                                      std::span<const Complex> z) {
  if (surface.creases.empty()) return std::nullopt;
  CreaseSlip slip;
  for (const CreaseEdge& edge : surface.creases.edges) {
    const auto [from, to] = edge.first;
    const double half = (surface.mesh.positions[to] - surface.mesh.positions[from]).norm() / 2;
    for (int end = 0; end < 2; ++end) {
      const auto degrees = slip_between(surface, waves, z, edge.first[end], edge.second[end]);
      if (!degrees) continue;
      slip.length += half;
      slip.mean_deg += half * *degrees;
      slip.share += *degrees > kSlipDegrees ? half : 0;
    }
  }
  if (slip.length > 0) {
    slip.mean_deg /= slip.length;
    slip.share /= slip.length;
  }
  return slip;
}

}  // namespace brindle
