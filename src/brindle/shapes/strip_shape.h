/// Shapes that can be made in parts: blocks of vertices and strips of triangles between them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/shapes.h"

namespace brindle {

/// Vertices are numbered block by block, triangles strip by strip.
struct StripShape {
  std::vector<Index> block_sizes;
  std::function<Vec3(std::size_t block, Index number)> position;
  std::size_t strips = 0;
  std::function<std::size_t(std::size_t strip)> triangles_of;  ///< how many
  /// The blocks that a strip's vertices are of; it need not use all vertices of a block.
  std::function<std::vector<std::size_t>(std::size_t strip)> blocks_of;
  /// Appends the triangles of a strip; `first` has the numbers of the first vertices of its blocks.
  std::function<void(std::size_t strip, std::span<const Index> first, std::vector<Triangle>&)>
      add_strip;
};

/// How many vertices and triangles the whole shape has.
struct ShapeSize {
  std::uint64_t vertices = 0, triangles = 0;
};
ShapeSize size_of(const StripShape& shape);

/// The whole shape. Throws TooLarge (memory.h) if memory does not hold it, before it is begun, and
/// Cancelled if `progress` asks for it.
Mesh mesh_of(const StripShape& shape, const Progress& progress = {});

/// The strips of one of `parts` parts, with as many triangles as the others as near as strips
/// allow, and the vertices that they use.
ShapePart part_of(const StripShape& shape, int part, int parts);

/// Shapes that do not touch, one after the other, each moved.
struct MovedShape {
  StripShape shape;
  Vec3 way;
};
StripShape joined_shapes(std::vector<MovedShape> shapes);

}  // namespace brindle
