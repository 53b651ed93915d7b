#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/base/input_file.h"
#include "brindle/base/memory.h"
#include "brindle/base/text.h"
#include "brindle/files.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/files/text/text_words.h"
#include "brindle/files/vtk/vtk_file.h"
#include "brindle/files/vtk/vtk_surface.h"

namespace brindle {
namespace {

/// The number type of a name in the format.
struct LegacyType {
  std::string_view name;
  NumberType stored;
};

/// `vtkIdType` has 32 bits in binary files and is widened to 64 (`take_ids`).
constexpr std::array<LegacyType, 16> kLegacyTypes = {{{"float", NumberType::float32},
                                                      {"double", NumberType::float64},
                                                      {"char", NumberType::int8},
                                                      {"signed_char", NumberType::int8},
                                                      {"unsigned_char", NumberType::uint8},
                                                      {"short", NumberType::int16},
                                                      {"unsigned_short", NumberType::uint16},
                                                      {"int", NumberType::int32},
                                                      {"unsigned_int", NumberType::uint32},
                                                      {"long", NumberType::int64},
                                                      {"unsigned_long", NumberType::uint64},
                                                      {"long_long", NumberType::int64},
                                                      {"unsigned_long_long", NumberType::uint64},
                                                      {"vtktypeint64", NumberType::int64},
                                                      {"vtktypeuint64", NumberType::uint64},
                                                      {"vtkidtype", NumberType::int64}}};

bool is_text_type(const std::string& type) {
  return type == "string" || type == "utf8_string" || type == "unicode_string" || type == "variant";
}

class VtkLegacyReader {
 public:
  VtkLegacyReader(const std::filesystem::path& path, const Progress& progress)
      : file_(path, progress) {
    text_.resize(size_in_bytes(file_.size(), 1, shown(path.string())));
    file_.read_at(0, std::as_writable_bytes(std::span(text_)));
    rest_ = text_;
  }

  RawMesh read() {
    read_header();
    for (std::string word = next_keyword(); !word.empty(); word = next_keyword()) read_part(word);
    check_piece();
    std::vector<VtkPiece> pieces(1);
    pieces[0] = std::move(piece_);
    RawMesh raw = vtk_surface(file_.name(), std::move(pieces));
    raw.left_out += left_out_;
    return raw;
  }

 private:
  enum Slot { kVerts, kLines, kPolys, kStrips, kGrid, kSlots };

  [[noreturn]] void fail(const std::string& what) const {
    const std::string message = what + "; the file is damaged or truncated, export it again";
    const std::size_t read = text_.size() - rest_.size();
    if (binary_) file_.fail_whole(message);
    file_.fail_at(1 + std::count(text_.begin(), text_.begin() + read, '\n'), message);
  }

  std::string_view take_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  std::string next_keyword() { return small_letters(take_word_of_lines(rest_)); }

  /// Takes the next word if it equals this one, ignoring case.
  bool take_if(std::string_view keyword) {
    std::string_view after = rest_;
    if (small_letters(take_word_of_lines(after)) != keyword) return false;
    rest_ = after;
    return true;
  }

  std::uint64_t take_count() {
    const std::string_view word = take_word_of_lines(rest_);
    const auto number = parse_integer(word);
    constexpr std::int64_t kMost = std::int64_t{1} << 40;
    if (!number || *number < 0 || *number > kMost) {
      fail("has " + in_quotes(word) + " where a number of things must stand");
    }
    return static_cast<std::uint64_t>(*number);
  }

  std::string take_name() { return percent_decoded(take_word_of_lines(rest_)); }

  void read_header() {
    std::string_view first = take_line();
    constexpr std::string_view kMagic = "# vtk DataFile Version";
    if (!first.starts_with(kMagic)) {
      file_.fail_whole("is no legacy VTK file: it does not begin with '" + std::string(kMagic) +
                       "'");
    }
    first.remove_prefix(kMagic.size());
    const auto version = parse_double(take_word(first));
    offsets_apart_ = version && *version >= 5;
    take_line();  // the title
    const std::string encoding = next_keyword();
    if (encoding != "ascii" && encoding != "binary") {
      fail("must say ASCII or BINARY, not " + in_quotes(encoding));
    }
    binary_ = encoding == "binary";
  }

  // ----------------------------------------------------------------------------------------------

  void read_part(const std::string& word) {
    if (!take_geometry(word) && !read_data(word)) {
      fail("has the unknown keyword " + in_quotes(word));
    }
  }

