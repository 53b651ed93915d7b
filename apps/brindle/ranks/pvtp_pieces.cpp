#include "ranks/pvtp_pieces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/array_numbers.h"
#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/distributed/surface/shared_vertices.h"
#include "brindle/error.h"
#include "brindle/files/vtk/pvtp_file.h"
#include "brindle/files/vtk/vtk_file.h"
#include "brindle/local_positions.h"
#include "input/array_source.h"
#include "ranks/rank_arrays.h"
#include "ranks/request.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

/// Names of global point numbers in Brindle, VTK and other programs.
constexpr std::array<std::string_view, 6> kIdNames = {
    "global_id", "globalpointids", "globalnodeids", "globalnodeid", "vtkglobalids", "globalids"};

/// Relative to the diagonal: vertices of one number that are farther apart are an error. Rounding
/// differences between pieces are far smaller.
constexpr double kMostTorn = 1e-4;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

const DataArray* find_ids(const PieceList& list, std::span<const DataArray> arrays) {
  if (!list.global_ids.empty()) {
    if (const DataArray* named = find_array(arrays, list.global_ids)) return named;
  }
  for (const std::string_view name : kIdNames) {
    for (const DataArray& array : arrays) {
      if (lower(array.name) == name) return &array;
    }
  }
  return nullptr;
}

std::vector<std::uint64_t> numbers_of(const fs::path& piece, const DataArray& ids) {
  if (ids.components != 1 || is_floating(ids.type)) {
    throw Error(shown(piece.native()) + ": array " + in_quotes(ids.name) +
                " should number the vertices and holds no whole numbers; write it as Int64");
  }
  std::vector<std::uint64_t> numbers;
  numbers.reserve(ids.rows());
  for_each_number(ids.view(), [&](std::size_t row, std::size_t, auto number) {
    if (number < 0) {
      throw Error(shown(piece.native()) + ": array " + in_quotes(ids.name) + " has " +
                  std::to_string(static_cast<std::int64_t>(number)) + " for point " +
                  std::to_string(row) + "; numbers of vertices are not below zero");
    }
    numbers.push_back(static_cast<std::uint64_t>(number));
  });
  return numbers;
}

/// Whether another piece has the triangle: a bit in VTK's ghost types, or a layer number in older
/// files.
std::vector<std::uint8_t> ghosts_of(std::span<const DataArray> cells, std::size_t triangles) {
  constexpr double kDuplicate = 1;
  std::vector<std::uint8_t> ghosts(triangles);
  if (const DataArray* types = find_array(cells, "vtkGhostType");
      types && !is_floating(types->type)) {
    for_each_number(types->view(), [&](std::size_t row, std::size_t, auto type) {
      ghosts[row] = std::fmod(static_cast<double>(type), 2 * kDuplicate) >= kDuplicate;
    });
  } else if (const DataArray* layers = find_array(cells, "vtkGhostLevels")) {
    for_each_number(layers->view(),
                    [&](std::size_t row, std::size_t, auto layer) { ghosts[row] = layer > 0; });
  }
  return ghosts;
}

[[noreturn]] void refuse_unlike(const std::string& path, const std::string& array) {
  throw Error(
      path + ": array " + in_quotes(array) +
      " has another type or number of components than in other pieces, or is missing there; "
      "export the pieces again");
}

/// Throws Error unless arrays differ only in their rows.
void check_alike(const std::string& path, std::span<const DataArray> arrays,
                 std::span<const DataArray> others) {
  for (const DataArray& array : arrays) {
    const DataArray* other = find_array(others, array.name);
    if (other == nullptr || other->type != array.type || other->components != array.components) {
      refuse_unlike(path, array.name);
    }
  }
}

void check_alike(const std::string& path, const DataArrays& arrays, const DataArrays& others) {
  check_alike(path, arrays.points, others.points);
  check_alike(path, others.points, arrays.points);
  check_alike(path, arrays.cells, others.cells);
  check_alike(path, others.cells, arrays.cells);
}

/// Names of ghost arrays; written pieces have none.
bool marks_ghosts(std::string_view name) {
  return name == "vtkGhostType" || name == "vtkGhostLevels";
}

