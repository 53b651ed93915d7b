#include "ranks/mesh_pieces.h"

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/distributed/surface/partition.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "input/array_source.h"
#include "input/preparation.h"
#include "ranks/pvtp_pieces.h"
#include "ranks/rank_arrays.h"
#include "ranks/request.h"

namespace brindle::tool {
namespace {

/// On rank 0.
LoadedSurface load_whole(const SurfaceOptions& options, JobListener& listener) {
  refuse_points(options, "stripe");
  listener.stage("loading " + options.mesh);
  SurfaceOptions coarse = options;
  coarse.subdivide = 0;  // ranks subdivide their partitions
  LoadedSurface loaded = load_mesh(coarse, listener.progress());
  listener.note(describe(loaded));
  return loaded;
}

using Position = std::array<float, 3>;

/// Parts of partitions to send, one list per rank.
struct PackedPieces {
  std::vector<std::vector<std::uint64_t>> ids, triangle_ids;
  std::vector<std::vector<Position>> positions;
  std::vector<std::vector<Triangle>> triangles;

  explicit PackedPieces(std::size_t ranks)
      : ids(ranks), triangle_ids(ranks), positions(ranks), triangles(ranks) {}
};

PackedPieces pack_pieces(const Mesh& mesh, std::size_t ranks) {
  PackedPieces packed(ranks);
  const std::vector<int> rank_of_triangle = partition_by_curve(mesh, static_cast<int>(ranks));
  for (std::size_t r = 0; r < ranks; ++r) {
    SurfacePiece piece = piece_of(mesh, rank_of_triangle, static_cast<int>(r));
    packed.ids[r] = std::move(piece.vertex_ids);
    packed.triangle_ids[r] = std::move(piece.triangle_ids);
    for (const Vec3& p : piece.mesh.positions) packed.positions[r].push_back({p.x(), p.y(), p.z()});
    packed.triangles[r] = std::move(piece.mesh.triangles);
  }
  return packed;
}

/// The requested arrays of a file.
DataArrays wanted_of(DataArrays arrays, const WantedArrays& wanted, const std::string& file) {
  DataArrays named = named_arrays(arrays, wanted.names, file);
  return wanted.all ? std::move(arrays) : std::move(named);
}

/// Rows of the whole mesh on each rank.
std::vector<std::vector<Index>> rows_of_ranks(const std::vector<std::vector<std::uint64_t>>& ids) {
  std::vector<std::vector<Index>> rows;
  for (const auto& list : ids) rows.emplace_back(list.begin(), list.end());
  return rows;
}

/// Empty for shapes that can only be made as a whole.
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

/// Rank 0 reads or makes the whole mesh and sends partitions to the others.
ReadPiece cut_piece(Communicator& ranks, const SurfaceOptions& options, const WantedArrays& wanted,
                    JobListener& listener) {
  PackedPieces packed(static_cast<std::size_t>(ranks.size()));
  DataArrays arrays;
  std::vector<DataArray> original;
  std::array<double, 3> origin{};
  ReadPiece result;
  on_first_rank(ranks, [&] {
    LoadedSurface loaded = load_whole(options, listener);
    result.vertices_joined = loaded.repair.vertices_joined;
    original.push_back(make_data_array("original_id", 1, original_ids_of(loaded)));
    if (!loaded.renumbered) result.partners = loaded.vertex_of_row;
    if (options.subdivide == 0) result.vertex_of_row = std::move(loaded.vertex_of_row);
    for (int k = 0; k < 3; ++k) origin[static_cast<std::size_t>(k)] = loaded.mesh.origin[k];
    arrays = wanted_of(std::move(loaded.arrays), wanted, options.mesh);
    packed = pack_pieces(loaded.mesh, static_cast<std::size_t>(ranks.size()));
  });
  result.arrays.points = scattered_rows(ranks, arrays.points, rows_of_ranks(packed.ids));
  const auto numbers = scattered_rows(ranks, original, rows_of_ranks(packed.ids));
  for (const double id : doubles_of(numbers[0].view())) {
    result.original_ids.push_back(static_cast<std::int64_t>(id));
  }
  result.arrays.cells = scattered_rows(ranks, arrays.cells, rows_of_ranks(packed.triangle_ids));
  result.piece.vertex_ids = ranks.swap_lists(packed.ids)[0];
  result.piece.triangle_ids = ranks.swap_lists(packed.triangle_ids)[0];
  const auto positions = ranks.swap_lists(packed.positions);
  for (const auto& [x, y, z] : positions[0]) {
    result.piece.mesh.positions.emplace_back(x, y, z);
  }
  result.piece.mesh.triangles = ranks.swap_lists(packed.triangles)[0];
  const auto [x, y, z] = ranks.all(origin)[0];
  result.piece.mesh.origin = {x, y, z};
  result.vertices_joined = ranks.all(result.vertices_joined)[0];
  return result;
}

void subdivide_piece(Communicator& ranks, int times, ReadPiece& read) {
  std::unordered_map<std::uint64_t, std::int64_t> original;
  for (std::size_t v = 0; v < read.original_ids.size(); ++v) {
    original[read.piece.vertex_ids[v]] = read.original_ids[v];
  }
  read.piece = subdivided_piece(ranks, std::move(read.piece), read.arrays, times);
  if (!read.numbered) return;
  read.original_ids.clear();
  for (const std::uint64_t id : read.piece.vertex_ids) {
    const auto found = original.find(id);
    read.original_ids.push_back(found == original.end() ? -1 : found->second);
  }
}

}  // namespace

ReadPiece read_piece(Communicator& ranks, const SurfaceOptions& options, const WantedArrays& wanted,
                     JobListener& listener) {
  ReadPiece read;
  if (is_pvtp(options.mesh)) {
    read = read_pvtp_pieces(ranks, options.mesh, wanted, listener);
    read.piece.triangle_ids = ranks.numbers_of(read.piece.mesh.triangle_count());
  } else if (auto made = make_piece(ranks, options)) {
    wanted_of({}, wanted, options.mesh);  // shapes have no arrays
    read = std::move(*made);
    read.piece.triangle_ids = ranks.numbers_of(read.piece.mesh.triangle_count());
  } else {
    read = cut_piece(ranks, options, wanted, listener);
  }
  read.file = options.mesh;
  if (read.original_ids.empty() && read.numbered) {
    read.original_ids.assign(read.piece.vertex_ids.begin(), read.piece.vertex_ids.end());
  }
  read.subdivided = options.subdivide;
  if (options.subdivide > 0) subdivide_piece(ranks, options.subdivide, read);
  read.row_ids = read.piece.vertex_ids;
  return read;
}

DistributedSurface make_piece_surface(ReadPiece& read, const SurfaceOptions& options) {
  DistributedSurface surface(read.piece, MPI_COMM_WORLD);
  auto copied = split_at_creases(surface, read.piece, options.crease_angle.value_or(kCreaseAngle));
  if (!copied) return surface;
  const Creases of_piece{std::move(*copied), {}};
  add_rows_of_copies(of_piece, read.original_ids);
  add_rows_of_copies(of_piece, read.row_ids);
  add_rows_of_copies(of_piece, read.arrays);
  return DistributedSurface(read.piece, MPI_COMM_WORLD);
}

}  // namespace brindle::tool
