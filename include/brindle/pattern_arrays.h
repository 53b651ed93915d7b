/// Arrays of patterns for mesh files, with a row per vertex or per triangle.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "brindle/broken_tiles.h"
#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_coordinates.h"
#include "brindle/waves_of.h"

namespace BRINDLE_EXPORT brindle {

/// Waves to write, one per vertex of a mesh.
struct WrittenWaves {
  const WaveSet& waves;
  std::span<const float> frequencies_wanted;  ///< requested ones; empty: those of `waves`
  std::span<const Complex> z;
  std::string suffix;  ///< of the arrays' names, to distinguish two sets of waves

  bool has_wave(std::size_t v) const {
    return !waves.directions[v].isZero(0) && z[v] != Complex(0);
  }
  std::string named(const char* name) const { return name + suffix; }
};

/// Adds phase, direction, frequency, frequency_wanted (if given), branch, sin_phase and valid.
/// `missing` is written where there is no wave. Points have no `branches`.
void add_waves(std::vector<DataArray>& arrays, const WrittenWaves& written, float missing,
               const std::vector<float>& branches);

/// As above for a pattern, carried to the vertices of a mesh with texture coordinates.
void add_carried_waves(std::vector<DataArray>& arrays, const TexturedMesh& textured,
                       const Mesh& mesh, const StripePattern& pattern, const std::string& suffix,
                       float missing);

/// A pattern and the suffix of its arrays' names.
struct NamedPattern {
  const StripePattern& pattern;
  std::string suffix;
};

/// Arrays of a mesh with texture coordinates: normal, uv and those of the patterns, which are on
/// `surface`; for triangles, branch.
DataArrays textured_arrays(const TexturedMesh& textured, const Surface& surface,
                           std::span<const NamedPattern> patterns, float missing);

/// The point array with the angle in degrees between waves and their field, the same in all rows.
/// It is missing if the angle is 0.
inline constexpr const char* kTurnArray = "turn_deg";

/// Adds the array `kTurnArray`, unless the angle is 0.
void add_turn(std::vector<DataArray>& arrays, float turn_deg, std::size_t rows);

/// Adds the arrays "coherence" and "filled" of smoothed fields, each unless it is empty.
void add_support(std::vector<DataArray>& arrays, const FieldSupport& support);

/// The same at the vertices of a mesh with texture coordinates. Vertices between others are filled
/// if one of those is.
FieldSupport carried_support(const TexturedMesh& textured, const FieldSupport& support);

/// The same, followed by entries for the barycentres of some triangles.
FieldSupport with_barycentres(FieldSupport support, std::span<const Triangle> triangles,
                              std::span<const Index> of_triangles);

/// The angle in `kTurnArray`; 0 if there is none. Throws Error if it is not the same finite number
/// in all rows.
float turn_said_by(std::span<const DataArray> arrays);

/// The input without its `kTurnArray`, which describes other waves.
DataArrays without_turn(const DataArrays& input);

/// Whether point arrays are those of a pattern, which always has "sin_phase".
bool hold_pattern(std::span<const DataArray> points);

/// An input array next to other arrays.
struct InputArray {
  DataArray array;
  std::string note;  ///< a sentence if the array was renamed
};

/// The arrays of an input next to arrays with the names `own`. An input array with one of these
/// names is renamed to "NAME_input"; if `replaced`, it is left out.
std::vector<InputArray> arrays_beside(std::span<const std::string> own,
                                      std::span<const DataArray> input, bool replaced);

/// A pattern's own arrays, then those of its input (`arrays_beside`). Arrays of an earlier pattern
/// in the input are replaced. `notes` gets those of the input arrays.
DataArrays join_arrays(DataArrays own, const DataArrays& input, std::vector<std::string>& notes);

/// The array original_id of a mesh with texture coordinates: -1 for new vertices.
DataArray carried_ids(const TexturedMesh& textured, std::span<const std::int64_t> ids);

/// 1 at the corners of triangles where a stripe begins or ends.
std::vector<float> branches_at_vertices(const Mesh& mesh, std::span<const CornerPhases> corners);

/// 1 in triangles where a stripe begins or ends.
DataArray branches_in_triangles(const StripePattern& pattern, const std::string& name);

/// The array tile_broken: 1 in triangles that a broken motif reaches.
DataArray broken_in_triangles(const TexturedMesh& textured, const BrokenTiles& broken);

/// Lifted phases at the corners of triangles, oriented alike; NaN in triangles that have none.
DataArray corner_phases_of(const StripePattern& pattern, const std::string& name);

}  // namespace brindle
