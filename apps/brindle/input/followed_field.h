/// Smooth fields that go on from those of the surface before.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brindle/carried_field.h"
#include "input/carried_pattern.h"
#include "input/preparation.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// What is kept of a field.
struct KeptField {
  std::string name;  ///< of its surface's file, for messages
  Mesh mesh;
  std::vector<Vec3> normals;
  DirectionField directions;      ///< before they were turned
  std::vector<DataArray> arrays;  ///< of points
  double period = 0;              ///< mean, of its waves: as far as it is known around the mesh
};

/// The field of a pattern, before it was turned. The normals of points are those of their file, or
/// fitted to `neighbors`.
KeptField field_of(const KeptPattern& pattern, std::optional<int> neighbors);

/// A line about a pattern whose waves are turned from their field by another angle than these;
/// empty if they are not. Their field goes on; phases of waves that run elsewhere cannot.
std::string turn_note(const KeptPattern& pattern, const WaveOptions& waves);

/// Its directions as they are found on the surface that is `prepared`, of the file `name`. Throws
/// Error as `match_vertices` does.
DirectionField carry_field(const KeptField& last, const std::string& name,
                           const Preparation& prepared, const WaveOptions& waves,
                           const MatchOptions& options);

}  // namespace brindle::tool
