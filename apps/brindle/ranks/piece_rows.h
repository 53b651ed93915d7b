/// File rows of vertices, distributed to partitions.
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
#include "ranks/mesh_pieces.h"

namespace brindle::tool {

/// Collective. Rank 0 reads a file with rows for the vertices of the whole mesh: `rows` returns
/// arrays with a row each. Returns those of the partition's vertices. Throws on all ranks what
/// `rows` throws, and Error for vertices without file numbers or with numbers beyond the rows.
/// `option` names the file.
std::vector<DataArray> piece_rows(Communicator& ranks, const ReadPiece& read,
                                  const std::string& option, const std::string& file,
                                  const std::function<std::vector<DataArray>()>& rows);

/// An array at the vertices of a partition.
struct ArrayAtVertices {
  DataArray array;                 ///< a row per vertex of the piece
  std::size_t rows_nonfinite = 0;  ///< of all ranks, in the array as read
  /// The original rows per triangle of the partition, if it is a cell array of the mesh.
  std::optional<DataArray> of_cells = std::nullopt;
};

/// Arrays of the mesh's file, or of another one that every rank reads (--field-mesh).
class PieceArrays {
 public:
  /// Collective. Throws Error on all ranks if the other file cannot be read.
  PieceArrays(Communicator& ranks, const DistributedSurface& surface, const ReadPiece& read,
              const ArrayOptions& options);

  /// Collective. The array NAME, points/NAME or cells/NAME; cell arrays are transferred to the
  /// vertices. Throws Error on all ranks if there is none.
  ArrayAtVertices array(const std::string& name) const;

  /// Collective. As `ArraySource::drop_too_far`, on all ranks.
  std::optional<std::size_t> drop_too_far(DirectionField& directions) const;

  /// Whether the other file's mesh is near enough to a vertex; true without another file.
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

/// Collective. As `copy_from_partners` of array_rows.h; partners on rank 0 may belong to other
/// ranks.
void copy_from_partners(Communicator& ranks, const DistributedSurface& surface,
                        const ReadPiece& read, std::vector<DataArray>& arrays);

/// Collective. For each vertex of the partition, the largest flag, 0 or 1, of all ranks.
std::vector<float> flags_of_all(Communicator& ranks, const ReadPiece& read,
                                std::vector<float> flags);

/// Own vertices of this rank that have neighbours.
std::vector<std::uint8_t> used_own(const DistributedSurface& surface);

/// Rows of own vertices.
DataArray own_rows(const DistributedSurface& surface, const DataArray& array);

}  // namespace brindle::tool
