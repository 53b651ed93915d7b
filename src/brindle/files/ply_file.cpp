#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/input_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/point_output.h"
#include "brindle/files/read_arrays.h"
#include "brindle/files/written_arrays.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

constexpr std::array<std::pair<std::string_view, NumberType>, 16> kNumberNames = {
    {{"char", NumberType::int8},
     {"int8", NumberType::int8},
     {"uchar", NumberType::uint8},
     {"uint8", NumberType::uint8},
     {"short", NumberType::int16},
     {"int16", NumberType::int16},
     {"ushort", NumberType::uint16},
     {"uint16", NumberType::uint16},
     {"int", NumberType::int32},
     {"int32", NumberType::int32},
     {"uint", NumberType::uint32},
     {"uint32", NumberType::uint32},
     {"float", NumberType::float32},
     {"float32", NumberType::float32},
     {"double", NumberType::float64},
     {"float64", NumberType::float64}}};

struct Property {
  std::string name;
  NumberType number;
  bool list = false;
  NumberType list_count = NumberType::uint8;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { text, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements;
};

class HeaderReader {
 public:
  explicit HeaderReader(InputFile& file) : file_(file) {}

  Header read() {
    if (file_.next_line() != "ply") file_.fail("a PLY file begins with the line 'ply'");
    while (true) {
      const auto line = file_.next_line();
      if (!line) file_.fail_whole("ends within its header: it is truncated; export it again");
      std::string_view rest = *line;
      const std::string_view keyword = take_word(rest);
      if (keyword == "end_header") break;
      if (keyword == "format") {
        read_format(take_word(rest));
      } else if (keyword == "element") {
        read_element(rest);
      } else if (keyword == "property") {
        read_property(rest);
      } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        file_.fail(in_quotes(keyword) + " is unknown in a PLY header");
      }
    }
    if (!has_format_) file_.fail("the header names no format; export the file again");
    return std::move(header_);
  }

 private:
  void read_format(std::string_view name) {
    has_format_ = true;
    if (name == "ascii") {
      header_.encoding = Encoding::text;
    } else if (name == "binary_little_endian") {
      header_.encoding = Encoding::little_endian;
    } else if (name == "binary_big_endian") {
      header_.encoding = Encoding::big_endian;
    } else {
      file_.fail("unknown format " + in_quotes(name));
    }
  }

  void read_element(std::string_view rest) {
    Element element{std::string(take_word(rest)), 0, {}};
    const auto count = parse_integer(take_word(rest));
    if (element.name.empty() || !count || *count < 0) {
      file_.fail("an element needs a name and a number");
    }
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(std::move(element));
  }

  void read_property(std::string_view rest) {
    if (header_.elements.empty()) file_.fail("a property before any element");
    Property property{};
    std::string_view type = take_word(rest);
    if (type == "list") {
      property.list = true;
      property.list_count = number(take_word(rest));
      type = take_word(rest);
    }
    property.number = number(type);
    property.name = take_word(rest);
    if (property.name.empty()) file_.fail("a property needs a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  NumberType number(std::string_view name) {
    for (const auto& [known, kind] : kNumberNames) {
      if (known == name) return kind;
    }
    file_.fail("unknown type of number " + in_quotes(name));
  }

  InputFile& file_;
  Header header_;
  bool has_format_ = false;
};

/// The sequence of numbers in a PLY file's body.
class Body {
 public:
  Body(InputFile& file, Encoding encoding) : file_(file), encoding_(encoding) {}

  bool is_text() const { return encoding_ == Encoding::text; }

  /// In text files, each row is a line.
  void begin_row() {
    if (!is_text()) return;
    do {
      const auto line = file_.next_line();
      if (!line) fail_truncated();
      rest_ = *line;
    } while (rest_.find_first_not_of(" \t\r\v\f") == std::string_view::npos);
  }

  double number(NumberType kind) {
    if (is_text()) return number_in(next_word(), kind);
    double number = 0;
    with_number_type(
        kind, [&]<class Number>(Number) { number = static_cast<double>(binary_number<Number>()); });
    return number;
  }

