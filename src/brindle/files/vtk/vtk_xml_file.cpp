#include "brindle/error.h"
#include "brindle/files/vtk/vtk_file.h"

#ifdef BRINDLE_HAS_VTK

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>
#include <zlib.h>

#include "brindle/base/base64.h"
#include "brindle/base/input_file.h"
#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/data_arrays.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/files/text/text_words.h"
#include "brindle/files/vtk/vtk_surface.h"
#include "brindle/files/vtk/vtp_file.h"

namespace brindle {
namespace {

// Arrays of VTK's XML files in all encodings.

/// The encoding of a file's arrays.
struct VtkXmlEncoding {
  bool foreign_order = false;  ///< the byte order is not that of this machine
  bool wide_sizes = false;     ///< sizes of blocks are UInt64 instead of UInt32
  bool zlib = false;           ///< blocks are compressed
  /// The position of the data appended to the XML, or 0; and whether they are base64.
  std::uint64_t appended = 0;
  bool appended_base64 = false;
};

/// The largest compression factor of zlib.
constexpr std::uint64_t kMostInflation = 1100;
/// Blocks per task: fewer do not pay for a thread.
constexpr std::size_t kBlockGrain = 8;

std::optional<NumberType> number_type_of(const pugi::xml_node& element) {
  const std::string_view type = element.attribute("type").value();
  for (int kind = 0; kind <= static_cast<int>(NumberType::uint64); ++kind) {
    if (vtk_type(static_cast<NumberType>(kind)) == type) return static_cast<NumberType>(kind);
  }
  return std::nullopt;
}

/// The position of a block among compressed and uncompressed bytes.
struct PackedBlock {
  std::uint64_t begin, size;
  std::uint64_t unpacked_begin, unpacked_size;
};

bool inflate_block(const PackedBlock& block, std::span<const std::byte> packed,
                   std::span<std::byte> unpacked) {
  uLongf size = block.unpacked_size;
  // A block may be empty and start at the end of the bytes.
  const int result =
      uncompress(reinterpret_cast<Bytef*>(unpacked.data() + block.unpacked_begin), &size,
                 reinterpret_cast<const Bytef*>(packed.data() + block.begin), block.size);
  return result == Z_OK && size == block.unpacked_size;
}
/// A stream of bytes of the file.
class Bytes {
 public:
  virtual ~Bytes() = default;
  /// An upper bound on the bytes that are left.
  virtual std::uint64_t most_left() const = 0;
  /// False if there are too few.
  virtual bool read(std::span<std::byte> bytes) = 0;
};

class FileBytes : public Bytes {
 public:
  FileBytes(InputFile& file, std::uint64_t place) : file_(file), place_(place) {}
  std::uint64_t most_left() const override { return file_.size() - place_; }
  bool read(std::span<std::byte> bytes) override {
    if (bytes.size() > most_left()) return false;
    file_.read_at(place_, bytes);
    place_ += bytes.size();
    return true;
  }

 private:
  InputFile& file_;
  std::uint64_t place_;
};

class LetterBytes : public Bytes {
 public:
  explicit LetterBytes(std::string_view letters) : reader_(letters) {}
  std::uint64_t most_left() const override { return reader_.most_left(); }
  bool read(std::span<std::byte> bytes) override {
    return reader_.read_some(bytes) == bytes.size();
  }

 private:
  Base64Reader reader_;
};
/// An element's attribute as an integer from 0 to 2^53; `standard` if it is missing. Throws Error
/// for anything else.
std::uint64_t vtk_number(const InputFile& file, const pugi::xml_node& element, const char* name,
                         std::uint64_t standard = 0) {
  constexpr std::int64_t kMost = std::int64_t{1} << 53;
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return standard;
  std::string_view text = attribute.value();
  const auto number = parse_integer(take_word(text));
  if (!number || *number < 0 || *number > kMost) {
    file.fail_whole("says " + in_quotes(attribute.value()) + " for the number " + name +
                    "; the file is damaged, export it again");
  }
  return static_cast<std::uint64_t>(*number);
}

class VtkXmlArrays {
 public:
  /// `file` must outlive this object.
  VtkXmlArrays(InputFile& file, const VtkXmlEncoding& encoding)
      : file_(file), encoding_(encoding), budget_(2 * file.size()) {
    if (!encoding.appended_base64) return;
    appended_letters_.resize(file.size() - encoding.appended);
    file_.read_at(encoding.appended, std::as_writable_bytes(std::span(appended_letters_)));
    appended_letters_.resize(std::min(appended_letters_.size(), appended_letters_.find('<')));
  }

  /// Whether an array is numeric, neither text nor bits.
  static bool holds_numbers(const pugi::xml_node& element) {
    return std::string_view(element.name()) == "DataArray" && number_type_of(element);
  }

  /// The array in the file's type. Throws Error with the array's name if it is damaged or truncated
  /// or has not `rows` rows, before it allocates more memory than the file can fill.
  DataArray read(const pugi::xml_node& element, std::uint64_t rows) {
    name_ = element.attribute("Name").value();
    const auto type = number_type_of(element);
    if (!type) fail("has numbers of an unknown type");
    const std::uint64_t components =
        std::max<std::uint64_t>(1, vtk_number(file_, element, "NumberOfComponents", 1));
    constexpr std::uint64_t kMostComponents = 1u << 30;
    if (components > kMostComponents || rows > std::numeric_limits<std::uint32_t>::max()) {
      fail("has an impossible size");
    }
    DataArray array{name_, *type, static_cast<int>(components), {}};
    if (rows > 0) array.bytes = decode(element, *type, rows * components);
    return array;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    file_.fail_whole((name_.empty() ? "an array without a name" : "array " + in_quotes(name_)) +
                     " " + what + "; the file is damaged or truncated, copy or export it again");
  }

