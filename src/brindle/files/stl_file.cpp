#include "brindle/files/stl_file.h"

#include <cstdint>
#include <cstring>
#include <string>

#include "brindle/files/input_file.h"

namespace brindle {
namespace {

constexpr std::uint64_t kHeaderSize = 84;
constexpr std::uint64_t kTriangleSize = 50;

/// The number of triangles that a binary file's header promises; 0 if there is no room for one.
std::uint64_t promised_triangles(const std::filesystem::path& path) {
  InputFile file(path);
  if (file.remaining() < kHeaderSize) return 0;
  std::uint32_t count = 0;
  std::memcpy(&count, file.take(kHeaderSize) + 80, 4);
  return count;
}

void check_vertex(const InputFile& file, std::string_view rest) {
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = take_word(rest);
    if (!parse_float(word)) {
      file.fail("a vertex needs three numbers, not '" + std::string(word.substr(0, 40)) +
                "'; the file is damaged or truncated, export it again");
    }
  }
}

void check_text(const std::filesystem::path& path) {
  InputFile file(path);
  std::uint64_t vertices = 0, facets = 0;
  bool ended = false;
  while (const auto line = file.next_line()) {
    std::string_view rest = *line;
    const std::string_view keyword = take_word(rest);
    if (keyword == "vertex") {
      check_vertex(file, rest);
      ++vertices;
    } else if (keyword == "endfacet") {
      if (vertices != 3 * ++facets) file.fail("a facet has three vertices; the file is damaged");
    } else if (keyword == "endsolid") {
      ended = true;
    } else if (keyword == "solid") {
      ended = false;
    }
  }
  if (facets == 0) file.fail_whole("has no triangles, or is no STL file; export it again");
  if (!ended || vertices != 3 * facets) {
    file.fail_whole("ends before its 'endsolid': it is truncated; copy or export it again");
  }
}

}  // namespace

void check_stl(const std::filesystem::path& path) {
  InputFile file(path);
  const std::uint64_t size = file.remaining();
  const std::uint64_t triangles = promised_triangles(path);
  const bool whole_binary = size >= kHeaderSize && size >= kHeaderSize + kTriangleSize * triangles;
  const bool starts_as_text = size > 5 && std::string_view(file.take(5), 5) == "solid";
  // Many programs let binary files begin with "solid" too; their size gives them away.
  if (whole_binary && (!starts_as_text || size == kHeaderSize + kTriangleSize * triangles)) {
    if (triangles == 0) file.fail_whole("has no triangles; export it again");
    return;
  }
  if (!starts_as_text) {
    file.fail_whole("is too short for the " + std::to_string(triangles) +
                    " triangles that its header names, or is no STL file: it is truncated or "
                    "damaged; copy or export it again");
  }
  check_text(path);
}

}  // namespace brindle
