#include "brindle/files/ply_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/printable.h"
#include "brindle/files/binary_output.h"
#include "brindle/files/input_file.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/ply_positions.h"
#include "brindle/files/written_arrays.h"
#include "brindle/geometry/polygon.h"

namespace brindle {
namespace {

enum class Number { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr std::array<std::pair<std::string_view, Number>, 16> kNumbers = {
    {{"char", Number::int8},
     {"int8", Number::int8},
     {"uchar", Number::uint8},
     {"uint8", Number::uint8},
     {"short", Number::int16},
     {"int16", Number::int16},
     {"ushort", Number::uint16},
     {"uint16", Number::uint16},
     {"int", Number::int32},
     {"int32", Number::int32},
     {"uint", Number::uint32},
     {"uint32", Number::uint32},
     {"float", Number::float32},
     {"float32", Number::float32},
     {"double", Number::float64},
     {"float64", Number::float64}}};

std::size_t size_of(Number number) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(number)];
}

struct Property {
  std::string name;
  Number number;
  bool list = false;
  Number list_count = Number::uint8;
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

  Number number(std::string_view name) {
    for (const auto& [known, kind] : kNumbers) {
      if (known == name) return kind;
    }
    file_.fail("unknown type of number " + in_quotes(name));
  }

  InputFile& file_;
  Header header_;
  bool has_format_ = false;
};

/// The numbers of a PLY file's body, one after the other.
class Body {
 public:
  Body(InputFile& file, Encoding encoding) : file_(file), encoding_(encoding) {}

  bool is_text() const { return encoding_ == Encoding::text; }

  /// In text every row of an element is a line.
  void begin_row() {
    if (!is_text()) return;
    do {
      const auto line = file_.next_line();
      if (!line) fail_truncated();
      rest_ = *line;
    } while (rest_.find_first_not_of(" \t\r\v\f") == std::string_view::npos);
  }

  double number(Number kind) {
    if (is_text()) {
      const std::string_view word = take_word(rest_);
      const bool whole = kind != Number::float64 && kind != Number::float32;
      auto value = whole ? to_double(parse_integer(word)) : std::nullopt;
      if (!value) value = to_double(parse_number(word));
      if (!value) {
        file_.fail("a number is expected, not " + in_quotes(word) +
                   "; the file is damaged or truncated, export it again");
      }
      return *value;
    }
    std::array<char, 8> bytes{};
    const std::size_t size = size_of(kind);
    std::memcpy(bytes.data(), file_.take(size), size);
    if (encoding_ == Encoding::big_endian) std::reverse(bytes.begin(), bytes.begin() + size);
    return decode(bytes, kind);
  }

  /// No list can have more entries than there are bytes left for them.
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

  template <class Value>
  static double as(const std::array<char, 8>& bytes) {
    Value value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  }

  static double decode(const std::array<char, 8>& bytes, Number kind) {
    switch (kind) {
      case Number::int8:
        return as<std::int8_t>(bytes);
      case Number::uint8:
        return as<std::uint8_t>(bytes);
      case Number::int16:
        return as<std::int16_t>(bytes);
      case Number::uint16:
        return as<std::uint16_t>(bytes);
      case Number::int32:
        return as<std::int32_t>(bytes);
      case Number::uint32:
        return as<std::uint32_t>(bytes);
      case Number::float32:
        return as<float>(bytes);
      case Number::float64:
        return as<double>(bytes);
    }
    return 0;
  }

  InputFile& file_;
  Encoding encoding_;
  std::string_view rest_;
};

class PlyReader {
 public:
  explicit PlyReader(const std::filesystem::path& path)
      : file_(path), header_(HeaderReader(file_).read()), body_(file_, header_.encoding) {}

  Mesh read_mesh() {
    read_elements(true);
    return mesh_.take();
  }

  LoadedPoints read_points() {
    read_elements(false);
    return make_placed_point_cloud(mesh_.positions(), std::move(normals_));
  }