  bool take_geometry(const std::string& word) {
    if (word == "dataset") {
      const std::string kind = next_keyword();
      if (kind != "polydata" && kind != "unstructured_grid") {
        file_.fail_whole("holds " + in_quotes(kind) +
                         ", not POLYDATA or an UNSTRUCTURED_GRID; in ParaView, apply the filter "
                         "Extract Surface and save its result as .vtp");
      }
    } else if (word == "points") {
      points_ = take_count();
      piece_.points = numbers("points", take_word_of_lines(rest_), points_, 3);
    } else if (word == "vertices") {
      read_cells(kVerts, kVtkPolyVertex);
    } else if (word == "lines") {
      read_cells(kLines, kVtkPolyLine);
    } else if (word == "polygons") {
      read_cells(kPolys, kVtkPolygon);
    } else if (word == "triangle_strips") {
      read_cells(kStrips, kVtkTriangleStrip);
    } else if (word == "cells") {
      read_cells(kGrid, 0);
    } else if (word == "cell_types") {
      const std::uint64_t count = take_count();
      piece_.cells[kGrid].types = vtk_cell_types(numbers("cell types", "int", count, 1));
    } else {
      return false;
    }
    return true;
  }

  void read_cells(Slot slot, std::uint8_t type) {
    const std::uint64_t count = take_count(), size = take_count();
    VtkCells& cells = piece_.cells[slot];
    cells.type = type;
    if (offsets_apart_) {
      read_offsets_and_points(cells, count, size);
    } else {
      cut_cells(cells, numbers("cells", "int", size, 1), count);
    }
    cells_ += cells.ends.rows();
  }

  void read_offsets_and_points(VtkCells& cells, std::uint64_t count, std::uint64_t size) {
    if (take_if("offsets")) {
      const std::string_view type = take_word_of_lines(rest_);
      cells.ends = numbers("offsets", type, count, 1);
      const std::size_t number = size_of(cells.ends.type);
      // The first cell begins at 0.
      const auto first = cells.ends.bytes.begin();
      if (count > 0 &&
          std::any_of(first, first + number, [](auto b) { return b != std::byte{}; })) {
        fail("has cells whose offsets do not begin with 0");
      }
      cells.ends.bytes.erase(first, first + std::min(number, cells.ends.bytes.size()));
    }
    if (take_if("connectivity")) {
      const std::string_view type = take_word_of_lines(rest_);
      cells.points = numbers("cells", type, size, 1);
    }
  }

  /// Each cell is its number of points, then the points, in one row.
  void cut_cells(VtkCells& cells, const DataArray& row, std::uint64_t count) {
    std::vector<std::int32_t> numbers(row.rows());
    if (!numbers.empty()) std::memcpy(numbers.data(), row.bytes.data(), row.bytes.size());
    if (count > numbers.size()) fail("has fewer cells than it says");
    std::vector<std::uint64_t> ends;
    std::size_t at = 0, end = 0;
    while (at < numbers.size()) {
      const std::int32_t points = numbers[at++];
      if (points < 0 || static_cast<std::size_t>(points) > numbers.size() - at) {
        fail("has a cell with an impossible number of points");
      }
      std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(at), points,
                  numbers.begin() + static_cast<std::ptrdiff_t>(end));
      at += static_cast<std::size_t>(points);
      end += static_cast<std::size_t>(points);
      ends.push_back(end);
    }
    if (ends.size() != count) fail("has another number of cells than it says");
    numbers.resize(end);
    cells.points = make_data_array<std::int32_t>("cells", 1, numbers);
    cells.ends = make_data_array<std::uint64_t>("offsets", 1, ends);
  }

  void check_piece() {
    if (piece_.points.components != 3) fail("has no POINTS");
    const VtkCells& grid = piece_.cells[kGrid];
    if (grid.types.size() != grid.ends.rows()) {
      fail("has " + std::to_string(grid.ends.rows()) + " cells and types for " +
           std::to_string(grid.types.size()));
    }
  }

  // ----------------------------------------------------------------------------------------------

