#include "brindle/files/off_file.h"

#include <array>
#include <string>
#include <vector>

#include "brindle/base/printable.h"
#include "brindle/files/input_file.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/geometry/polygon.h"

namespace brindle {
namespace {

constexpr std::string_view kRemedy = "; the file is damaged or truncated, export it again";

class OffReader {
 public:
  OffReader(const std::filesystem::path& path, const Progress& progress) : file_(path, progress) {}

  Mesh read() {
    read_header();
    for (std::uint64_t v = 0; v < vertices_; ++v) read_vertex();
    for (std::uint64_t f = 0; f < faces_; ++f) read_face();
    return mesh_.take();
  }

 private:
  /// The next line that is not blank or a comment.
  std::string_view content() {
    while (auto line = file_.next_line()) {
      *line = line->substr(0, line->find('#'));
      if (line->find_first_not_of(" \t\r\v\f") != std::string_view::npos) return *line;
    }
    file_.fail_whole("ends before all " + std::to_string(vertices_) + " vertices and " +
                     std::to_string(faces_) + " faces: it is truncated; export it again");
  }

  void read_header() {
    std::string_view line = content();
    const std::string_view keyword = take_word(line);
    const bool known =
        keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF" &&
        keyword.substr(0, keyword.size() - 3).find_first_not_of("STCN") == std::string_view::npos;
    std::string_view after = line;
    if (!known || take_word(after) == "BINARY") {
      file_.fail("brindle reads text OFF files in three dimensions, this begins with " +
                 in_quotes(keyword) + "; convert it to PLY or OBJ");
    }
    // The counts may share the line of the keyword.
    after = line;
    if (take_word(after).empty()) line = content();
    vertices_ = read_count(line);
    faces_ = read_count(line);
    // Every vertex takes a line of six characters at least, every face one of four.
    if (vertices_ > file_.remaining() / 5 || faces_ > file_.remaining() / 3) {
      file_.fail("the file is too short for " + std::to_string(vertices_) + " vertices and " +
                 std::to_string(faces_) + " faces" + std::string(kRemedy));
    }
    mesh_.reserve_vertices(vertices_);
  }

  std::uint64_t read_count(std::string_view& line) {
    const std::string_view word = take_word(line);
    const auto number = parse_integer(word);
    if (!number || *number < 0 || *number > 0xfffffffe) {
      file_.fail("the numbers of vertices and faces must stand here" + std::string(kRemedy));
    }
    return static_cast<std::uint64_t>(*number);
  }

  void read_vertex() {
    std::string_view line = content();
    Eigen::Vector3d position;
    for (double& coordinate : position) {
      const std::string_view word = take_word(line);
      const auto value = parse_number(word);
      if (!value) {
        file_.fail("a vertex needs three numbers, not " + in_quotes(word) + std::string(kRemedy));
      }
      coordinate = *value;
    }
    mesh_.add_vertex(position);
  }

  void read_face() {
    std::string_view line = content();
    const auto count = parse_integer(take_word(line));
    if (!count || *count < 0) {
      file_.fail("a face begins with its number of corners" + std::string(kRemedy));
    }
    corners_.clear();
    for (std::int64_t i = 0; i < *count; ++i) {
      const std::string_view word = take_word(line);
      const auto corner = parse_integer(word);
      if (!corner || *corner < 0 || static_cast<std::uint64_t>(*corner) >= vertices_) {
        file_.fail(in_quotes(word) + " is no vertex: there are " + std::to_string(vertices_) +
                   ", counted from 0" + std::string(kRemedy));
      }
      corners_.push_back(static_cast<Index>(*corner));
    }
    mesh_.add_polygon(corners_);
  }

  InputFile file_;
  MeshBuilder mesh_;
  std::uint64_t vertices_ = 0, faces_ = 0;
  std::vector<Index> corners_;
};

}  // namespace

Mesh read_off(const std::filesystem::path& path, const Progress& progress) {
  return OffReader(path, progress).read();
}

}  // namespace brindle
