#include <algorithm>
#include <string>
#include <vector>

#include "brindle/base/array_numbers.h"
#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/point_output.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path, const Progress& progress = {})
      : file_(path, progress) {
    file_.check_text("an OBJ file");
  }

  RawMesh read_mesh() {
    FileElements elements;
    while (const auto line = next_whole_line()) {
      std::string_view rest = *line;
      const std::string_view keyword = take_word(rest);
      if (keyword == "v") {
        add_vertex(rest);
      } else if (keyword == "f") {
        add_face(rest);
        elements.faces = true;
      } else if (keyword == "l") {
        elements.lines = true;
      } else if (keyword == "vt") {
        has_coordinates_ = true;
      }
    }
    check_forward_references();
    RawMesh raw = mesh_.take();
    raw.left_out = left_out();
    raw.elements = elements;
    return raw;
  }

  LoadedPoints read_points() {
    std::vector<Vec3> normals;
    bool in_order = true;
    while (const auto line = next_whole_line()) {
      std::string_view rest = *line;
      const std::string_view keyword = take_word(rest);
      if (keyword == "v") {
        add_vertex(rest);
      } else if (keyword == "vn") {
        normals.push_back(three_numbers("normal", rest).cast<float>());
      } else if (keyword == "f") {
        in_order = in_order && has_normals_of_their_own(rest);
      }
    }
    // Normals belong to points only if both have the same numbers.
    if (!in_order || normals.size() != mesh_.vertex_count()) normals.clear();
    LoadedPoints loaded = make_placed_point_cloud(mesh_.positions(), std::move(normals));
    loaded.left_out = left_out();
    return loaded;
  }

 private:
  /// A corner that refers to a later vertex.
  struct ForwardReference {
    std::int64_t number;
    std::size_t line;
  };

  /// A backslash at the end of a line continues it.
  std::optional<std::string_view> next_whole_line() {
    auto line = file_.next_line();
    if (!line || line->empty() || line->back() != '\\') return line;
    joined_.clear();
    while (line && !line->empty() && line->back() == '\\') {
      joined_.append(line->substr(0, line->size() - 1)).push_back(' ');
      line = file_.next_line();
    }
    if (line) joined_.append(*line);
    return joined_;
  }

  /// Whether all normal indices of the face equal its vertex indices.
  static bool has_normals_of_their_own(std::string_view rest) {
    for (auto word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
      const std::size_t first = word.find('/'), last = word.rfind('/');
      if (first == last) continue;
      if (word.substr(0, first) != word.substr(last + 1)) return false;
    }
    return true;
  }

  void add_vertex(std::string_view rest) {
    mesh_.add_vertex(three_numbers("vertex", rest));
    // Red, green and blue, which the format does not define; a single fourth number is a weight.
    const bool has_fourth = parse_number(take_word(rest)).has_value();
    has_colors_ = has_colors_ || (has_fourth && parse_number(take_word(rest)).has_value());
  }

  std::string left_out() const {
    std::string text;
    const auto line = [&](bool has, const char* what) {
      if (has) text += std::string(what) + ": left out, brindle reads none from .obj\n";
    };
    line(has_colors_, "colors of vertices");
    line(has_coordinates_, "texture coordinates");
    return text;
  }

  /// Removes them from the line.
  Eigen::Vector3d three_numbers(const char* what, std::string_view& rest) {
    Eigen::Vector3d numbers;
    for (double& number : numbers) {
      const std::string_view word = take_word(rest);
      const auto value = parse_number(word);
      if (!value) {
        file_.fail(std::string("a ") + what + " needs three numbers, not " + in_quotes(word));
      }
      number = *value;
    }
    return numbers;
  }

  void add_face(std::string_view rest) {
    corners_.clear();
    for (auto word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (word[0] == '#') break;
      corners_.push_back(corner(word));
    }
    if (corners_.size() < 3) {
      file_.fail("a face needs three corners or more, this has " + std::to_string(corners_.size()) +
                 "; the file may be truncated");
    }
    mesh_.add_polygon(corners_);
  }

  /// The vertex of "7", "7/1", "7//3", "7/1/3" or of a negative number, which counts back.
  Index corner(std::string_view word) {
    const auto number = parse_integer(word.substr(0, word.find('/')));
    const auto count = static_cast<std::int64_t>(mesh_.vertex_count());
    if (!number) file_.fail(in_quotes(word) + " is not a face's corner");
    if (*number == 0 || *number < -count || *number > kMostVertices) {
      file_.fail(missing(*number));
    }
    if (*number < 0) return static_cast<Index>(count + *number);
    if (*number > count && *number > furthest_) {
      furthest_ = *number;
      forward_.push_back({*number, file_.line()});
    }
    return static_cast<Index>(*number - 1);
  }

  std::string missing(std::int64_t number) const {
    return "vertex " + std::to_string(number) + " does not exist: there are " +
           std::to_string(mesh_.vertex_count()) +
           ", counted from 1; the file is damaged or truncated, export it again";
  }

  /// The largest forward reference is noted, so checking the noted ones is enough.
  void check_forward_references() const {
    for (const auto& [number, line] : forward_) {
      if (number > static_cast<std::int64_t>(mesh_.vertex_count())) {
        file_.fail_at(line, missing(number));
      }
    }
  }

  static constexpr std::int64_t kMostVertices = 0xfffffffe;

  InputFile file_;
  MeshBuilder mesh_;
  std::vector<Index> corners_;
  std::vector<ForwardReference> forward_;
  std::int64_t furthest_ = 0;
  std::string joined_;
  bool has_colors_ = false, has_coordinates_ = false;
};

constexpr std::string_view kMaterial = "brindle";

const DataArray* first_of(std::span<const DataArray> arrays, bool (*is)(const DataArray&)) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), is);
  return found == arrays.end() ? nullptr : &*found;
}

/// One line per row; none without an array.
void write_rows(TextOutput& text, std::string_view keyword, const DataArray* array) {
  if (array == nullptr) return;
  const std::size_t columns = array->view().columns();
  for_each_number(array->view(), [&](std::size_t, std::size_t column, auto number) {
    if (column == 0) text << keyword;
    text << ' ' << number;
    if (column + 1 == columns) text << '\n';
  });
}

}  // namespace

RawMesh read_obj(const std::filesystem::path& path, const Progress& progress) {
  return ObjReader(path, progress).read_mesh();
}

LoadedPoints read_obj_points(const std::filesystem::path& path) {
  return ObjReader(path).read_points();
}

void write_obj(OutputStream& out, const Mesh& mesh, std::span<const DataArray> arrays,
               const std::string& materials) {
  const DataArray* normal = first_of(arrays, is_normal);
  const DataArray* uv = first_of(arrays, is_uv);
  TextOutput text(out);
  text << "# written by brindle\n";
  if (!materials.empty()) text << "mtllib " << materials << '\n';
  write_positions(text, "v", mesh.positions, mesh.origin);
  write_rows(text, "vt", uv);
  write_rows(text, "vn", normal);
  if (!materials.empty()) text << "usemtl " << kMaterial << '\n';
  for (const Triangle& t : mesh.triangles) {
    text << 'f';
    for (const Index v : t) {
      text << ' ' << v + 1;
      if (uv != nullptr) text << '/' << v + 1;
      if (normal != nullptr) text << (uv == nullptr ? "//" : "/") << v + 1;
    }
    text << '\n';
  }
}

std::string material_library(const std::string& picture) {
  const std::string name(kMaterial);
  return "# written by brindle\nnewmtl " + name +
         "\nKa 0.2 0.2 0.2\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + picture + "\n";
}

}  // namespace brindle
