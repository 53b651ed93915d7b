/// Quality of a pattern along its field: branches, angle and spacing errors (paper, Fig. 8).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Metrics of a pattern.
struct PatternQuality {
  std::size_t branches = 0;             ///< triangles of kind branch or field_singularity
  std::size_t field_singularities = 0;  ///< triangles of kind field_singularity
  /// Area of `branches` over that of these and the regular triangles.
  double branch_area_share = 0;
  // Regular triangles, weighted by area, so that the triangulation does not matter. 0 if there are
  // none, or none with an area.
  double angle_error_mean_deg = 0;         ///< gradient against mean direction
  double angle_error_share_over_5deg = 0;  ///< share of the area, between 0 and 1
  /// The part of it where the phases of a triangle's corners differ by half a period or more.
  double coarse_share_over_5deg = 0;
  double spacing_error_mean = 0;  ///< mean of | |gradient| / (2 pi f) - 1 |
  /// The same against the requested frequencies, which spacing tolerance changes.
  double spacing_error_wanted_mean = 0;
  /// `branches` in triangles with a mean `Slack::branch_penalty` of at least a half; empty without
  /// branch avoidance.
  std::optional<std::size_t> branches_in_avoided_area;
  std::size_t vertices_without_wave = 0;  ///< with the direction zero: nothing is drawn
};

/// The number of vertices with the direction zero.
std::size_t count_without_wave(std::span<const Vec3> directions);

/// Angle in degrees, 0 to 180, between the gradient of the lifted corner phases and the mean corner
/// direction in the triangle's plane, for every triangle; -1 where the triangle is not regular.
std::vector<float> angle_errors_deg(const Mesh& mesh, const WaveSet& waves,
                                    std::span<const CornerPhases> corners);

/// Errors are weighted by the areas of triangles; `waves` has one entry per vertex, `corners` one
/// per triangle.
PatternQuality measure_quality(const Mesh& mesh, const WaveSet& waves,
                               std::span<const CornerPhases> corners,
                               const Progress& progress = {});

// Mismatch of stripes across sharp edges.

/// Phases that differ by more than this, a sixth of a period, do not meet across a crease.
inline constexpr float kSlipDegrees = 60;

/// Phase differences across creases. Phases cannot meet where the faces need different frequencies
/// along a crease: each face keeps its spacing, and stripes end there.
struct CreaseSlip {
  double mean_deg = 0;  ///< mean phase difference, 0 to 180, weighted by length
  double share = 0;     ///< share of the length with a difference above `kSlipDegrees`, 0 to 1
  double length = 0;    ///< of all creases between waves, in units of length
};

/// Empty for a surface without creases. `z` has one phase per vertex.
std::optional<CreaseSlip> crease_slip(const Surface& surface, const WaveSet& waves,
                                      std::span<const Complex> z);

}  // namespace brindle
