/// Shapes that can be made in parts: blocks of vertices, and strips of triangles between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/shapes.h"

namespace brindle {

/// Vertices are numbered by block, triangles by strip.
struct StripShape {
  std::vector<Index> block_sizes;
  std::function<Vec3(std::size_t block, Index number)> position;
  std::size_t strips = 0;
  std::function<std::size_t(std::size_t strip)> triangles_of;  ///< number of triangles
  /// The blocks with the strip's vertices, not all of which need to be used.
  std::function<std::vector<std::size_t>(std::size_t strip)> blocks_of;
  /// Appends the triangles of a strip; `first` has the first vertex of each of its blocks.
  std::function<void(std::size_t strip, std::span<const Index> first, std::vector<Triangle>&)>
      add_strip;
};

/// Numbers of vertices and triangles.
struct ShapeSize {
  std::uint64_t vertices = 0, triangles = 0;
};
ShapeSize size_of(const StripShape& shape);

/// The whole shape. Throws TooLarge (memory.h), before it starts, if it exceeds the memory limit;
/// Cancelled.
Mesh mesh_of(const StripShape& shape, const Progress& progress = {});

/// The strips of one of `parts` parts, balanced by triangles, and their vertices.
ShapePart part_of(const StripShape& shape, int part, int parts);

/// Disjoint shapes, one after the other, each translated.
struct MovedShape {
  StripShape shape;
  Vec3 way;
};
StripShape joined_shapes(std::vector<MovedShape> shapes);

}  // namespace brindle
