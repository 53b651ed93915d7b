#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#ifdef BRINDLE_HAS_JSON
#include <nlohmann/json.hpp>
#endif

#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/strokes.h"

namespace brindle {

namespace fs = std::filesystem;

void write_strokes(const fs::path& path, std::span<const FieldStroke> strokes) {
  check_strokes(strokes);
  write_file(path, [&](OutputStream& stream) {
    TextOutput out(stream);
    out << "{\"strokes\": [";
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      const FieldStroke& stroke = strokes[i];
      out << (i > 0 ? "," : "") << "\n  {\"radius\": " << stroke.radius
          << ", \"strength\": " << stroke.strength << ", \"points\": [";
      for (std::size_t k = 0; k < stroke.points.size(); ++k) {
        const Eigen::Vector3d& p = stroke.points[k];  // -0 would be read as an integer
        out << (k > 0 ? "," : "") << "\n    [" << p.x() + 0.0 << ", " << p.y() + 0.0 << ", "
            << p.z() + 0.0 << ']';
      }
      out << "]}";
    }
    out << "\n]}\n";
  });
}

#ifdef BRINDLE_HAS_JSON

namespace {

using StrokeJson = nlohmann::json;

/// Names places in the file as JSON paths: "strokes[2].points[5]".
class StrokeReader {
 public:
  StrokeReader(const fs::path& path, const StrokeJson& json) : path_(path), json_(json) {}

  std::vector<FieldStroke> read() const {
    const std::string whole = "the file";
    check_keys(json_, whole, {"strokes"});
    const StrokeJson& list = member(json_, whole, "strokes");
    check_list(list, "strokes");
    if (list.empty()) fail("'strokes' is empty; draw at least one, or leave out the file");
    std::vector<FieldStroke> strokes;
    for (std::size_t i = 0; i < list.size(); ++i) {
      strokes.push_back(stroke(list[i], "strokes[" + std::to_string(i) + "]"));
    }
    return strokes;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(shown(path_.string()) + ": " + what);
  }

  void check_keys(const StrokeJson& object, const std::string& name,
                  std::initializer_list<const char*> known) const {
    std::string list;
    for (const char* key : known) list += (list.empty() ? "" : ", ") + std::string(key);
    if (!object.is_object()) fail(name + " must be an object with the keys " + list);
    for (const auto& [key, value] : object.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      fail(name + " has the unknown key " + in_quotes(key) + "; known are: " + list);
    }
  }

  const StrokeJson& member(const StrokeJson& object, const std::string& name,
                           const char* key) const {
    const auto found = object.find(key);
    if (found == object.end()) fail(name + " lacks '" + key + "'");
    return *found;
  }

  void check_list(const StrokeJson& value, const std::string& name) const {
    if (!value.is_array()) fail(name + " must be a list, not " + value.type_name());
  }

  double number(const StrokeJson& value, const std::string& name) const {
    if (!value.is_number()) fail(name + " must be a number, not " + value.type_name());
    return value.get<double>();
  }

  FieldStroke stroke(const StrokeJson& json, const std::string& name) const {
    check_keys(json, name, {"points", "radius", "strength"});
    FieldStroke result;
    result.radius = number(member(json, name, "radius"), name + ".radius");
    if (json.contains("strength")) result.strength = number(json["strength"], name + ".strength");
    const StrokeJson& points = member(json, name, "points");
    check_list(points, name + ".points");
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::string point = name + ".points[" + std::to_string(i) + "]";
      check_list(points[i], point);
      if (points[i].size() != 3) {
        fail(point + " must have 3 numbers x, y, z, not " + std::to_string(points[i].size()));
      }
      result.points.emplace_back();
      for (int axis = 0; axis < 3; ++axis) {
        result.points.back()[axis] =
            number(points[i][axis], point + "[" + std::to_string(axis) + "]");
      }
    }
    return result;
  }

  const fs::path& path_;
  const StrokeJson& json_;
};

/// Without the JSON library's prefix: "parse error at line 3, column 5: ...".
std::string reason_of(const StrokeJson::exception& error) {
  const std::string text = printable(error.what());
  const std::size_t tag = text.find("] ");
  return tag == std::string::npos ? text : text.substr(tag + 2);
}

}  // namespace

std::vector<FieldStroke> read_strokes(const fs::path& path) {
  InputFile file(path);
  const auto size = static_cast<std::size_t>(file.size());
  const std::string text(file.take(size), size);
  StrokeJson json;
  try {
    json = StrokeJson::parse(text);
  } catch (const StrokeJson::exception& error) {
    throw Error(shown(path.string()) + ": damaged JSON: " + reason_of(error) +
                "; correct it there or write the file again");
  }
  std::vector<FieldStroke> strokes = StrokeReader(path, json).read();
  try {
    check_strokes(strokes);
  } catch (const Error& error) {
    throw Error(shown(path.string()) + ": " + error.what());
  }
  return strokes;
}

#else

std::vector<FieldStroke> read_strokes(const fs::path& path) {
  throw Error(shown(path.string()) +
              ": this brindle was built without nlohmann-json and reads no strokes; install it and "
              "build again");
}

#endif  // BRINDLE_HAS_JSON

}  // namespace brindle
