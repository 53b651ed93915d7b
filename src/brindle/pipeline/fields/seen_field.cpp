#include "brindle/pipeline/fields/seen_field.h"

#include <array>

#include "brindle/base/parallel.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// Of the radius that is asked for.
constexpr std::array<float, 3> kFarther = {1, 2, 4};

}  // namespace

std::vector<float> averaging_radii(float normal_radius, bool goes_on) {
  std::vector<float> radii(goes_on ? 1 : kFarther.size());
  for (std::size_t i = 0; i < radii.size(); ++i) radii[i] = kFarther[i] * normal_radius;
  return radii;
}

void turn_to_normals(std::span<const Vec3> from, std::span<const Vec3> to, DirectionField& field) {
  parallel_for(field.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (field[i].isZero(0) || from[i] == to[i]) continue;
      // Where the surface is folded so finely that its normal is the other side's, it is mirrored.
      const bool folded = from[i].dot(to[i]) < kOppositeSides;
      field[i] =
          tangent_direction(transported(field[i], from[i], folded ? Vec3(-to[i]) : to[i]), to[i]);
    }
  });
}

std::vector<Complex> values_at(SeenField field, std::span<const Vec3> normals, int symmetry) {
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
