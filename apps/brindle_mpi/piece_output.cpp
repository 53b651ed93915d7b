#include "piece_output.h"

#include <ostream>
#include <random>
#include <span>
#include <string_view>

#include "brindle/base/output_file.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/vtp_file.h"
#include "brindle/files/xml_text.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

void put_arrays(std::ostream& out, std::string_view element, std::span<const DataArray> arrays) {
  out << '<' << element << ">\n";
  for (const DataArray& array : arrays) {
    out << "<PDataArray type=\"" << vtk_type(array.type) << "\" Name=\"" << xml_text(array.name)
        << "\" NumberOfComponents=\"" << array.components << "\"/>\n";
  }
  out << "</" << element << ">\n";
}

void write_index(const fs::path& pvtp, int ranks, const Eigen::Vector3d& origin,
                 const DataArrays& arrays) {
  write_file(pvtp, [&](std::ostream& out) {
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

fs::path temporary_name(const fs::path& piece) {
  std::random_device seed;
  fs::path name = piece;
  name.replace_extension(".tmp" + std::to_string(seed()) + ".vtp");
  return name;
}

/// A file that goes unless it gets its name.
class TemporaryPiece {
 public:
  explicit TemporaryPiece(const fs::path& path) : path_(path), temporary_(temporary_name(path)) {}
  ~TemporaryPiece() {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  }
  TemporaryPiece(const TemporaryPiece&) = delete;
  TemporaryPiece& operator=(const TemporaryPiece&) = delete;

  const fs::path& path() const { return temporary_; }
  void rename() const { fs::rename(temporary_, path_); }

 private:
  fs::path path_, temporary_;
};

}  // namespace

std::vector<UsedFile> files_of_pieces(const std::string& pvtp, int ranks) {
  std::vector<UsedFile> files = {{"--output", pvtp}};
  for (int r = 0; r < ranks; ++r) files.push_back({"--output", piece_path(pvtp, r)});
  return files;
}

fs::path piece_path(const fs::path& pvtp, int rank) {
  fs::path path = pvtp;
  path.replace_filename(pvtp.stem().string() + "_" + std::to_string(rank) + ".vtp");
  return path;
}

void check_pieces(Communicator& ranks, const fs::path& pvtp) {
  ranks.together([&] {
    check_output_path(piece_path(pvtp, ranks.rank()));
    if (ranks.rank() == 0) check_output_path(pvtp);
  });
}

void write_pieces(Communicator& ranks, const fs::path& pvtp, const Mesh& mesh,
                  const DataArrays& arrays) {
  write_pieces(ranks, pvtp, mesh.origin, arrays, [&](const fs::path& piece) {
    write_mesh(piece, mesh, arrays.points, arrays.cells);
  });
}

void write_pieces(Communicator& ranks, const fs::path& pvtp, const Eigen::Vector3d& origin,
                  const DataArrays& arrays, const std::function<void(const fs::path&)>& write) {
  const TemporaryPiece piece(piece_path(pvtp, ranks.rank()));
  ranks.together([&] { write(piece.path()); });
  ranks.together([&] { piece.rename(); });
  ranks.together([&] {
    if (ranks.rank() == 0) write_index(pvtp, ranks.size(), origin, arrays);
  });
}

}  // namespace brindle::tool
