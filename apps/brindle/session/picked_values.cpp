#include "session/picked_values.h"

#include <span>

#include "brindle/base/array_numbers.h"
#include "brindle/base/text.h"
#include "brindle/fragment_phase.h"

namespace brindle::tool {
namespace {

/// The numbers of an array with one row.
std::string text_of_row(const DataArray& row) {
  std::string text;
  for_each_number(row.view(), [&](std::size_t, std::size_t, auto number) {
    text += (text.empty() ? "" : ", ") + formatted("%.5g", static_cast<double>(number));
  });
  return text;
}

void add_wave(const StripePattern& pattern, const Triangle& triangle, const Vec3& barycentric,
              std::vector<PickedValue>& values) {
  const FragmentWave wave =
      fragment_phase(corner_waves(triangle, pattern.waves, pattern.solution.z), barycentric);
  if (wave.z == Complex(0)) {
    values.push_back({"wave", "none"});
    return;
  }
  // In either direction, 1 is the middle of a stripe and -1 that of a gap.
  values.push_back({"sine of the phase", formatted("%.2f", static_cast<double>(wave.z.imag()))});
  values.push_back({"frequency", formatted("%.5g", static_cast<double>(wave.frequency))});
}

}  // namespace

std::vector<PickedValue> values_at(const LiveState& state, const PickedPoint& point) {
  const StripeJob& job = *state.job;
  const Triangle& triangle = job.surface->mesh.triangles[point.triangle];
  std::vector<PickedValue> values = {
      {"place", formatted("%.5g, %.5g, %.5g", point.place.x(), point.place.y(), point.place.z())}};
  add_wave(job.result.stripes(), triangle, point.barycentric, values);
  const Eigen::Vector3d weights = point.barycentric.cast<double>();
  const RowBlend corners{triangle, {weights[0], weights[1], weights[2]}};
  for (const DataArray& array : job.data.arrays.points) {
    if (array.rows() != job.surface->mesh.vertex_count()) continue;
    values.push_back({shown(array.name), text_of_row(blended(array, std::span(&corners, 1)))});
  }
  const auto number = static_cast<Index>(point.triangle);
  for (const DataArray& array : job.data.arrays.cells) {
    if (array.rows() != job.surface->mesh.triangle_count()) continue;
    values.push_back({shown(array.name), text_of_row(rows_of(array, std::span(&number, 1)))});
  }
  return values;
}

}  // namespace brindle::tool
