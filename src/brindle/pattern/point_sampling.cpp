#include "brindle/pattern/point_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// The search radius over the mean distance to the neighbours.
constexpr float kReach = 0.75f;
/// Sine of the angle between U and V below which they do not cross.
constexpr float kParallel = 0.1f;
/// A crossing may be farther from its point than from a neighbour by this factor.
constexpr float kFarther = 1.1f;

/// The distance along a wave to a peak; all others are at multiples of 1 / frequency from it.
float first_peak(const PointWaves& waves, Index i) {
  const float turns = elementary::arg(waves.z[i]) / (2 * std::numbers::pi_v<float>);
  return (0.25f - turns) / waves.waves.frequencies[i];
}

/// Calls `use(distance)` for every peak no farther than `reach`.
template <class Use>
void for_peaks(const PointWaves& waves, Index i, float reach, const Use& use) {
  const float frequency = waves.waves.frequencies[i];
  const float first = first_peak(waves, i);
  const float last = std::floor((reach - first) * frequency);
  for (float k = std::ceil((-reach - first) * frequency); k <= last; ++k) {
    use(first + k / frequency);
  }
}

class PointSampler {
 public:
  PointSampler(const Adjacency& neighborhood, std::span<const Vec3> normals, const PointWaves& u,
               const PointWaves& v)
      : neighborhood_(neighborhood), normals_(normals), u_(u), v_(v) {}

  void add_samples(Index i, std::vector<Sample>& samples) const {
    const Vec3& d_u = u_.waves.directions[i];
    const Vec3& d_v = v_.waves.directions[i];
    const Vec3 across = normals_[i].cross(d_u);
    const float sine = d_v.dot(across);
    if (d_u.isZero(0) || std::abs(sine) < kParallel || neighborhood_.of(i).empty()) return;
    const float cosine = d_v.dot(d_u), reach = reach_of(i);
    for_peaks(u_, i, reach, [&](float along) {
      // Where U's peak crosses V's: <x, d_v> = distance.
      const float widest = std::abs(cosine * along) + std::abs(sine) * reach;
      for_peaks(v_, i, widest, [&](float distance) {
        const Vec3 x = along * d_u + (distance - cosine * along) / sine * across;
        if (x.norm() <= reach && is_nearest(i, x)) samples.push_back(sample_at(i, x));
      });
    });
  }

 private:
  float reach_of(Index i) const {
    float sum = 0;
    for (const Index j : neighborhood_.of(i)) sum += offset(i, j).norm();
    return kReach * sum / static_cast<float>(neighborhood_.of(i).size());
  }

  Vec3 offset(Index i, Index j) const { return u_.waves.positions[j] - u_.waves.positions[i]; }

  bool is_nearest(Index i, const Vec3& x) const {
    const float distance = x.norm();
    return ranges::all_of(neighborhood_.of(i), [&](Index j) {
      return distance <= kFarther * (x - offset(i, j)).norm();
    });
  }

  Sample sample_at(Index i, const Vec3& x) const {
    return {u_.waves.positions[i] + x,
            normals_[i],
            u_.waves.directions[i],
            v_.waves.directions[i],
            1 / u_.waves.frequencies[i],
            1 / v_.waves.frequencies[i],
            i,
            Vec3(1, 0, 0)};
  }

  const Adjacency& neighborhood_;
  std::span<const Vec3> normals_;
  const PointWaves& u_;
  const PointWaves& v_;
};

}  // namespace

std::vector<Sample> point_samples(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                  const PointWaves& u, const PointWaves& v) {
  const PointSampler sampler(neighborhood, normals, u, v);
  std::vector<Sample> samples;
  for (Index i = 0; i < neighborhood.node_count(); ++i) sampler.add_samples(i, samples);
  drop_doubles(samples);
  return samples;
}

}  // namespace brindle