  bool read_data(const std::string& word) {
    if (word == "point_data" || word == "cell_data") {
      const bool points = word == "point_data";
      rows_ = take_count();
      data_ = points ? &piece_.arrays.points : &piece_.arrays.cells;
      if (rows_ != (points ? points_ : cells_)) {
        fail("has data for " + std::to_string(rows_) + (points ? " points" : " cells") + " of " +
             std::to_string(points ? points_ : cells_));
      }
    } else if (word == "metadata") {
      skip_metadata();
    } else if (word == "field") {
      read_field();
    } else if (word == "lookup_table") {
      take_name();
      skip_table(take_count());
    } else {
      return read_attribute(word);
    }
    return true;
  }

  bool read_attribute(const std::string& word) {
    constexpr std::array<std::pair<std::string_view, int>, 7> kComponents = {{{"vectors", 3},
                                                                              {"normals", 3},
                                                                              {"tensors", 9},
                                                                              {"tensors6", 6},
                                                                              {"global_ids", 1},
                                                                              {"pedigree_ids", 1},
                                                                              {"edge_flags", 1}}};
    if (word == "scalars") {
      read_scalars();
    } else if (word == "color_scalars") {
      read_colors();
    } else if (word == "texture_coordinates") {
      const std::string name = take_name();
      const std::uint64_t components = take_count();
      add(name, take_word_of_lines(rest_), rows_, components);
    } else {
      const auto found = std::find_if(kComponents.begin(), kComponents.end(),
                                      [&](const auto& entry) { return entry.first == word; });
      if (found == kComponents.end()) return false;
      const std::string name = take_name();
      if (word == "normals" && data_ == &piece_.arrays.points) piece_.normals = name;
      add(name, take_word_of_lines(rest_), rows_, static_cast<std::uint64_t>(found->second));
    }
    return true;
  }

  void read_scalars() {
    const std::string name = take_name();
    const std::string_view type = take_word_of_lines(rest_);
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    const auto components = parse_integer(take_word(line));
    take_line();
    if (take_if("lookup_table")) {
      take_name();
      take_line();
    }
    add_here(name, small_letters(type), rows_,
             static_cast<std::uint64_t>(std::max<std::int64_t>(1, components.value_or(1))));
  }

  /// Colour levels: 0 to 1 in text files, 0 to 255 in binary ones.
  void read_colors() {
    const std::string name = take_name();
    const std::uint64_t components = take_count();
    DataArray array = numbers(name, binary_ ? "unsigned_char" : "float", rows_, components);
    if (!binary_) {
      std::vector<float> levels(array.bytes.size() / sizeof(float));
      if (!levels.empty()) {
        std::memcpy(levels.data(), array.bytes.data(), array.bytes.size());
      }
      std::vector<std::uint8_t> bytes(levels.size());
      std::transform(levels.begin(), levels.end(), bytes.begin(), color_byte);
      array = make_data_array<std::uint8_t>(name, array.components, bytes);
    }
    keep(std::move(array), rows_);
  }

  void skip_table(std::uint64_t colors) {
    numbers("lookup table", binary_ ? "unsigned_char" : "float", colors, 4);
  }

  void read_field() {
    take_name();
    const std::uint64_t arrays = take_count();
    for (std::uint64_t a = 0; a < arrays; ++a) {
      if (take_if("metadata")) skip_metadata();
      const std::string name = take_name();
      if (name == "NULL_ARRAY") continue;
      const std::uint64_t components = take_count(), rows = take_count();
      add(name, take_word_of_lines(rest_), rows, components);
    }
  }

  void skip_metadata() {
    take_line();
    while (!rest_.empty() && !take_line().empty()) {
    }
  }

  // ----------------------------------------------------------------------------------------------

  /// Reads an array whose numbers begin in the next line or after the next word.
  void add(const std::string& name, std::string_view type, std::uint64_t rows,
           std::uint64_t components) {
    if (binary_) take_line();
    add_here(name, small_letters(type), rows, components);
  }

  void add_here(const std::string& name, const std::string& type, std::uint64_t rows,
                std::uint64_t components) {
    if (is_text_type(type) || type == "bit") {
      skip_array(type, rows, components);
      left_out_ += "array " + in_quotes(name) + ": left out, because it does not hold numbers\n";
    } else {
      keep(numbers_here(name, type, rows, components), rows);
    }
  }

  /// Drops data of neither points nor cells.
  void keep(DataArray array, std::uint64_t rows) {
    if (data_ == nullptr) return;
    if (rows == rows_) {
      data_->push_back(std::move(array));
    } else {
      left_out_ += "array " + in_quotes(array.name) + ": left out, because it has " +
                   std::to_string(rows) + " rows instead of " + std::to_string(rows_) + '\n';
    }
  }

