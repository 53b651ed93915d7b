/// Texture coordinates for files: one pair per vertex, with vertices split where needed.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/phase_shift.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

/// A mesh whose vertices have texture coordinates: lifted phases over 2 pi, plus a quarter
/// (`texture_coordinate`). One tile is one unit; U runs to the right of a tile and V upwards.
struct TexturedMesh {
  Mesh mesh;  ///< the vertices of the original with their numbers, then copies and new ones
  std::vector<Eigen::Vector2f> coordinates;  ///< one per vertex
  /// One per vertex: the vertices of the original mesh of which it is the mean; three times the
  /// same for a vertex and its copies.
  std::vector<std::array<Index, 3>> origins;
  std::vector<Index>
      triangle_origins;             ///< one per triangle: the original triangle that it is part of
  std::size_t split_triangles = 0;  ///< at their barycentres
};

/// Coordinates that are linear in each triangle and agree along edges up to whole tiles. Neighbours
/// share a copy of a vertex wherever their coordinates agree; whole tiles are added to achieve
/// that. Triangles at branches and singularities of the field are split at their barycentre
/// (Knöppel et al. 2015), which keeps the remaining seam inside them. Triangles without waves have
/// the coordinates 0, 0. `waves` has one entry per triangle of the mesh. Throws Cancelled if
/// `progress` cancels.
TexturedMesh texture_coordinates(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind,
                                 const Progress& progress = {});

/// U and V at the three corners of every triangle, linear in each, one tile a unit: six numbers per
/// triangle, corner by corner. NaN in triangles that are singularities of the field or have a
/// corner without a wave. Triangles agree at common vertices up to whole tiles.
std::vector<float> corner_texture_coordinates(const TextureWaves& waves, PhaseShiftKind kind);

/// Values per vertex of the original mesh (`components` numbers each), carried to the vertices of
/// the textured mesh.
std::vector<float> carried_values(const TexturedMesh& textured, std::span<const float> values,
                                  int components);

/// Arrays of the original mesh, carried to the vertices and triangles of the textured mesh;
/// barycentres get means of whole rows (`blended`). Throws Error as that does.
DataArrays carried_arrays(const TexturedMesh& textured, const DataArrays& arrays);

/// Waves of a textured mesh, one per vertex.
struct CarriedWaves {
  WaveSet waves;
  std::vector<Complex> z;
};

/// The waves of the original mesh's vertices, carried to the vertices of the textured mesh.
/// Barycentres get the wave of `fragment_phase`; those of singularities have none.
CarriedWaves carried_waves(const TexturedMesh& textured, const WaveSet& waves,
                           std::span<const Complex> z);

}  // namespace brindle