  bool has_faces() const {
    return std::any_of(header_.elements.begin(), header_.elements.end(),
                       [](const Element& e) { return holds_faces(e) && e.count > 0; });
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
        read_rows(element, [](const Property&, std::span<const double>) {});
      }
    }
  }

  /// An absurd number in the header must not make us ask for as much memory.
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

  /// Calls `use(property, values)` for every property of every row.
  template <class Use>
  void read_rows(const Element& element, const Use& use) {
    for (std::uint64_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      body_.begin_row();
      for (const Property& property : element.properties) {
        values_.clear();
        const double count = property.list ? body_.number(property.list_count) : 1;
        if (!(count >= 0) || count > body_.most_entries() || count != std::floor(count)) {
          body_.fail("a list of " + in_quotes(element.name) +
                     " has an impossible number of entries; the file is damaged");
        }
        for (double i = 0; i < count; ++i) values_.push_back(body_.number(property.number));
        use(property, values_);
      }
    }
  }

  void read_vertices(const Element& element) {
    const std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
    std::array<const Property*, 6> wanted{};
    for (const Property& property : element.properties) {
      const auto name = std::find(names.begin(), names.end(), property.name);
      if (name != names.end() && !property.list) wanted[name - names.begin()] = &property;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (wanted[axis] == nullptr) {
        file_.fail_whole("has vertices without '" + std::string(names[axis]) + "'");
      }
    }
    const bool normals = wanted[3] && wanted[4] && wanted[5];
    mesh_.reserve_vertices(mesh_.vertex_count() + element.count);
    std::array<double, 6> values{};
    const Property* last = &element.properties.back();
    read_rows(element, [&](const Property& property, std::span<const double> read) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (&property == wanted[i]) values[i] = read[0];
      }
      if (&property != last) return;
      mesh_.add_vertex({values[0], values[1], values[2]});
      if (normals) {
        normals_.push_back(Eigen::Vector3d(values[3], values[4], values[5]).cast<float>());
      }
    });
  }

  void read_faces(const Element& element) {
    std::uint64_t face = 0;
    std::vector<Index> corners;
    const char* what = is_strips(element) ? "triangle strip " : "face ";
    read_rows(element, [&](const Property& property, std::span<const double> values) {
      if (!property.list ||
          (property.name != "vertex_indices" && property.name != "vertex_index")) {
        return;
      }
      corners.clear();
      for (const double corner : values) {
        if (is_strips(element) && corner == kStripEnd) {
          add_strip(corners);
          corners.clear();
          continue;
        }
        const bool exists = corner >= 0 && corner < static_cast<double>(mesh_.vertex_count()) &&
                            corner == std::floor(corner);
        if (!exists) {
          body_.fail(what + std::to_string(face) + " has a corner that does not exist: there are " +
                     std::to_string(mesh_.vertex_count()) +
                     " vertices, counted from 0; the file is damaged, export it again");
        }
        corners.push_back(static_cast<Index>(corner));
      }
      is_strips(element) ? add_strip(corners) : mesh_.add_polygon(corners);
      ++face;
    });
  }

  /// Every corner makes a triangle with the two before it, wound the other way round each time.
  /// Corners that repeat turn strips around or join them, and make no triangle of their own.
  void add_strip(std::span<const Index> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const Index a = corners[i - 2], b = corners[i - 1], c = corners[i];
      if (a == b || b == c || c == a) continue;
      mesh_.add_polygon(i % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
    }
  }

  static constexpr double kStripEnd = -1;

  InputFile file_;
  Header header_;
  Body body_;
  MeshBuilder mesh_;
  std::vector<Vec3> normals_;
  std::vector<double> values_;
};

void write_header(std::ostream& out, const Mesh& mesh, const DataArrays& arrays,
                  const std::string& picture) {
  out << "ply\nformat binary_little_endian 1.0\ncomment written by brindle\n";
  if (!picture.empty()) out << "comment TextureFile " << picture << '\n';
  out << "element vertex " << mesh.vertex_count() << '\n' << position_properties(mesh.origin);
  for (const DataArray& array : arrays.points) put_ply_properties(out, array);
  out << "element face " << mesh.triangle_count() << "\nproperty list uchar uint vertex_indices\n";
  for (const DataArray& array : arrays.cells) put_ply_properties(out, array);
  out << "end_header\n";
}

/// The row of every array.
void put_rows(BinaryOutput& binary, std::span<const DataArray> arrays, std::size_t row) {
  for (const DataArray& array : arrays) {
    put_row(binary, array, row);
    if (is_uv(array)) put_row(binary, array, row);
  }
}

}  // namespace

Mesh read_ply(const std::filesystem::path& path) { return PlyReader(path).read_mesh(); }

LoadedPoints read_ply_points(const std::filesystem::path& path) {
  return PlyReader(path).read_points();
}

bool ply_has_faces(const std::filesystem::path& path) { return PlyReader(path).has_faces(); }

void write_ply(std::ostream& out, const Mesh& mesh, const DataArrays& arrays,
               const std::string& picture) {
  write_header(out, mesh, arrays, picture);
  BinaryOutput binary(out);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    put_position(binary, mesh.positions[v], mesh.origin);
    put_rows(binary, arrays.points, v);
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    constexpr unsigned char kThree = 3;
    binary.put(&kThree, 1);
    binary.put(mesh.triangles[t].data(), 3);
    put_rows(binary, arrays.cells, t);
  }
}

}  // namespace brindle
