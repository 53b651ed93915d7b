/// Smooth fields that start from those of the last surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brindle/carried_phases.h"
#include "input/carried_pattern.h"
#include "input/preparation.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// The kept data of a field.
struct KeptField {
  std::string name;  ///< file name of its surface, for messages
  Mesh mesh;
  std::vector<Vec3> normals;
  DirectionField directions;      ///< before they are turned
  std::vector<DataArray> arrays;  ///< of points
  double period = 0;              ///< mean over its waves that are known on the mesh
};

/// The field of a pattern, before it was turned. Normals of points are those of the file, or fitted
/// to `neighbors`.
KeptField field_of(const KeptPattern& pattern, std::optional<int> neighbors);

/// A note on a pattern whose waves are turned from its field by another angle than these; else
/// empty. The field is continued; the phases of other waves cannot be.
std::string turn_note(const KeptPattern& pattern, const WaveOptions& waves);

/// The field transferred to the `prepared` surface of the file `name`. Throws Error as
/// `match_vertices` does.
DirectionField carry_field(const KeptField& last, const std::string& name,
                           const Preparation& prepared, const WaveOptions& waves,
                           const MatchOptions& options);

}  // namespace brindle::tool
