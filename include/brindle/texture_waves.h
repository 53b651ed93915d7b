/// Two waves at every corner of every triangle, along which textures are laid (paper, 3.5).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/fragment_phase.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// The waves of one triangle's corners.
using CornerWaves = std::array<CornerWave, 3>;

/// Waves U and V, one entry per triangle each. Texture coordinates are phases over 2 pi, plus a
/// quarter (`texture_coordinate`). Waves are stored by corner rather than by vertex, because each
/// triangle may use another, or reversed, wave of a vertex.
struct TextureWaves {
  std::vector<CornerWaves> u;
  std::vector<CornerWaves> v;

  std::size_t triangle_count() const { return u.size(); }
};

/// The waves of all vertices, unchanged. `u` and `v` have one wave, `z_u` and `z_v` one phase exp(i
/// Phi), per vertex. Throws Error if sizes do not match.
TextureWaves texture_waves(std::span<const Triangle> triangles, const WaveSet& u,
                           std::span<const Complex> z_u, const WaveSet& v,
                           std::span<const Complex> z_v);

/// Whether the three directions run alike: all pairwise products are positive or zero, and none of
/// them is the zero vector.
bool run_alike(const CornerWaves& corners);

/// Whether both the corners of U and those of V run alike: the triangle has an orientation.
bool is_oriented(const TextureWaves& waves, std::size_t triangle);

/// Makes the corners of every triangle run alike, for both U and V, where possible. Keeps as many
/// corners of U as possible, and the turn from U to V (counter-clockwise or clockwise) at most
/// corners. Other triangles do not change; `texture_fragment` splits them.
void orient_corners(TextureWaves& waves, const Progress& progress = {});

/// The waves U and V at a fragment.
struct TextureFragment {
  FragmentWave u;
  FragmentWave v;
};

/// Eq. 13 and 14 for both. A triangle without orientation is split at its barycentre for U and V
/// alike. Along each edge they therefore equal its neighbour's, or both are reversed.
TextureFragment texture_fragment(const CornerWaves& u, const CornerWaves& v,
                                 const Vec3& barycentric);

/// The texture coordinate of a phase: Phi / 2 pi + 1/4, from -1/4 to 3/4. The quarter is the
/// paper's: a reversed wave has pi - Phi and thus the negative coordinate, so that a tile with
/// 180-degree symmetry about its middle looks the same both ways. The middle of the tile, 1/2, is
/// at the crests, Phi = pi / 2.
float texture_coordinate(Complex z);

/// Distortion of the unit square of texture coordinates against its target, a rectangle of 1 / f_U
/// by 1 / f_V. Covers all oriented triangles without a vertex of a branch or a singularity.
struct TextureQuality {
  std::size_t measured_triangles = 0;
  double angle_mean_deg = 0;  ///< between the square's angle on the surface and 90 degrees
  double angle_95th_deg = 0;  ///< 95 % of the triangles stay below
  double area_mean = 0;       ///< of max(a, 1/a) - 1 with a = its area times f_U f_V; at most 99
  double area_95th = 0;
};

/// All triangles have the same weight. `waves` has one entry per triangle, its corners oriented.
/// The last `parts` triangles, those of a cross field's singular ones, count as singularities.
TextureQuality measure_texture(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind,
                               std::size_t parts = 0);

/// Edges at which the textures of two triangles do not match, and triangles without orientation.
struct TextureSeams {
  /// Edges where U and V both reverse; invisible with 180-degree symmetric tiles.
  std::size_t turned = 0;
  std::size_t mirrored = 0;  ///< edges where one of them reverses: the mesh's winding changes here
  std::size_t unoriented_triangles = 0;  ///< corners that cannot be oriented alike, or have no wave
};

}  // namespace brindle
