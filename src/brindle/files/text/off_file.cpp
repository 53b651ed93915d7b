#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "brindle/base/input_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/mesh_formats.h"

namespace brindle {
namespace {

constexpr std::string_view kRemedy = "; the file is damaged or truncated, export it again";

/// Whether vertices and faces end with their line. The format is a stream of words, but many files
/// have undeclared colours after their vertices, and most end faces with the line.
struct OffLayout {
  bool vertices_by_line = true;
  bool faces_by_line = true;
};

class OffReader {
 public:
  OffReader(const std::filesystem::path& path, const Progress& progress) : file_(path, progress) {}

  RawMesh read(const OffLayout& layout) {
    layout_ = layout;
    read_keyword();
    binary_ ? read_binary() : read_text();
    return mesh_.take();
  }

 private:
  // ----------------------------------------------------------------------------------------------

  /// Whether a word is left; `line_` then begins with it.
  bool has_word() {
    constexpr std::string_view kBlanks = " \t\r\v\f";
    while (line_.find_first_not_of(kBlanks) == std::string_view::npos) {
      const auto line = file_.next_line();
      if (!line) return false;
      line_ = line->substr(0, line->find('#'));
    }
    return true;
  }

  std::string_view next_word() {
    if (!has_word()) fail_short();
    return take_word(line_);
  }

  [[noreturn]] void fail_short() const {
    file_.fail_whole("ends before all " + std::to_string(vertices_) + " vertices and " +
                     std::to_string(faces_) + " faces: it is truncated; export it again");
  }

  /// Reads the keyword, such as STCNOFF: letters before OFF declare further numbers per vertex. The
  /// number of vertices may follow without a space.
  void read_keyword() {
    const std::string_view word = next_word();
    const std::size_t off = word.find("OFF");
    const std::string_view before = word.substr(0, off);
    if (off == std::string_view::npos || before.find_first_not_of("STCN") != before.npos) {
      file_.fail("brindle reads OFF files in three dimensions, this begins with " +
                 in_quotes(word) + "; convert it to PLY or OBJ");
    }
    numbers_ = 3;
    if (before.find('N') != before.npos) numbers_ += 3;
    if (before.find('C') != before.npos) numbers_ += 4;
    if (before.find('T') != before.npos) numbers_ += 2;
    std::string_view after = line_;
    binary_ = word.size() == off + 3 && take_word(after) == "BINARY";
    // The rest of the keyword is the first count.
    if (word.size() > off + 3) {
      const char* const rest = word.data() + off + 3;
      line_ = {rest, static_cast<std::size_t>(line_.data() + line_.size() - rest)};
    }
  }

  // ----------------------------------------------------------------------------------------------

  void read_text() {
    vertices_ = read_count();
    const std::size_t line = file_.line();
    faces_ = read_count();
    // The unused number of edges may be missing from the line.
    if (file_.line() != line) {
      next_word();
    } else if (line_.find_first_not_of(" \t\r\v\f") != std::string_view::npos) {
      take_word(line_);
    }
    // A vertex takes at least five characters, a face three.
    check_sizes(file_.remaining() + line_.size(), 5, 3);
    // Words after the counts in the same line have no line of their own.
    if (has_word_in_line()) layout_ = {false, false};
    for (std::uint64_t v = 0; v < vertices_; ++v) read_vertex();
    for (std::uint64_t f = 0; f < faces_; ++f) read_face();
    if (!layout_.vertices_by_line && has_word()) {
      file_.fail("more words than " + std::to_string(vertices_) + " vertices and " +
                 std::to_string(faces_) + " faces have" + std::string(kRemedy));
    }
  }

  bool has_word_in_line() const {
    return line_.find_first_not_of(" \t\r\v\f") != std::string_view::npos;
  }

  std::uint64_t read_count() {
    const auto number = parse_integer(next_word());
    if (!number || *number < 0 || *number > 0xfffffffe) {
      file_.fail("the numbers of vertices and faces must stand here" + std::string(kRemedy));
    }
    return static_cast<std::uint64_t>(*number);
  }

