#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "brindle/base/input_file.h"
#include "brindle/base/text.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/files/mesh_builder.h"
#include "brindle/files/mesh_formats.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

constexpr std::uint64_t kHeaderSize = 84;
constexpr std::uint64_t kTriangleSize = 50;
constexpr std::uint64_t kMostTriangles = 0xfffffffe / 3;

/// The number of triangles in a binary file's header; 0 if the file is too short for one.
std::uint64_t promised_triangles(const std::filesystem::path& path) {
  InputFile file(path);
  if (file.remaining() < kHeaderSize) return 0;
  std::uint32_t count = 0;
  std::memcpy(&count, file.take(kHeaderSize) + 80, 4);
  return count;
}

/// Adds the last three vertices as a triangle.
void add_triangle(const InputFile& file, MeshBuilder& mesh) {
  if (mesh.vertex_count() > 3 * kMostTriangles) {
    file.fail_whole("has more triangles than brindle can number; split it into parts");
  }
  const auto end = static_cast<Index>(mesh.vertex_count());
  mesh.add_polygon(Triangle{end - 3, end - 2, end - 1});
}

RawMesh read_binary(const std::filesystem::path& path, std::uint64_t triangles,
                    const Progress& progress) {
  InputFile file(path, progress);
  file.take(kHeaderSize);
  MeshBuilder mesh;
  mesh.reserve_vertices(static_cast<std::size_t>(3 * triangles));
  for (std::uint64_t t = 0; t < triangles; ++t) {
    // A normal, three corners and two unused bytes.
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), file.take(kTriangleSize), sizeof numbers);
    for (std::size_t c = 3; c < 12; c += 3) {
      mesh.add_vertex(Vec3(numbers[c], numbers[c + 1], numbers[c + 2]).cast<double>());
    }
    add_triangle(file, mesh);
  }
  return mesh.take();
}

Eigen::Vector3d read_vertex(const InputFile& file, std::string_view rest) {
  Eigen::Vector3d position;
  for (double& coordinate : position) {
    const std::string_view word = take_word(rest);
    const auto value = parse_number(word);
    if (!value) {
      file.fail("a vertex needs three numbers, not " + in_quotes(word) +
                "; the file is damaged or truncated, export it again");
    }
    coordinate = *value;
  }
  return position;
}

RawMesh read_text(const std::filesystem::path& path, const Progress& progress) {
  InputFile file(path, progress);
  MeshBuilder mesh;
  std::uint64_t facets = 0;
  bool ended = false;
  while (const auto line = file.next_line()) {
    std::string_view rest = *line;
    const std::string_view keyword = take_word(rest);
    if (same_letters(keyword, "vertex")) {
      mesh.add_vertex(read_vertex(file, rest));
    } else if (same_letters(keyword, "endfacet")) {
      if (mesh.vertex_count() != 3 * ++facets) {
        file.fail("a facet has three vertices; the file is damaged");
      }
      add_triangle(file, mesh);
    } else if (same_letters(keyword, "endsolid")) {
      ended = true;
    } else if (same_letters(keyword, "solid")) {
      ended = false;
    }
  }
  if (facets == 0) file.fail_whole("has no triangles, or is no STL file; export it again");
  if (!ended || mesh.vertex_count() != 3 * facets) {
    file.fail_whole("ends before its 'endsolid': it is truncated; copy or export it again");
  }
  return mesh.take();
}

}  // namespace

RawMesh read_stl(const std::filesystem::path& path, const Progress& progress) {
  InputFile file(path);
  const std::uint64_t size = file.remaining();
  const std::uint64_t triangles = promised_triangles(path);
  const bool whole_binary = size >= kHeaderSize && size >= kHeaderSize + kTriangleSize * triangles;
  const bool starts_as_text = size > 5 && same_letters({file.take(5), 5}, "solid");
  // Many binary files start with "solid" too; their size identifies them.
  if (whole_binary && (!starts_as_text || size == kHeaderSize + kTriangleSize * triangles)) {
    if (triangles == 0) file.fail_whole("has no triangles; export it again");
    return read_binary(path, triangles, progress);
  }
  if (!starts_as_text) {
    file.fail_whole("is too short for the " + std::to_string(triangles) +
                    " triangles that its header names, or is no STL file: it is truncated or "
                    "damaged; copy or export it again");
  }
  return read_text(path, progress);
}

void write_stl(OutputStream& out, const Mesh& mesh) {
  BinaryOutput binary(out);
  // Files that start with "solid" are text to many readers.
  std::array<char, 80> header = {};
  constexpr std::string_view kHeader = "binary STL by brindle";
  std::copy(kHeader.begin(), kHeader.end(), header.begin());
  binary.put(header);
  binary.put(static_cast<std::uint32_t>(mesh.triangle_count()));
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> corners;
    for (int m = 0; m < 3; ++m) {
      corners[m] = (mesh.positions[t[m]].cast<double>() + mesh.origin).cast<float>();
    }
    // Of the numbers in the file, as readers check it.
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    binary.put(normal.data(), 3);
    for (const Vec3& corner : corners) binary.put(corner.data(), 3);
    binary.put(std::uint16_t{0});
  }
}

}  // namespace brindle
