/// The arrays in which filters hand waves on, called as in the files that brindle writes.
#pragma once

#include <span>
#include <vector>

#include <brindle/stripe_pattern.h>
#include <brindle/types.h>

class vtkDataSetAttributes;
class vtkFieldData;

namespace brindle::paraview {

/// A wave per point.
struct PointWaves {
  std::vector<Vec3> directions;  ///< unit, or zero where there is no wave
  std::vector<float> frequencies;
  std::vector<float> frequencies_wanted;  ///< empty without slack
  std::vector<Complex> z;
  std::vector<float> branches;  ///< 1 at corners of triangles in which a stripe begins or ends
};

/// The flags of a pattern's vertices that PointWaves::branches has.
std::vector<float> branches_at_vertices(const Mesh& mesh, std::span<const CornerPhases> corners);

/// Whether a stripe begins or ends in a triangle.
bool is_branch(const CornerPhases& corners);

/// phase, sin_phase (both NaN where there is no wave), direction, frequency, frequency_wanted,
/// branch, valid.
void add_waves(const PointWaves& waves, vtkDataSetAttributes& points);

/// branches, angle_error_mean_deg and spacing_error_mean of the whole pattern.
void add_figures(const PatternQuality& quality, vtkFieldData& data);

}  // namespace brindle::paraview
