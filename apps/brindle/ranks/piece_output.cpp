#include "ranks/piece_output.h"

#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/error.h"
#include "brindle/files/vtk/pvtp_file.h"
#include "brindle/files/vtk/vtp_file.h"
#include "brindle/files/written_arrays.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

void put_arrays(OutputStream& out, std::string_view element, std::span<const DataArray> arrays) {
  out << '<' << element << ">\n";
  for (const DataArray& array : arrays) {
    out << "<PDataArray type=\"" << vtk_type(array.type) << "\" Name=\"" << xml_text(array.name)
        << "\" NumberOfComponents=\"" << array.components << "\"/>\n";
  }
  out << "</" << element << ">\n";
}

void write_index(const fs::path& pvtp, int ranks, const Eigen::Vector3d& origin,
                 const DataArrays& arrays) {
  check_name_in_xml(pvtp);  // pieces have the same name
  write_file(pvtp, [&](OutputStream& out) {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PPolyData\" version=\"1.0\" "
           "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PPolyData GhostLevel=\"0\">\n";
    put_arrays(out, "PPointData", arrays.points);
    put_arrays(out, "PCellData", arrays.cells);
    out << "<PPoints>\n<PDataArray type=\"" << (origin.isZero(0) ? "Float32" : "Float64")
        << "\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
    for (int r = 0; r < ranks; ++r) {
      out << "<Piece Source=\"" << xml_text(piece_path(pvtp, r).filename().string()) << "\"/>\n";
    }
    out << "</PPolyData>\n</VTKFile>\n";
  });
}

/// Pieces that an older .pvtp of this name lists beyond `ranks`, left by a run with more ranks.
std::vector<fs::path> older_pieces(const fs::path& pvtp, int ranks) {
  std::error_code ignored;
  if (!fs::exists(pvtp, ignored)) return {};
  std::set<fs::path> named;
  try {
    for (const fs::path& piece : read_pvtp(pvtp).pieces) named.insert(piece.lexically_normal());
  } catch (const Error&) {
    return {};  // not written by Brindle
  }
  // Ignores other names in the list.
  std::vector<fs::path> older;
  for (int r = ranks; r < ranks + static_cast<int>(named.size()); ++r) {
    const fs::path piece = piece_path(pvtp, r);
    if (named.contains(piece.lexically_normal())) older.push_back(piece);
  }
  return older;
}

}  // namespace

std::vector<UsedFile> files_of_pieces(const std::filesystem::path& pvtp, int ranks) {
  std::vector<UsedFile> files = {{"--output", pvtp}};
  for (int r = 0; r < ranks; ++r) files.push_back({"--output", piece_path(pvtp, r)});
  for (const fs::path& piece : older_pieces(pvtp, ranks)) files.push_back({"--output", piece});
  return files;
}

fs::path piece_path(const fs::path& pvtp, int rank) {
  fs::path path = pvtp;
  path.replace_filename(pvtp.stem().string() + "_" + std::to_string(rank) + ".vtp");
  return path;
}

void check_pieces(Communicator& ranks, const fs::path& pvtp) {
  ranks.throw_on_all([&] {
    check_output_path(piece_path(pvtp, ranks.rank()));
    if (ranks.rank() == 0) check_output_path(pvtp);
  });
}

void write_pieces(Communicator& ranks, const fs::path& pvtp, const Mesh& mesh,
                  const DataArrays& arrays) {
  write_pieces(ranks, pvtp, mesh.origin, arrays, [&](OutputStream& out, const fs::path& piece) {
    check_rows(piece, arrays.points, mesh.vertex_count(), "vertex");
    check_rows(piece, arrays.cells, mesh.triangle_count(), "triangle");
    write_vtp(out, {.points = mesh.positions,
                    .triangles = mesh.triangles,
                    .point_arrays = arrays.points,
                    .cell_arrays = arrays.cells,
                    .origin = mesh.origin});
  });
}

void write_pieces(Communicator& ranks, const fs::path& pvtp, const Eigen::Vector3d& origin,
                  const DataArrays& arrays, const PieceWriter& write) {
  const fs::path path = piece_path(pvtp, ranks.rank());
  std::optional<UnfinishedFile> piece;
  ranks.throw_on_all([&] {
    piece.emplace(path);
    piece->write([&](OutputStream& out) { write(out, path); });
  });
  ranks.throw_on_all([&] { piece->finish(); });
  ranks.throw_on_all([&] {
    if (ranks.rank() != 0) return;
    const std::vector<fs::path> older = older_pieces(pvtp, ranks.size());
    write_index(pvtp, ranks.size(), origin, arrays);
    for (const fs::path& old : older) {
      std::error_code ignored;  // a leftover file does no harm
      fs::remove(old, ignored);
    }
  });
}

}  // namespace brindle::tool