  /// Appends the next number in its type.
  void append_number(NumberType kind, std::vector<std::byte>& bytes) {
    with_number_type(kind, [&]<class Number>(Number) {
      const auto number = is_text() ? text_number<Number>(kind) : binary_number<Number>();
      const auto* begin = reinterpret_cast<const std::byte*>(&number);
      bytes.insert(bytes.end(), begin, begin + sizeof number);
    });
  }

  /// A bound on a list's length: the bytes that remain.
  double most_entries() const {
    return static_cast<double>(is_text() ? rest_.size() : file_.remaining());
  }

  [[noreturn]] void fail(const std::string& message) const {
    is_text() ? file_.fail(message) : file_.fail_whole(message);
  }

 private:
  template <class Value>
  static std::optional<double> to_double(std::optional<Value> value) {
    return value ? std::optional<double>(static_cast<double>(*value)) : std::nullopt;
  }

  [[noreturn]] void fail_truncated() const {
    file_.fail_whole(
        "ends before all elements that its header names: it is truncated; "
        "copy or export it again");
  }

  std::string_view next_word() { return take_word(rest_); }

  double number_in(std::string_view word, NumberType kind) const {
    const bool whole = kind != NumberType::float64 && kind != NumberType::float32;
    auto value = whole ? to_double(parse_integer(word)) : std::nullopt;
    if (!value) value = to_double(parse_number(word));
    if (!value) {
      file_.fail("a number is expected, not " + in_quotes(word) +
                 "; the file is damaged or truncated, export it again");
    }
    return *value;
  }

  template <class Number>
  Number text_number(NumberType kind) {
    const std::string_view word = next_word();
    const double value = number_in(word, kind);
    if constexpr (std::is_integral_v<Number>) {
      constexpr auto kLeast = static_cast<double>(std::numeric_limits<Number>::lowest());
      constexpr auto kMost = static_cast<double>(std::numeric_limits<Number>::max());
      if (!(value >= kLeast && value <= kMost)) {
        file_.fail(in_quotes(word) + " is no number of type " + std::string(name_of(kind)) +
                   "; the file is damaged, export it again");
      }
      return static_cast<Number>(value);
    } else {
      return static_cast<Number>(std::is_same_v<Number, double> ? *parse_double(word) : value);
    }
  }

  template <class Number>
  Number binary_number() {
    std::array<char, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), file_.take(sizeof(Number)), sizeof(Number));
    if (encoding_ == Encoding::big_endian) std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
  }

  InputFile& file_;
  Encoding encoding_;
  std::string_view rest_;
};

/// Names the columns of these properties as components of one array, if all exist and have one
/// type.
bool name_components(std::vector<DataArray>& columns, std::span<const std::string_view> properties,
                     const std::string& array) {
  std::vector<DataArray*> found;
  for (const std::string_view property : properties) {
    const auto column = ranges::find(columns, property, &DataArray::name);
    if (column == columns.end()) return false;
    if (!found.empty() && column->type != found[0]->type) return false;
    found.push_back(&*column);
  }
  for (std::size_t i = 0; i < found.size(); ++i) found[i]->name = array + ':' + std::to_string(i);
  return true;
}

/// Drops a column that equals another one.
void drop_copy(std::vector<DataArray>& columns, std::string_view name, std::string_view other) {
  const DataArray* first = find_array(columns, other);
  std::erase_if(columns, [&](const DataArray& column) {
    return column.name == name && column.bytes == first->bytes;
  });
}

/// The arrays of all named columns.
std::vector<DataArray> arrays_of(std::vector<DataArray> columns) {
  using Names = std::initializer_list<std::string_view>;
  std::erase_if(columns, [](const DataArray& column) { return column.name.empty(); });
  const auto name = [&](Names properties, const char* array) {
    return name_components(columns, std::span(properties.begin(), properties.size()), array);
  };
  // The format does not define names of normals; these are common.
  for (const auto& names : kNormalNames) {
    if (name_components(columns, names, "normal")) break;
  }
  if (!name({"red", "green", "blue", "alpha"}, "color")) name({"red", "green", "blue"}, "color");
  if (name({"texture_u", "texture_v"}, "uv")) {
    drop_copy(columns, "s", "uv:0");
    drop_copy(columns, "t", "uv:1");
  } else {
    name({"s", "t"}, "uv");
  }
  return grouped_columns(std::move(columns));
}