/// The requested arrays of one piece, in the same order for all pieces.
DataArrays wanted_of(const DataArrays& arrays, const PieceList& list, const WantedArrays& wanted,
                     const fs::path& path) {
  DataArrays chosen = named_arrays(arrays, wanted.names, path.string());
  if (!wanted.all) return chosen;
  const auto add = [](std::vector<DataArray>& to, const DataArray& array) {
    if (find_array(to, array.name) == nullptr) to.push_back(array);
  };
  // `check_piece_arrays` has checked that they exist.
  for (const PieceArray& announced : list.points) {
    if (!marks_ghosts(announced.name)) {
      add(chosen.points, *find_array(arrays.points, announced.name));
    }
  }
  for (const PieceArray& announced : list.cells) {
    if (!marks_ghosts(announced.name)) add(chosen.cells, *find_array(arrays.cells, announced.name));
  }
  return chosen;
}

/// The concatenated pieces of one rank.
struct RankRows {
  std::vector<Eigen::Vector3d> exact;  ///< coordinates of all rows
  std::vector<std::uint64_t> ids;      ///< of all rows, or empty
  std::vector<std::uint32_t> piece;    ///< of each row, by its number in the .pvtp
  std::vector<std::uint8_t> in_ghost;  ///< by row: used by a ghost triangle
  std::vector<Triangle> triangles;     ///< of rows, without ghosts
  std::size_t ghosts = 0;
  std::optional<fs::path> with_ids, without_ids;  ///< an example of each kind
  std::string left_out;
  DataArrays arrays;  ///< requested arrays, per row and per triangle
  bool any = false;   ///< whether any piece has points
};

/// The first of a rank's pieces: ranks get contiguous runs.
std::size_t first_piece(std::size_t pieces, int rank, int ranks) {
  return pieces * static_cast<std::size_t>(rank) / static_cast<std::size_t>(ranks);
}

/// Reads a rank's pieces.
class PieceReader {
 public:
  PieceReader(const fs::path& pvtp, const WantedArrays& wanted, JobListener& listener)
      : pvtp_(pvtp), wanted_(wanted), listener_(listener) {}

  RankRows read(int rank, int ranks) {
    list_ = read_pvtp(pvtp_);
    const std::size_t end = first_piece(list_.pieces.size(), rank + 1, ranks);
    for (std::size_t p = first_piece(list_.pieces.size(), rank, ranks); p < end; ++p) add(p);
    return std::move(rows_);
  }

  std::size_t piece_count() const { return list_.pieces.size(); }
  const fs::path& piece(std::size_t p) const { return list_.pieces[p]; }