  void check_sizes(std::uint64_t bytes, std::uint64_t vertex, std::uint64_t face) {
    if (vertices_ > bytes / vertex || faces_ > bytes / face) {
      file_.fail("the file is too short for " + std::to_string(vertices_) + " vertices and " +
                 std::to_string(faces_) + " faces" + std::string(kRemedy));
    }
    mesh_.reserve_vertices(static_cast<std::size_t>(vertices_));
  }

  double read_number() {
    const std::string_view word = next_word();
    const auto value = parse_number(word);
    if (!value) {
      file_.fail("a vertex needs three numbers, not " + in_quotes(word) + std::string(kRemedy));
    }
    return *value;
  }

  void read_vertex() {
    Eigen::Vector3d position;
    for (double& coordinate : position) coordinate = read_number();
    mesh_.add_vertex(position);
    if (layout_.vertices_by_line) {
      line_ = {};
    } else {
      for (int i = 3; i < numbers_; ++i) read_number();
    }
  }

  void read_face() {
    const auto count = parse_integer(next_word());
    if (!count || *count < 0) {
      file_.fail("a face begins with its number of corners" + std::string(kRemedy));
    }
    corners_.clear();
    for (std::int64_t i = 0; i < *count; ++i) {
      const std::string_view word = next_word();
      const auto corner = parse_integer(word);
      if (!corner || *corner < 0) fail_corner(in_quotes(word));
      add_corner(static_cast<std::uint64_t>(*corner));
    }
    mesh_.add_polygon(corners_);
    if (layout_.faces_by_line) line_ = {};
  }

  void add_corner(std::uint64_t corner) {
    if (corner >= vertices_) fail_corner('\'' + std::to_string(corner) + '\'');
    corners_.push_back(static_cast<Index>(corner));
  }

  [[noreturn]] void fail_corner(const std::string& corner) const {
    const std::string message = corner + " is no vertex: there are " + std::to_string(vertices_) +
                                ", counted from 0" + std::string(kRemedy);
    binary_ ? file_.fail_whole(message) : file_.fail(message);
  }

  // ----------------------------------------------------------------------------------------------

  /// 32-bit numbers, big endian.
  template <class Number>
  Number take_binary() {
    std::array<std::byte, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), file_.take(sizeof(Number)), sizeof(Number));
    if constexpr (std::endian::native == std::endian::little) reverse_bytes(bytes, sizeof(Number));
    return bit_cast<Number>(bytes);
  }

  void read_binary() {
    vertices_ = take_binary<std::uint32_t>();
    faces_ = take_binary<std::uint32_t>();
    take_binary<std::uint32_t>();  // edges
    check_sizes(file_.remaining(), 4 * static_cast<std::uint64_t>(numbers_), 8);
    for (std::uint64_t v = 0; v < vertices_; ++v) {
      Eigen::Vector3d position;
      for (double& coordinate : position) coordinate = take_binary<float>();
      mesh_.add_vertex(position);
      for (int i = 3; i < numbers_; ++i) take_binary<float>();
    }
    for (std::uint64_t f = 0; f < faces_; ++f) read_binary_face();
  }

  void read_binary_face() {
    corners_.clear();
    const std::uint32_t corners = take_length();
    for (std::uint32_t i = 0; i < corners; ++i) add_corner(take_binary<std::uint32_t>());
    mesh_.add_polygon(corners_);
    const std::uint32_t colors = take_length();
    for (std::uint32_t i = 0; i < colors; ++i) take_binary<float>();
  }

  /// The length of a list.
  std::uint32_t take_length() {
    const auto length = take_binary<std::uint32_t>();
    if (length > file_.remaining() / 4) fail_short();
    return length;
  }

  InputFile file_;
  OffLayout layout_;
  MeshBuilder mesh_;
  std::string_view line_;  ///< the rest of the line
  bool binary_ = false;
  int numbers_ = 3;  ///< per vertex
  std::uint64_t vertices_ = 0, faces_ = 0;
  std::vector<Index> corners_;
};

}  // namespace

RawMesh read_off(const std::filesystem::path& path, const Progress& progress) {
  std::optional<Error> first;
  // A file that is not valid line by line may be valid word by word.
  for (const OffLayout layout : {OffLayout{}, OffLayout{false, true}, OffLayout{false, false}}) {
    try {
      return OffReader(path, progress).read(layout);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      if (!first) first = error;
    }
  }
  throw Error(*first);
}

}  // namespace brindle
