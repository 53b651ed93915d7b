/// Arrays of the mesh's file or of another one, by the names that users give them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/recipe/array_choice.h"
#include "brindle/surface.h"
#include "input/array_options.h"

namespace brindle::tool {

/// --max-distance where it is not given.
inline constexpr Length kDefaultMaxDistance = {0.02f, true};

struct OtherMesh;

class ArraySource {
 public:
  /// Arrays of the surface's file, which is called `file` in messages; or those of the file that
  /// the options name, which is read. What is handed over must outlive this. Throws Error for a
  /// file that cannot be read.
  ArraySource(const Surface& surface, const DataArrays& arrays, std::string file,
              const ArrayOptions& options);
  ~ArraySource();
  ArraySource(const ArraySource&) = delete;
  ArraySource& operator=(const ArraySource&) = delete;

  struct PerVertex {
    DataArray array;                 ///< a row per vertex of the surface
    std::size_t rows_nonfinite = 0;  ///< of the array as it was read
    /// As it was read, a row per triangle, if it is one of the surface's own cells.
    std::optional<DataArray> of_cells = std::nullopt;
  };

  /// The array NAME: that of points, or else that of cells, moved to the vertices; points/NAME and
  /// cells/NAME tell them apart. Throws Error, naming all arrays there are, for another name.
  PerVertex array(const std::string& name) const;

  /// Takes the wave from vertices that are too far from the other file's mesh, and returns how many
  /// of them have neighbours; nothing without another file.
  std::optional<std::size_t> drop_too_far(DirectionField& directions) const;

  /// Whether the other file's mesh is near enough to a vertex; without another file all are.
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