 private:
  void add(std::size_t p) {
    const fs::path& path = list_.pieces[p];
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
      throw Error(shown(pvtp_.native()) + ": names the piece " + in_quotes(path.string()) +
                  ", which is not there; keep all pieces where the .pvtp has them");
    }
    std::vector<Eigen::Vector3d> exact;
    const RawMesh raw = read_vtk_xml(path, listener_.progress(), &exact);
    if (exact.empty()) return;
    check_piece_arrays(path, list_, raw.arrays);
    check_room(path, exact.size());
    const auto first = static_cast<Index>(rows_.exact.size());
    rows_.exact.insert(rows_.exact.end(), exact.begin(), exact.end());
    rows_.piece.resize(rows_.exact.size(), static_cast<std::uint32_t>(p));
    rows_.in_ghost.resize(rows_.exact.size());
    add_ids(path, raw.arrays.points);
    DataArrays arrays = wanted_of(raw.arrays, list_, wanted_, path);
    arrays.cells = rows_of(arrays.cells, add_triangles(raw, first));
    append_rows(std::move(arrays), path);
    note_unannounced(path, raw.arrays);
    std::istringstream lines(raw.left_out);
    for (std::string line; std::getline(lines, line);) {
      rows_.left_out += shown(path.native()) + ": " + line + "\n";
    }
  }

  /// Notes arrays that not all pieces have, which cannot be joined.
  void note_unannounced(const fs::path& path, const DataArrays& arrays) {
    const DataArray* ids = find_ids(list_, arrays.points);
    const auto note = [&](std::span<const DataArray> of_piece, std::span<const PieceArray> known) {
      for (const DataArray& array : of_piece) {
        if (marks_ghosts(array.name) || &array == ids) continue;
        if (std::ranges::find(known, array.name, &PieceArray::name) != known.end()) continue;
        rows_.left_out += path.string() + ": array " + in_quotes(array.name) +
                          " is not announced by " + pvtp_.string() +
                          ", and left out where it is not asked for by its name\n";
      }
    };
    note(arrays.points, list_.points);
    note(arrays.cells, list_.cells);
  }

  void append_rows(DataArrays more, const fs::path& path) {
    if (!std::exchange(rows_.any, true)) {
      rows_.arrays = std::move(more);
      return;
    }
    check_alike(path.string(), more, rows_.arrays);
    const auto append = [](std::vector<DataArray>& to, const std::vector<DataArray>& from) {
      for (DataArray& array : to) {
        const std::vector<std::byte>& bytes = find_array(from, array.name)->bytes;
        array.bytes.insert(array.bytes.end(), bytes.begin(), bytes.end());
      }
    };
    append(rows_.arrays.points, more.points);
    append(rows_.arrays.cells, more.cells);
  }

  void check_room(const fs::path& path, std::size_t more) const {
    if (rows_.exact.size() + more < std::numeric_limits<Index>::max() / 6) return;
    throw Error(shown(path.native()) +
                ": with it a rank has more points than brindle can number; take more ranks");
  }

  void add_ids(const fs::path& path, std::span<const DataArray> arrays) {
    const DataArray* ids = find_ids(list_, arrays);
    (ids ? rows_.with_ids : rows_.without_ids) = path;
    if (!ids) return;
    const std::vector<std::uint64_t> numbers = numbers_of(path, *ids);
    rows_.ids.insert(rows_.ids.end(), numbers.begin(), numbers.end());
  }

  /// Returns the piece's numbers of the triangles.
  std::vector<Index> add_triangles(const RawMesh& raw, Index first) {
    std::vector<Index> kept;
    const auto ghosts = ghosts_of(raw.arrays.cells, raw.mesh.triangle_count());
    for (std::size_t t = 0; t < ghosts.size(); ++t) {
      Triangle triangle = raw.mesh.triangles[t];
      for (Index& v : triangle) v += first;
      rows_.ghosts += ghosts[t];
      if (!ghosts[t]) {
        rows_.triangles.push_back(triangle);
        kept.push_back(static_cast<Index>(t));
        continue;
      }
      for (const Index v : triangle) rows_.in_ghost[v] = 1;
    }
    return kept;
  }

  fs::path pvtp_;
  const WantedArrays& wanted_;
  JobListener& listener_;
  PieceList list_;
  RankRows rows_;
};

/// All pieces have ids, or none.
bool have_ids(Communicator& ranks, const RankRows& rows) {
  const bool any = ranks.any(rows.with_ids.has_value());
  ranks.throw_on_all([&] {
    if (!any || !rows.without_ids) return;
    throw Error(rows.without_ids->string() +
                ": has no global ids of its points, which other pieces have; export the pieces "
                "again, all with them or all without");
  });
  return any;
}

/// The common origin of all ranks, as for one process that read all pieces.
Eigen::Vector3d common_origin(Communicator& ranks, std::span<const Eigen::Vector3d> exact) {
  std::array<double, 6> corners;  // lower corner and negated upper corner
  corners.fill(std::numeric_limits<double>::infinity());
  for (const Eigen::Vector3d& p : exact) {
    if (!(p.array().abs() <= kLargestCoordinate).all()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double coordinate = p[static_cast<Eigen::Index>(k)];
      corners[k] = std::min(corners[k], coordinate);
      corners[k + 3] = std::min(corners[k + 3], -coordinate);
    }
  }
  for (const auto& other : ranks.all(corners)) {
    for (std::size_t k = 0; k < 6; ++k) corners[k] = std::min(corners[k], other[k]);
  }
  Eigen::AlignedBox3d box;
  if (corners[0] <= -corners[3]) {
    box.extend(Eigen::Vector3d(corners[0], corners[1], corners[2]));
    box.extend(-Eigen::Vector3d(corners[3], corners[4], corners[5]));
  }
  return origin_near(box);
}

