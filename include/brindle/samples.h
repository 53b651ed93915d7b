/// Surface samples at crossings of the peaks of two wave patterns (paper, 5.1).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A point of the surface with the waves that cross there.
struct Sample {
  Vec3 position;
  Vec3 normal;       ///< unit, of the vertices around it
  Vec3 direction_u;  ///< unit, tangent; up to sign, like all directions
  Vec3 direction_v;
  float spacing_u = 0;  ///< 1 / f of U: the ideal distance to the next sample along direction_u
  float spacing_v = 0;
  Index triangle = 0;
  Vec3 barycentric;  ///< in that triangle; not negative, sums to 1
};

/// Arrays of the samples' mesh at the samples, as `arrays_at` of mesh_data.h; without triangles,
/// the rows of the points that `triangle` numbers.
std::vector<DataArray> arrays_at(std::span<const Sample> samples,
                                 std::span<const Triangle> triangles, const DataArrays& arrays);

inline constexpr float kDoubleShare = 0.25f;

/// Removes every sample that is nearer to an earlier one than `share` of the smallest of their four
/// spacings; lines of a pattern converge at its branches and singularities. Returns the number
/// removed. Samples on sides of the surface that face different ways do not count as near. Throws
/// Error in a build without nanoflann, if there are samples and `share` is above zero; Cancelled if
/// `progress` cancels, and then removes none.
std::size_t drop_doubles(std::vector<Sample>& samples, float share = kDoubleShare,
                         const Progress& progress = {});

/// The regularity of samples: distances to the nearest other sample over the smaller of the
/// sample's two spacings, the distance in a perfect grid.
struct SampleSpacing {
  std::size_t samples = 0;  ///< with another one within twice their smaller spacing
  double mean = 0;          ///< 1 for a perfect grid
  double deviation = 0;     ///< standard deviation; 0 for a perfect grid
  double double_share = 0;  ///< share of samples with another one within a tenth of the spacing
};

/// Throws Error in a build without nanoflann, and Cancelled if `progress` cancels.
SampleSpacing measure_sample_spacing(std::span<const Sample> samples,
                                     const Progress& progress = {});

}  // namespace brindle
