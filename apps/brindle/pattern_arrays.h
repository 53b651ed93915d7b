/// Arrays of what was made, a row per vertex and per triangle, for mesh files. The Python package
/// and ParaView's plugin compile this source, too, so that their arrays are those of the files.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/stripe_pattern.h"
#include "brindle/texture_coordinates.h"

namespace brindle::tool {

/// One wave per vertex of a mesh.
struct WrittenWaves {
  const WaveSet& waves;
  std::span<const float> frequencies_wanted;  ///< empty: those of `waves`
  std::span<const Complex> z;
  std::string suffix;  ///< of the arrays' names: sets two sets of waves apart

  bool has_wave(std::size_t v) const {
    return !waves.directions[v].isZero(0) && z[v] != Complex(0);
  }
  std::string named(const char* name) const { return name + suffix; }
};

/// Adds phase, direction, frequency, branch, sin_phase and valid. `missing` stands where there is
/// no wave. Points have no `branches`.
void add_waves(std::vector<DataArray>& arrays, const WrittenWaves& written, float missing,
               const std::vector<float>& branches);

/// The same of a pattern, carried to the vertices of a mesh with texture coordinates.
void add_carried_waves(std::vector<DataArray>& arrays, const TexturedMesh& textured,
                       const Mesh& mesh, const StripePattern& pattern, const std::string& suffix,
                       float missing);

/// 1 at the corners of triangles where a stripe begins or ends.
std::vector<float> branches_at_vertices(const Mesh& mesh, std::span<const CornerPhases> corners);

/// 1 in triangles where a stripe begins or ends.
DataArray branches_in_triangles(const StripePattern& pattern, const std::string& name);

/// Lifted phases at the corners of triangles, oriented alike; NaN in triangles that have none.
DataArray corner_phases_of(const StripePattern& pattern, const std::string& name);

}  // namespace brindle::tool