/// Ranks without pieces get arrays without rows.
void agree_on_arrays(Communicator& ranks, const std::string& path, RankRows& rows) {
  const DataArrays own = {heads_of(rows.arrays.points), heads_of(rows.arrays.cells)};
  DataArrays agreed = agreed_heads(ranks, own);
  ranks.throw_on_all([&] {
    if (rows.any) check_alike(path, own, agreed);
  });
  if (!rows.any) rows.arrays = std::move(agreed);
}

void refuse_torn(Communicator& ranks, const PieceReader& reader, const RankRows& rows,
                 const Mesh& mesh) {
  const BoundingBox box = bounding_box({mesh.positions, {}, {}});
  const auto distance = static_cast<float>(
      kMostTorn * static_cast<double>(ranks.greatest(mesh.positions.empty() ? 0 : box.diagonal())));
  const auto torn = find_torn_vertex(ranks, rows.ids, mesh.positions, rows.piece, distance);
  if (!torn) return;
  const std::string first = shown(reader.piece(torn->label).native()),
                    second = shown(reader.piece(torn->other_label).native());
  throw Error(second + ": its point with the global id " + std::to_string(torn->id) +
              " stands elsewhere than that of " + (first == second ? "another row" : first) +
              "; ids must be numbers in the whole surface: in ParaView, apply the filter Generate "
              "Global Ids, or leave the array out");
}

