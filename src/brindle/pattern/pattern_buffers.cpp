#include "brindle/pattern_buffers.h"

#include <string>

#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

void check_size(std::size_t size, std::size_t expected, const std::string& what,
                const char* per = "vertices") {
  if (size == expected) return;
  throw Error("pattern buffers: there are " + std::to_string(size) + " " + what + " for " +
              std::to_string(expected) + " " + per);
}

std::array<float, 3> components(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

void fill_pattern_vertices(const PatternArrays& arrays, std::span<PatternVertex> vertices) {
  const std::size_t count = arrays.positions.size();
  check_size(arrays.normals.size(), count, "normals");
  check_size(arrays.directions.size(), count, "directions");
  check_size(arrays.frequencies.size(), count, "frequencies");
  check_size(arrays.z.size(), count, "phases");
  check_size(vertices.size(), count, "entries");
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      vertices[v] = {components(arrays.positions[v]),  arrays.frequencies[v],
                     components(arrays.directions[v]), arrays.z[v].real(),
                     components(arrays.normals[v]),    arrays.z[v].imag()};
    }
  });
}

PatternBuffers pattern_buffers(const PatternArrays& arrays, std::span<const Triangle> triangles,
                               std::span<const CornerPhases> corners) {
  if (!corners.empty()) check_size(corners.size(), triangles.size(), "kinds", "triangles");
  PatternBuffers buffers;
  buffers.vertices.resize(arrays.positions.size());
  fill_pattern_vertices(arrays, buffers.vertices);
  buffers.triangles.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index v : triangles[t]) {
      if (v < arrays.positions.size()) continue;
      throw Error("pattern buffers: triangle " + std::to_string(t) + " has a corner " +
                  std::to_string(v) + ", and there are " + std::to_string(arrays.positions.size()) +
                  " vertices");
    }
    const TriangleKind kind = corners.empty() ? TriangleKind::regular : corners[t].kind;
    buffers.triangles.push_back({triangles[t], static_cast<std::uint32_t>(kind)});
  }
  return buffers;
}

}  // namespace brindle
