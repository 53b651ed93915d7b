/// Sums from which quality metrics follow, for surfaces that are measured in parts.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/quality.h"

namespace brindle {

/// Sums over the triangles and vertices of a part.
struct QualitySums {
  std::size_t branches = 0, field_singularities = 0, without_wave = 0;
  double area = 0, over_5deg = 0, angle = 0, spacing = 0;  ///< of regular triangles
  double branch_area = 0;
  double coarse = 0;  ///< area over 5 degrees where phases differ by half a period or more

  QualitySums operator+(const QualitySums& o) const {
    return {branches + o.branches,
            field_singularities + o.field_singularities,
            without_wave + o.without_wave,
            area + o.area,
            over_5deg + o.over_5deg,
            angle + o.angle,
            spacing + o.spacing,
            branch_area + o.branch_area,
            coarse + o.coarse};
  }
};

/// `waves` has one entry per vertex, `corners` one per triangle.
QualitySums quality_sums(const Mesh& mesh, const WaveSet& waves,
                         std::span<const CornerPhases> corners, const Progress& progress = {});

/// The metrics from the sums over all parts.
PatternQuality quality_of(const QualitySums& sums);

}  // namespace brindle