/// For every row, the first one with its id.
std::vector<Index> first_rows(const std::vector<std::uint64_t>& ids) {
  std::vector<Index> order(ids.size()), first(ids.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order,
                    [&](Index a, Index b) { return std::pair(ids[a], a) < std::pair(ids[b], b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && ids[order[i]] == ids[order[i - 1]];
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Lets triangles use the first row with each id, and keeps the rows that are vertices of this
/// rank: those in triangles, or isolated ones that no triangle of any kind uses. `kept` receives
/// their numbers. Several ranks identify vertices by id alone; a single rank numbers them in the
/// order of ids if `by_id`, so that the pattern is the same.
SurfacePiece joined_piece(Mesh mesh, const RankRows& rows, bool by_id, std::vector<Index>& kept) {
  const std::vector<Index> first = first_rows(rows.ids);
  std::vector<std::uint8_t> wanted(first.size());
  for (Index v = 0; v < first.size(); ++v) {
    wanted[v] = first[v] == v && !rows.in_ghost[v] && mesh.positions[v].allFinite();
  }
  for (Triangle& triangle : mesh.triangles) {
    for (Index& v : triangle) wanted[v = first[v]] = 1;
  }
  for (Index v = 0; v < wanted.size(); ++v) {
    if (wanted[v] != 0) kept.push_back(v);
  }
  if (by_id) std::ranges::sort(kept, {}, [&](Index v) { return rows.ids[v]; });
  SurfacePiece piece;
  piece.mesh.origin = mesh.origin;
  std::vector<Index> number(wanted.size());
  for (const Index v : kept) {
    number[v] = static_cast<Index>(piece.vertex_ids.size());
    piece.vertex_ids.push_back(rows.ids[v]);
    piece.mesh.positions.push_back(mesh.positions[v]);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    piece.mesh.triangles.push_back({number[a], number[b], number[c]});
  }
  return piece;
}

/// Removes triangles that other ranks also have without a ghost marker. Returns their number, and
/// removes them from `kept`.
std::size_t drop_repeated(Communicator& ranks, SurfacePiece& piece, std::vector<Index>& kept) {
  if (ranks.size() == 1) return 0;  // the mesh repair removed them
  const std::vector<std::uint8_t> repeated = repeated_triangles(piece, MPI_COMM_WORLD);
  std::size_t left = 0;
  for (std::size_t t = 0; t < repeated.size(); ++t) {
    if (repeated[t] != 0) continue;
    piece.mesh.triangles[left] = piece.mesh.triangles[t];
    kept[left++] = kept[t];
  }
  piece.mesh.triangles.resize(left);
  kept.resize(left);
  return repeated.size() - left;
}

MeshRepair sum_of(Communicator& ranks, const MeshRepair& own) {
  MeshRepair sum;
  for (const MeshRepair& other : ranks.all(own)) {
    sum.vertices_not_finite += other.vertices_not_finite;
    sum.triangles_out_of_range += other.triangles_out_of_range;
    sum.triangles_not_finite += other.triangles_not_finite;
    sum.triangles_degenerate += other.triangles_degenerate;
    sum.triangles_duplicate += other.triangles_duplicate;
  }
  return sum;
}

/// The text of all ranks, on rank 0.
std::string gathered_text(Communicator& ranks, const std::string& own) {
  std::string text;
  for (const auto& bytes : ranks.gather(std::as_bytes(std::span(own)))) {
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return text;
}

std::string describe_pieces(const std::string& path, std::size_t pieces, int ranks,
                            std::size_t ghosts, bool ids) {
  std::string text;
  if (pieces < static_cast<std::size_t>(ranks)) {
    text += path + ": has " + std::to_string(pieces) + (pieces == 1 ? " piece" : " pieces") +
            " for " + std::to_string(ranks) +
            " ranks: " + std::to_string(static_cast<std::size_t>(ranks) - pieces) +
            " of them have none\n";
  }
  if (!ids) {
    text +=
        path + ": has no global ids: points at exactly the same place are taken for one vertex\n";
  }
  if (ghosts > 0) {
    text += std::to_string(ghosts) + " ghost triangles: left out, other pieces have them\n";
  }
  return text;
}

}  // namespace

bool is_pvtp(const std::string& mesh) { return lower_extension(mesh) == ".pvtp"; }

std::vector<UsedFile> files_of_pvtp(Communicator& ranks, const std::string& path) {
  std::vector<UsedFile> files = {{"MESH", path}};
  check_same_files(ranks, {path});
  std::vector<fs::path> looked_at;
  ranks.throw_on_all([&] {
    const std::vector<fs::path> pieces = read_pvtp(path).pieces;
    for (const fs::path& piece : pieces) files.push_back({"MESH", piece});
    // Each rank reads only its pieces, and checks the first one of the next rank: if two neighbours
    // see different files, they then differ in a file that both see.
    const std::size_t end = first_piece(pieces.size(), ranks.rank() + 1, ranks.size());
    for (std::size_t p = first_piece(pieces.size(), ranks.rank(), ranks.size()); p < end; ++p) {
      looked_at.push_back(pieces[p]);
    }
    looked_at.push_back(pieces[end % pieces.size()]);
  });
  check_same_files(ranks, looked_at);
  return files;
}

ReadPiece read_pvtp_pieces(Communicator& ranks, const std::string& path, const WantedArrays& wanted,
                           JobListener& listener) {
  PieceReader reader(path, wanted, listener);
  RankRows rows;
  ranks.throw_on_all([&] {
    listener.stage("loading " + path);
    rows = reader.read(ranks.rank(), ranks.size());
  });
  const bool ids = have_ids(ranks, rows);
  agree_on_arrays(ranks, path, rows);
  Mesh mesh;
  mesh.origin = common_origin(ranks, rows.exact);
  mesh.positions = positions_about(mesh.origin, std::exchange(rows.exact, {}));
  mesh.triangles = std::move(rows.triangles);
  if (ids) {
    refuse_torn(ranks, reader, rows, mesh);
  } else {
    rows.ids = numbers_by_place(ranks, mesh.positions);
  }
  ReadPiece result;
  result.numbered = ids;
  MeshRepair repair;
  std::vector<Index> vertices, triangles;
  ranks.throw_on_all([&] {
    result.piece = joined_piece(std::move(mesh), rows, ids && ranks.size() == 1, vertices);
    repair = repair_mesh(result.piece.mesh, triangles);
  });
  repair.triangles_duplicate += drop_repeated(ranks, result.piece, triangles);
  ranks.throw_on_all([&] {
    result.arrays = {rows_of(rows.arrays.points, vertices), rows_of(rows.arrays.cells, triangles)};
  });
  if (ranks.sum(result.piece.mesh.triangle_count()) == 0) {
    throw Error(path +
                ": has no usable triangle; export the pieces again, as a surface with faces");
  }
  const std::size_t ghosts = ranks.sum(rows.ghosts);
  listener.note(describe_pieces(path, reader.piece_count(), ranks.size(), ghosts, ids));
  listener.note(describe_origin(result.piece.mesh.origin));
  listener.note(gathered_text(ranks, rows.left_out));
  listener.note(describe(sum_of(ranks, repair)));
  return result;
}

}  // namespace brindle::tool