class PlyReader {
 public:
  explicit PlyReader(const std::filesystem::path& path, const Progress& progress = {})
      : file_(path, progress),
        header_(HeaderReader(file_).read()),
        body_(file_, header_.encoding) {}

  RawMesh read_mesh() {
    read_elements(true);
    DataArrays arrays{points_.take("vertices", left_out_), cells_.take("faces", left_out_)};
    RawMesh raw = mesh_.take(std::move(arrays));
    raw.left_out = std::move(left_out_);
    return raw;
  }

  LoadedPoints read_points() {
    read_elements(false);
    std::vector<DataArray> arrays = points_.take("vertices", left_out_);
    const DataArray* normal = find_array(arrays, "normal");
    LoadedPoints loaded = make_placed_point_cloud(
        mesh_.positions(),
        normal != nullptr ? vectors_of(normal->view(), "normals") : std::vector<Vec3>());
    loaded.arrays = std::move(arrays);
    loaded.left_out = std::move(left_out_);
    return loaded;
  }

  FileElements elements() const {
    const auto has = [&](bool (*holds)(const Element&)) {
      return ranges::any_of(header_.elements,
                            [&](const Element& e) { return e.count > 0 && holds(e); });
    };
    return {has(holds_faces), has([](const Element& e) { return e.name == "edge"; })};
  }

 private:
  static bool is_strips(const Element& element) { return element.name == "tristrips"; }
  static bool holds_faces(const Element& element) {
    return element.name == "face" || is_strips(element);
  }

