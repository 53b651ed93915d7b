#include "mesh_pieces.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "array_source.h"
#include "brindle/base/array_numbers.h"
#include "brindle/distributed/partition.h"
#include "brindle/distributed/subdivided_piece.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "pvtp_pieces.h"

namespace brindle::tool {
namespace {

/// On rank 0.
LoadedSurface load_whole(const SurfaceOptions& options, JobListener& listener) {
  refuse_points(options, "stripe");
  listener.stage("loading " + options.mesh);
  SurfaceOptions coarse = options;
  coarse.subdivide = 0;  // what ranks do with their pieces
  LoadedSurface loaded = load_mesh(coarse, listener.progress());
  listener.note(describe(loaded));
  return loaded;
}

/// As `together`, with wrong usage on rank 0 staying wrong usage on all.
void on_first_rank(Communicator& ranks, const std::function<void()>& work) {
  bool wrong_usage = false;
  const auto noted = [&] {
    if (ranks.rank() != 0) return;
    try {
      work();
    } catch (const CLI::ParseError& error) {
      wrong_usage = true;
      throw Error(error.what());
    }
  };
  try {
    ranks.together(noted);
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    if (ranks.any(wrong_usage))
      throw CLI::ValidationError(error.what(), CLI::ExitCodes::ValidationError);
    throw;
  }
}

using Position = std::array<float, 3>;

/// What travels of a piece, a list per rank each.
struct PackedPieces {
  std::vector<std::vector<std::uint64_t>> ids;
  std::vector<std::vector<Position>> positions;
  std::vector<std::vector<Triangle>> triangles;
  std::vector<std::vector<std::vector<std::byte>>> arrays;  ///< of every array

  PackedPieces(std::size_t ranks, std::size_t array_count)
      : ids(ranks),
        positions(ranks),
        triangles(ranks),
        arrays(array_count, std::vector<std::vector<std::byte>>(ranks)) {}
};

PackedPieces pack_pieces(const Mesh& mesh, std::span<const DataArray> arrays, std::size_t ranks) {
  PackedPieces packed(ranks, arrays.size());
  const std::vector<int> rank_of_triangle = partition_by_curve(mesh, static_cast<int>(ranks));
  for (std::size_t r = 0; r < ranks; ++r) {
    SurfacePiece piece = piece_of(mesh, rank_of_triangle, static_cast<int>(r));
    const std::vector<Index> rows(piece.vertex_ids.begin(), piece.vertex_ids.end());
    for (std::size_t a = 0; a < arrays.size(); ++a) {
      packed.arrays[a][r] = rows_of(arrays[a], rows).bytes;
    }
    packed.ids[r] = std::move(piece.vertex_ids);
    for (const Vec3& p : piece.mesh.positions) packed.positions[r].push_back({p.x(), p.y(), p.z()});
    packed.triangles[r] = std::move(piece.mesh.triangles);
  }
  return packed;
}

/// Arrays of points by the names that were asked for.
std::vector<DataArray> arrays_named(const DataArrays& arrays, const std::vector<std::string>& names,
                                    const std::string& file) {
  std::vector<DataArray> found;
  for (const std::string& name : names) {
    found.push_back(as_doubles(array_named({arrays.points, {}}, name, file), name));
  }
  return found;
}

/// Nothing for shapes that are made whole alone.
std::optional<ReadPiece> make_piece(const Communicator& ranks, const SurfaceOptions& options) {
  if (!is_shape(options)) return std::nullopt;
  try {
    auto part = make_shape_part(shape_spec(options), ranks.rank(), ranks.size());
    if (!part) return std::nullopt;
    ReadPiece result;
    result.piece = {std::move(part->mesh), std::move(part->vertex_ids), {}};
    return result;
  } catch (const Error& error) {
    throw CLI::ValidationError("MESH", error.what());
  }
}

/// Rank 0 reads or makes the whole and sends the others their pieces.
ReadPiece cut_piece(Communicator& ranks, const SurfaceOptions& options,
                    const std::vector<std::string>& names, JobListener& listener) {
  PackedPieces packed(static_cast<std::size_t>(ranks.size()), names.size());
  std::vector<int> components(names.size());
  std::array<double, 3> origin{};
  std::size_t joined = 0;
  std::vector<Index> vertex_of_row;
  on_first_rank(ranks, [&] {
    const LoadedSurface loaded = load_whole(options, listener);
    joined = loaded.repair.vertices_joined;
    if (options.subdivide == 0) vertex_of_row = loaded.vertex_of_row;
    for (int k = 0; k < 3; ++k) origin[static_cast<std::size_t>(k)] = loaded.mesh.origin[k];
    const std::vector<DataArray> arrays = arrays_named(loaded.arrays, names, options.mesh);
    for (std::size_t a = 0; a < names.size(); ++a) components[a] = arrays[a].components;
    packed = pack_pieces(loaded.mesh, arrays, static_cast<std::size_t>(ranks.size()));
  });
  ReadPiece result;
  result.piece.vertex_ids = ranks.swap_lists(packed.ids)[0];
  const auto positions = ranks.swap_lists(packed.positions);
  for (const auto& [x, y, z] : positions[0]) {
    result.piece.mesh.positions.emplace_back(x, y, z);
  }
  result.piece.mesh.triangles = ranks.swap_lists(packed.triangles)[0];
  const auto [x, y, z] = ranks.all(origin)[0];
  result.piece.mesh.origin = {x, y, z};
  result.vertices_joined = ranks.all(joined)[0];
  result.vertex_of_row = std::move(vertex_of_row);
  for (std::size_t a = 0; a < names.size(); ++a) {
    result.arrays.push_back({names[a], NumberType::float64, ranks.all(components[a])[0],
                             ranks.swap_lists(packed.arrays[a])[0]});
  }
  return result;
}

}  // namespace

DataArray as_doubles(const DataArray& array, const std::string& name) {
  return make_data_array(name, array.components, doubles_of(array.view()));
}

ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options,
                     const std::vector<std::string>& arrays, JobListener& listener) {
  ReadPiece read;
  if (is_pvtp(options.mesh)) {
    read = read_pvtp_pieces(ranks, options.mesh, arrays, listener);
  } else if (auto made = make_piece(ranks, options)) {
    arrays_named({}, arrays, options.mesh);  // shapes have none
    read = std::move(*made);
  } else {
    read = cut_piece(ranks, options, arrays, listener);
  }
  if (options.subdivide > 0) {
    read.piece = subdivided_piece(ranks, std::move(read.piece), options.subdivide);
  }
  return read;
}

}  // namespace brindle::tool
