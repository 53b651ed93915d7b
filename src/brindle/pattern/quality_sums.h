/// Sums from which quality metrics follow, for surfaces that are measured in parts.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/corner_phases.h"
#include "brindle/progress.h"
#include "brindle/quality.h"
#include "brindle/texture_waves.h"
#include "brindle/types.h"

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

// Errors of a pattern on points relative to its field.

/// Measures angle and spacing errors of the phase gradient at every point: the least-squares fit to
/// the lifted steps to its neighbours, in the tangent plane. Without triangles, branches and
/// singularities are not counted. The means weigh points equally. They exclude points without a
/// wave and points whose neighbours with a wave are collinear with them. `normals`, `waves` and `z`
/// have one entry per point.
PatternQuality measure_point_quality(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                     const WaveSet& waves, std::span<const Complex> z,
                                     PhaseShiftKind kind, const Progress& progress = {});

// Distortion of textures whose corner phases are known.

/// One pattern of a texture: corner phases by triangle, frequencies by vertex.
struct LinearPattern {
  std::span<const CornerPhases> corners;
  std::span<const float> frequencies;
};

/// As `measure_texture` for texture waves, from their corner phases. The orientation of U and V in
/// a triangle has no effect.
TextureQuality measure_texture(const Mesh& mesh, const LinearPattern& u, const LinearPattern& v,
                               const Progress& progress = {});

}  // namespace brindle