  void read_elements(bool faces) {
    for (const Element& element : header_.elements) {
      check_size(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (faces && holds_faces(element)) {
        read_faces(element);
      } else {
        std::vector<DataArray> none(element.properties.size());
        read_rows(
            element, none, [](const Property&, std::span<const double>) {}, [] {});
      }
    }
  }

  /// Rejects impossible numbers in the header before memory is allocated for them.
  void check_size(const Element& element) {
    std::uint64_t smallest_row = body_.is_text() ? 1 : 0;
    for (const Property& p : element.properties) {
      smallest_row += body_.is_text() ? 1 : size_of(p.list ? p.list_count : p.number);
    }
    const bool fits =
        element.count <= (file_.remaining() + 1) / std::max<std::uint64_t>(1, smallest_row);
    if (!fits || element.count > 0xfffffffe) {
      file_.fail_whole("is too short for the " + std::to_string(element.count) + " elements " +
                       in_quotes(element.name) +
                       " that its header names: it is truncated or damaged; "
                       "copy or export it again");
    }
  }

  /// An array per property of the element; unnamed for lists and for `others`.
  static std::vector<DataArray> columns_of(const Element& element,
                                           std::span<const std::string_view> others) {
    std::vector<DataArray> columns;
    for (const Property& property : element.properties) {
      columns.push_back({"", property.number, 1, {}});
      if (property.list || ranges::find(others, property.name) != others.end()) continue;
      columns.back().name = property.name;
      columns.back().bytes.reserve(static_cast<std::size_t>(element.count) *
                                   size_of(property.number));
    }
    return columns;
  }

  /// Reads all rows: named columns receive their numbers, all other values go to `use(property,
  /// values)`. Calls `end_row()` after each row.
  template <class Use, class EndRow>
  void read_rows(const Element& element, std::vector<DataArray>& columns, const Use& use,
                 const EndRow& end_row) {
    for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      body_.begin_row();
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if (columns[p].name.empty()) {
          read_values(element, property);
          use(property, values_);
        } else {
          body_.append_number(property.number, columns[p].bytes);
        }
      }
      end_row();
    }
  }

  void read_values(const Element& element, const Property& property) {
    values_.clear();
    const double count = property.list ? body_.number(property.list_count) : 1;
    if (!(count >= 0) || count > body_.most_entries() || count != std::floor(count)) {
      body_.fail("a list of " + in_quotes(element.name) +
                 " has an impossible number of entries; the file is damaged");
    }
    for (double i = 0; i < count; ++i) values_.push_back(body_.number(property.number));
  }

  void note_lists(const Element& element) {
    for (const Property& property : element.properties) {
      if (!property.list || is_corners(property)) continue;
      left_out_ +=
          "lists " + in_quotes(property.name) + " of " + in_quotes(element.name) + ": left out\n";
    }
  }

  void read_vertices(const Element& element) {
    constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
    std::array<const Property*, 3> wanted{};
    for (const Property& property : element.properties) {
      const auto name = std::find(kAxes.begin(), kAxes.end(), property.name);
      if (name != kAxes.end() && !property.list) wanted[name - kAxes.begin()] = &property;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (wanted[axis] == nullptr) {
        file_.fail_whole("has vertices without '" + std::string(kAxes[axis]) + "'");
      }
    }
    mesh_.reserve_vertices(static_cast<std::size_t>(element.count));
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    std::vector<DataArray> columns = columns_of(element, kAxes);
    read_rows(
        element, columns,
        [&](const Property& property, std::span<const double> read) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            if (&property == wanted[axis]) position[static_cast<Eigen::Index>(axis)] = read[0];
          }
        },
        [&] { mesh_.add_vertex(position); });
    note_lists(element);
    if (element.count > 0) points_.add(arrays_of(std::move(columns)));
  }

  static bool is_corners(const Property& property) {
    return property.list && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  void read_faces(const Element& element) {
    std::vector<DataArray> columns = columns_of(element, {});
    read_rows(
        element, columns,
        [&](const Property& property, std::span<const double> values) {
          if (is_corners(property)) add_face(element, values);
        },
        [&] { ++face_; });
    note_lists(element);
    if (element.count > 0) cells_.add(arrays_of(std::move(columns)));
  }

  void add_face(const Element& element, std::span<const double> values) {
    corners_.clear();
    for (const double corner : values) {
      if (is_strips(element) && corner == kStripEnd) {
        mesh_.add_strip(corners_, face_);
        corners_.clear();
        continue;
      }
      const bool exists = corner >= 0 && corner < static_cast<double>(mesh_.vertex_count()) &&
                          corner == std::floor(corner);
      if (!exists) {
        body_.fail((is_strips(element) ? "triangle strip " : "face ") + std::to_string(face_) +
                   " has a corner that does not exist: there are " +
                   std::to_string(mesh_.vertex_count()) +
                   " vertices, counted from 0; the file is damaged, export it again");
      }
      corners_.push_back(static_cast<Index>(corner));
    }
    is_strips(element) ? mesh_.add_strip(corners_, face_) : mesh_.add_polygon(corners_, face_);
  }

  static constexpr double kStripEnd = -1;

  InputFile file_;
  Header header_;
  Body body_;
  MeshBuilder mesh_;
  PiecewiseArrays points_, cells_;
  Index face_ = 0;  ///< counted over all elements with faces
  std::string left_out_;
  std::vector<double> values_;
  std::vector<Index> corners_;
};

}  // namespace

RawMesh read_ply(const std::filesystem::path& path, const Progress& progress) {
  return PlyReader(path, progress).read_mesh();
}

LoadedPoints read_ply_points(const std::filesystem::path& path) {
  return PlyReader(path).read_points();
}

FileElements ply_elements(const std::filesystem::path& path) { return PlyReader(path).elements(); }

void write_ply(OutputStream& out, const Mesh& mesh, const DataArrays& arrays,
               const std::string& picture) {
  const PlyVertices vertices{mesh.positions, mesh.origin, arrays.points};
  write_ply_vertices(out, picture.empty() ? "" : "comment TextureFile " + picture + '\n', vertices);
  out << "element face " << mesh.triangle_count() << "\nproperty list uchar uint vertex_indices\n";
  put_ply_properties(out, arrays.cells);
  out << "end_header\n";
  BinaryOutput binary(out);
  put_ply_vertices(binary, vertices);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    binary.put(static_cast<unsigned char>(3));
    binary.put(mesh.triangles[t].data(), 3);
    put_ply_row(binary, arrays.cells, t);
  }
}

}  // namespace brindle
