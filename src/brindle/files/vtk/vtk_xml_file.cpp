#include "brindle/error.h"
#include "brindle/files/vtk/vtk_file.h"

#ifdef BRINDLE_HAS_VTK

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/files/vtk/vtk_surface.h"
#include "brindle/files/vtk/vtk_xml_arrays.h"

namespace brindle {
namespace {

using Xml = pugi::xml_node;

constexpr std::string_view kAppendedTag = "<AppendedData";
constexpr std::size_t kFirstChunk = std::size_t{1} << 16;

/// The XML of a file without its appended data, which is not XML.
struct XmlPart {
  std::string text;            ///< up to and including the tag of appended data, closed
  std::uint64_t appended = 0;  ///< position of the data, or 0
};

void grow(InputFile& file, std::string& text, std::uint64_t size) {
  const std::size_t begin = text.size();
  text.resize(std::min(size, file.size()));
  file.read_at(begin, std::as_writable_bytes(std::span(text).subspan(begin)));
}

XmlPart xml_part(InputFile& file) {
  XmlPart part;
  std::string& text = part.text;
  std::size_t tag = std::string::npos, searched = 0;
  while (tag == std::string::npos && text.size() < file.size()) {
    grow(file, text, std::max<std::uint64_t>(kFirstChunk, 4 * text.size()));
    tag = text.find(kAppendedTag, searched);
    searched = text.size() - std::min(text.size(), kAppendedTag.size());
  }
  if (tag == std::string::npos) return part;
  grow(file, text, std::max<std::uint64_t>(text.size(), tag + kFirstChunk));
  const std::size_t tag_end = std::min(text.find('>', tag), text.size());
  const std::size_t mark = std::min(text.find('_', tag_end), text.size());
  if (mark < text.size()) part.appended = mark + 1;
  text.resize(tag_end);
  text += text.ends_with('/') ? "></VTKFile>" : "/></VTKFile>";
  return part;
}

/// The line number of a position.
std::size_t line_of(std::string_view text, std::ptrdiff_t place) {
  const auto end =
      std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(place, 0)), text.size());
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + end, '\n'));
}

class VtkXmlReader {
 public:
  VtkXmlReader(const std::filesystem::path& path, const Progress& progress)
      : file_(path, progress),
        part_(xml_part(file_)),
        root_(parsed()),
        arrays_(file_, encoding()) {}

  RawMesh read(std::vector<Eigen::Vector3d>* exact) {
    VtkSurface surface(file_.name());
    for_each_piece([&](const Xml& piece) { surface.add(read_piece(piece)); });
    RawMesh raw = surface.take(exact);
    raw.left_out += left_out_;
    return raw;
  }

 private:
  [[noreturn]] void fail_damaged(const std::string& what) const {
    file_.fail_whole(what + "; the file is damaged or truncated, copy or export it again");
  }

  Xml parsed() {
    const pugi::xml_parse_result result =
        document_.load_buffer_inplace(part_.text.data(), part_.text.size());
    const Xml root = document_.child("VTKFile");
    if (!result) {
      file_.fail_at(line_of(part_.text, result.offset),
                    "the XML cannot be read (" + std::string(result.description()) +
                        "); the file is damaged or truncated, copy or export it again");
    }
    if (!root) file_.fail_whole("is no VTK file: it has no element 'VTKFile'; export it again");
    return root;
  }

  std::string_view attribute(const char* name) const { return root_.attribute(name).value(); }

  bool is_grid() const { return attribute("type") == "UnstructuredGrid"; }