  std::vector<std::byte> decode(const pugi::xml_node& element, NumberType type,
                                std::uint64_t count) {
    constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 53;
    if (count > kMostBytes / size_of(type)) fail("has an impossible size");
    const std::string_view format = element.attribute("format").value();
    std::vector<std::byte> numbers;
    if (format == "ascii") {
      std::string_view text = element.child_value();
      numbers = take_numbers(text, type, count, [&](const std::string& what) { fail(what); });
      if (!take_word_of_lines(text).empty()) {
        fail("has more than " + std::to_string(count) + " numbers");
      }
      return numbers;
    }
    if (format == "binary") {
      LetterBytes bytes(element.child_value());
      numbers = decode_block(bytes, count * size_of(type));
    } else if (format == "appended") {
      numbers = decode_appended(element, count * size_of(type));
    } else {
      fail("is in the unknown format " + in_quotes(format));
    }
    if (encoding_.foreign_order) reverse_bytes(numbers, size_of(type));
    return numbers;
  }

  std::vector<std::byte> decode_appended(const pugi::xml_node& element, std::uint64_t size) {
    if (encoding_.appended == 0) fail("is appended to the file, but nothing is there");
    const std::uint64_t offset = vtk_number(file_, element, "offset");
    if (offset > file_.size() - encoding_.appended) fail("begins behind the file's end");
    if (!encoding_.appended_base64) {
      FileBytes bytes(file_, encoding_.appended + offset);
      return decode_block(bytes, size);
    }
    LetterBytes bytes(
        std::string_view(appended_letters_).substr(std::min(offset, appended_letters_.size())));
    return decode_block(bytes, size);
  }

  std::uint64_t read_size(Bytes& bytes) const {
    std::array<std::byte, 8> word{};
    const std::span<std::byte> used = std::span(word).first(encoding_.wide_sizes ? 8 : 4);
    if (!bytes.read(used)) fail("is not whole");
    if (encoding_.foreign_order) reverse_bytes(used, used.size());
    std::uint32_t narrow = 0;
    std::uint64_t wide = 0;
    std::memcpy(&narrow, word.data(), sizeof narrow);
    std::memcpy(&wide, word.data(), sizeof wide);
    return encoding_.wide_sizes ? wide : narrow;
  }

  /// Throws if the budget or `bytes` has too few.
  void take_from_budget(const Bytes& bytes, std::uint64_t size) {
    if (size > bytes.most_left()) fail("is not whole");
    if (size > budget_) fail("is, with others, larger than the file");
    budget_ -= size;
  }

  std::vector<std::byte> decode_block(Bytes& bytes, std::uint64_t size) {
    if (encoding_.zlib) return inflate_blocks(bytes, size);
    const std::uint64_t stored = read_size(bytes);
    if (stored != size) {
      fail("has " + std::to_string(stored) + " bytes instead of " + std::to_string(size));
    }
    take_from_budget(bytes, size);
    std::vector<std::byte> block(size);
    if (!bytes.read(block)) fail("is not whole");
    return block;
  }

  std::vector<std::byte> inflate_blocks(Bytes& bytes, std::uint64_t size) {
    const std::uint64_t count = read_size(bytes), full = read_size(bytes), rest = read_size(bytes);
    const bool possible = count > 0 && count <= bytes.most_left() && full > 0 && rest <= full &&
                          (count - 1) <= size / full &&
                          (count - 1) * full + (rest > 0 ? rest : full) == size;
    if (!possible) fail("has not the " + std::to_string(size) + " bytes that it should have");
    std::vector<PackedBlock> blocks;
    std::uint64_t packed_size = 0;
    for (std::uint64_t b = 0; b < count; ++b) {
      const std::uint64_t one = read_size(bytes);
      if (one > bytes.most_left()) fail("is not whole");
      blocks.push_back({packed_size, one, b * full, b + 1 == count && rest > 0 ? rest : full});
      packed_size += one;
    }
    take_from_budget(bytes, packed_size);
    if (size / kMostInflation > packed_size) fail("is not compressed by zlib");
    std::vector<std::byte> packed(packed_size), unpacked(size);
    if (!bytes.read(packed)) fail("is not whole");
    std::atomic<bool> good = true;
    parallel_for(
        blocks.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t b = begin; b < end; ++b) {
            if (!inflate_block(blocks[b], packed, unpacked)) good = false;
          }
        },
        kBlockGrain);
    if (!good) fail("cannot be decompressed");
    return unpacked;
  }

  InputFile& file_;
  VtkXmlEncoding encoding_;
  std::string appended_letters_;  ///< data appended as base64
  std::uint64_t budget_;          ///< bytes of the file that arrays may still use
  std::string name_;              ///< of the current array, for messages
};

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
    std::vector<VtkPiece> pieces;
    for_each_piece([&](const Xml& piece) { pieces.push_back(read_piece(piece)); });
    RawMesh raw = vtk_surface(file_.name(), std::move(pieces), exact);
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
