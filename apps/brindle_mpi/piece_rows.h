/// Rows of files that stand for vertices, at the vertices of pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/data_arrays.h"
#include "brindle/distributed_surface.h"
#include "input/array_source.h"
#include "mesh_pieces.h"

namespace brindle::tool {

/// Collective. Rank 0 reads a file whose rows stand for the vertices of the whole: `rows` returns
/// arrays of a row for each. Returns those of the piece's vertices. Throws on all ranks what `rows`
/// throws, Error for a piece whose vertices have no numbers that a file could mean, or numbers
/// beyond the rows. `option` names the file.
std::vector<DataArray> piece_rows(Communicator& ranks, const ReadPiece& read,
                                  const std::string& option, const std::string& file,
                                  const std::function<std::vector<DataArray>()>& rows);

/// An array at the vertices of a piece.
struct ArrayAtVertices {
  DataArray array;                 ///< a row per vertex of the piece
  std::size_t rows_nonfinite = 0;  ///< of all ranks, as the array was read
  /// As it was read, a row per triangle of the piece, if it is one of the mesh's own cells.
  std::optional<DataArray> of_cells = std::nullopt;
};

/// Where arrays come from: the mesh's file, or another one that every rank reads (--field-mesh).
class PieceArrays {
 public:
  /// Collective. Throws Error on all ranks if the other file cannot be read.
  PieceArrays(Communicator& ranks, const DistributedSurface& surface, const ReadPiece& read,
              const ArrayOptions& options);

  /// Collective. The array NAME, points/NAME or cells/NAME; that of cells moved to the vertices.
  /// Throws Error on all ranks if there is no such array.
  ArrayAtVertices array(const std::string& name) const;

  /// Collective. As `ArraySource::drop_too_far`, on all ranks.
  std::optional<std::size_t> drop_too_far(DirectionField& directions) const;

  /// Whether the other file's mesh is near enough to a vertex; without another file all are.
  bool is_near(Index vertex) const { return !other_ || other_->is_near(vertex); }

  /// Lines for the user about the other file.
  std::string notes() const;

 private:
  Communicator& ranks_;
  const DistributedSurface& surface_;
  const ReadPiece& read_;
  Surface piece_;  ///< for `other_`
  std::unique_ptr<ArraySource> other_;
};

/// Collective. As `copy_from_partners` of array_rows.h, where the partners on rank 0 may be
/// others'.
void copy_from_partners(Communicator& ranks, const DistributedSurface& surface,
                        const ReadPiece& read, std::vector<DataArray>& arrays);

/// Collective. For every vertex of the piece the greatest flag, 0 or 1, that a rank has for it.
std::vector<float> flags_of_all(Communicator& ranks, const ReadPiece& read,
                                std::vector<float> flags);

/// Those of the piece's vertices that this rank owns and that have neighbours.
std::vector<std::uint8_t> used_own(const DistributedSurface& surface);

/// Rows of the vertices that this rank owns.
DataArray own_rows(const DistributedSurface& surface, const DataArray& array);

}  // namespace brindle::tool