  VtkXmlEncoding encoding() const {
    if (attribute("type") != "PolyData" && !is_grid()) {
      file_.fail_whole("holds " + in_quotes(attribute("type")) +
                       ", not PolyData or an UnstructuredGrid; in ParaView, apply the filter "
                       "Extract Surface and save its result as .vtp");
    }
    const std::string_view order = attribute("byte_order"), sizes = attribute("header_type"),
                           compressor = attribute("compressor");
    if (!order.empty() && order != "LittleEndian" && order != "BigEndian") {
      fail_damaged("has the unknown byte order " + in_quotes(order));
    }
    if (!sizes.empty() && sizes != "UInt32" && sizes != "UInt64") {
      fail_damaged("has block sizes of the unknown type " + in_quotes(sizes));
    }
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      file_.fail_whole("is compressed by " + in_quotes(compressor) +
                       ", which brindle does not read; in ParaView, save it with the compressor "
                       "ZLib or None");
    }
    VtkXmlEncoding encoding;
    constexpr bool kBigHere = std::endian::native == std::endian::big;
    encoding.foreign_order = !order.empty() && (order == "BigEndian") != kBigHere;
    encoding.wide_sizes = sizes == "UInt64";
    encoding.zlib = !compressor.empty();
    encoding.appended = part_.appended;
    const std::string_view appended = root_.child("AppendedData").attribute("encoding").value();
    encoding.appended_base64 = part_.appended != 0 && appended == "base64";
    if (part_.appended != 0 && appended != "base64" && appended != "raw") {
      fail_damaged("has appended data in the unknown encoding " + in_quotes(appended));
    }
    return encoding;
  }

  template <class Use>
  void for_each_piece(const Use& use) {
    const Xml data = root_.child(is_grid() ? "UnstructuredGrid" : "PolyData");
    if (!data) fail_damaged("has no element " + in_quotes(attribute("type")));
    for (const Xml& piece : data.children("Piece")) use(piece);
  }

  std::uint64_t count(const Xml& piece, const char* name) const {
    constexpr std::uint64_t kMost = 0xfffffffe;
    const std::uint64_t number = vtk_number(file_, piece, name);
    if (number > kMost) {
      file_.fail_whole("has more points or cells than brindle can number; split it into parts");
    }
    return number;
  }

  VtkPiece read_piece(const Xml& piece) {
    VtkPiece result;
    const std::uint64_t points = count(piece, "NumberOfPoints");
    result.points = read_points(piece, points);
    std::uint64_t cells = 0;
    const auto add = [&](const char* element, const char* number, std::uint8_t type) {
      result.cells.push_back(read_cells(piece.child(element), count(piece, number)));
      result.cells.back().type = type;
      cells += count(piece, number);
    };
    if (is_grid()) {
      add("Cells", "NumberOfCells", 0);
      result.cells.back().types = read_types(piece);
    } else {
      // Cell data are in this order.
      add("Verts", "NumberOfVerts", kVtkPolyVertex);
      add("Lines", "NumberOfLines", kVtkPolyLine);
      add("Polys", "NumberOfPolys", kVtkPolygon);
      add("Strips", "NumberOfStrips", kVtkTriangleStrip);
    }
    result.arrays.points = read_data(piece.child("PointData"), points);
    result.arrays.cells = read_data(piece.child("CellData"), cells);
    result.normals = piece.child("PointData").attribute("Normals").value();
    return result;
  }

  DataArray read_points(const Xml& piece, std::uint64_t points) {
    const Xml element = piece.child("Points").child("DataArray");
    if (points == 0) return {"Points", NumberType::float32, 3, {}};
    if (!element) fail_damaged("has no coordinates for its points");
    DataArray result = arrays_.read(element, points);
    if (result.components != 3) fail_damaged("has points without three coordinates");
    return result;
  }

  static Xml named(const Xml& element, const char* name) {
    return element.find_child_by_attribute("DataArray", "Name", name);
  }

  DataArray read_column(const Xml& element, std::uint64_t rows) {
    DataArray column = arrays_.read(element, rows);
    if (column.components != 1) {
      fail_damaged("has " + in_quotes(column.name) + " of cells with several components");
    }
    return column;
  }

  VtkCells read_cells(const Xml& element, std::uint64_t cells) {
    VtkCells result;
    if (cells == 0) return result;
    const Xml points = named(element, "connectivity"), ends = named(element, "offsets");
    if (!points || !ends) fail_damaged("lacks the points of its cells");
    result.ends = read_column(ends, cells);
    result.points = read_column(points, vtk_points_of_cells(result.ends));
    return result;
  }

  std::vector<std::uint8_t> read_types(const Xml& piece) {
    const std::uint64_t cells = count(piece, "NumberOfCells");
    if (cells == 0) return {};
    const Xml element = named(piece.child("Cells"), "types");
    if (!element) fail_damaged("lacks the types of its cells");
    return vtk_cell_types(read_column(element, cells));
  }

  /// The arrays of points or cells.
  std::vector<DataArray> read_data(const Xml& element, std::uint64_t rows) {
    std::vector<DataArray> result;
    for (const Xml& array : element.children()) {
      if (array.type() != pugi::node_element) continue;
      if (VtkXmlArrays::holds_numbers(array)) {
        result.push_back(arrays_.read(array, rows));
      } else {
        left_out_ += "array " + in_quotes(array.attribute("Name").value()) +
                     ": left out, because it does not hold numbers\n";
      }
    }
    return result;
  }

  InputFile file_;
  XmlPart part_;
  pugi::xml_document document_;
  Xml root_;
  VtkXmlArrays arrays_;
  std::string left_out_;
};

}  // namespace

RawMesh read_vtk_xml(const std::filesystem::path& path, const Progress& progress,
                     std::vector<Eigen::Vector3d>* exact) {
  return VtkXmlReader(path, progress).read(exact);
}

}  // namespace brindle

#else

namespace brindle {
namespace {

[[noreturn]] void refuse_vtk(const std::filesystem::path& path) {
  throw Error(shown(path.string()) +
              ": this brindle was built without BRINDLE_VTK (pugixml and zlib) and so reads no "
              ".vtp and .vtu; save the mesh as .vtk or .ply");
}

}  // namespace

RawMesh read_vtk_xml(const std::filesystem::path& path, const Progress& /*progress*/,
                     std::vector<Eigen::Vector3d>* /*exact*/) {
  refuse_vtk(path);
}

}  // namespace brindle

#endif  // BRINDLE_HAS_VTK
