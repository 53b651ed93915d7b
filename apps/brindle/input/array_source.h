/// Arrays of the mesh's file or of another one, by name.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/recipe/field_data.h"
#include "brindle/surface.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// The default of --max-distance.
inline constexpr Length kDefaultMaxDistance = {0.02f, true};

struct OtherMesh;

class ArraySource {
 public:
  /// Arrays of the surface's file, named `file` in messages, or of the file in the options, which
  /// is read. The arguments must outlive this object. Throws Error if a file cannot be read.
  ArraySource(const Surface& surface, const DataArrays& arrays, std::string file,
              const ArrayOptions& options);
  ~ArraySource();
  ArraySource(const ArraySource&) = delete;
  ArraySource& operator=(const ArraySource&) = delete;

  struct PerVertex {
    DataArray array;                 ///< a row per vertex of the surface
    std::size_t rows_nonfinite = 0;  ///< of the array in the file
    /// The original rows per triangle, if it is a cell array of the surface's file.
    std::optional<DataArray> of_cells = std::nullopt;
  };

  /// The array NAME of points or else of cells, transferred to the vertices; points/NAME and
  /// cells/NAME select one. Throws Error with all names if there is none.
  PerVertex array(const std::string& name) const;

  /// Removes the waves of vertices too far from the other file's mesh, and returns how many of
  /// these have neighbours; empty without another file.
  std::optional<std::size_t> drop_too_far(DirectionField& directions) const;

  /// Whether the other file's mesh is near enough to a vertex; true without another file.
  bool is_near(Index vertex) const;

  /// Lines for the user about the other file's mesh.
  std::string notes() const;

 private:
  const Surface& surface_;
  const DataArrays& own_;
  std::string file_;
  std::unique_ptr<OtherMesh> other_;
};

}  // namespace brindle::tool