  DataArray numbers(const std::string& name, std::string_view type, std::uint64_t rows,
                    std::uint64_t components) {
    if (binary_) take_line();
    return numbers_here(name, small_letters(type), rows, components);
  }

  DataArray numbers_here(const std::string& name, const std::string& type, std::uint64_t rows,
                         std::uint64_t components) {
    const auto found = std::find_if(kLegacyTypes.begin(), kLegacyTypes.end(),
                                    [&](const LegacyType& known) { return known.name == type; });
    if (found == kLegacyTypes.end())
      fail("array " + in_quotes(name) + " has the unknown type " + in_quotes(type));
    if (components == 0 || components > text_.size() || rows > text_.size()) fail_size(name);
    DataArray array{name, found->stored, static_cast<int>(components), {}};
    if (!binary_) {
      array.bytes = take_numbers(
          rest_, array.type, rows * components,
          [&](const std::string& what) { fail("array " + in_quotes(name) + ' ' + what); });
    } else if (type == "vtkidtype") {
      array.bytes = take_ids(name, rows * components);
    } else {
      array.bytes = take_bytes(name, rows * components, size_of(array.type));
    }
    return array;
  }

  [[noreturn]] void fail_size(const std::string& name) const {
    fail("array " + in_quotes(name) + " is larger than the file");
  }

  std::vector<std::byte> take_bytes(const std::string& name, std::uint64_t count,
                                    std::size_t size) {
    if (count > rest_.size() / size) fail_size(name);
    std::vector<std::byte> bytes(size_in_bytes(count, size, "array " + in_quotes(name)));
    if (!bytes.empty()) std::memcpy(bytes.data(), rest_.data(), bytes.size());
    rest_.remove_prefix(bytes.size());
    if constexpr (std::endian::native == std::endian::little) reverse_bytes(bytes, size);
    return bytes;
  }

  std::vector<std::byte> take_ids(const std::string& name, std::uint64_t count) {
    const DataArray narrow{name, NumberType::int32, 1, take_bytes(name, count, 4)};
    std::vector<std::int64_t> ids(narrow.rows());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      std::int32_t id = 0;
      std::memcpy(&id, &narrow.bytes[4 * i], sizeof id);
      ids[i] = id;
    }
    return make_data_array<std::int64_t>(name, 1, ids).bytes;
  }

  void skip_array(const std::string& type, std::uint64_t rows, std::uint64_t components) {
    if (components > text_.size() || rows > text_.size()) fail_size(type);
    const std::uint64_t count = rows * components;
    if (type == "bit" && binary_) {
      take_bytes(type, (count + 7) / 8, 1);
    } else if (type == "bit") {
      numbers_here(type, "int", rows, components);
    } else if (binary_ && type == "variant") {
      file_.fail_whole("has arrays of variants, which brindle does not read; export it as .vtp");
    } else {
      if (!binary_) take_line();
      for (std::uint64_t i = 0; i < count; ++i) {
        if (rest_.empty()) fail_size(type);
        binary_ ? skip_binary_string() : static_cast<void>(take_line());
      }
    }
  }

  /// The two highest bits of a string's first byte give the size of its length.
  void skip_binary_string() {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(rest_[i]); };
    constexpr std::array<std::size_t, 4> kLengthBytes = {8, 4, 2, 1};
    const std::size_t bytes = kLengthBytes[at(0) >> 6];
    if (bytes > rest_.size()) fail_size("string");
    std::uint64_t length = at(0) & 0x3f;
    for (std::size_t i = 1; i < bytes; ++i) length = length << 8 | at(i);
    if (length > rest_.size() - bytes) fail_size("string");
    rest_.remove_prefix(bytes + static_cast<std::size_t>(length));
  }

  InputFile file_;
  std::string text_;
  std::string_view rest_;
  bool binary_ = false;
  bool offsets_apart_ = false;  ///< cells are two arrays, offsets and points, from version 5 on
  VtkPiece piece_ = {{}, std::vector<VtkCells>(kSlots), {}, {}};
  std::uint64_t points_ = 0, cells_ = 0;
  std::vector<DataArray>* data_ = nullptr;  ///< owner of the next arrays
  std::uint64_t rows_ = 0;
  std::string left_out_;
};

}  // namespace

RawMesh read_vtk_legacy(const std::filesystem::path& path, const Progress& progress) {
  return VtkLegacyReader(path, progress).read();
}

}  // namespace brindle
