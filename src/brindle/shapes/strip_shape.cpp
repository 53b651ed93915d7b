#include "brindle/shapes/strip_shape.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"

namespace brindle {
namespace {

struct StripRange {
  std::size_t begin, end;
};

StripRange strips_of_part(const StripShape& shape, int part, int parts) {
  std::size_t all = 0;
  for (std::size_t strip = 0; strip < shape.strips; ++strip) all += shape.triangles_of(strip);
  const auto begins_at = [&](int p) {
    return all * static_cast<std::size_t>(p) / static_cast<std::size_t>(parts);
  };
  StripRange range{shape.strips, shape.strips};
  std::size_t before = 0;
  for (std::size_t strip = 0; strip < shape.strips; ++strip) {
    if (before >= begins_at(part)) range.begin = std::min(range.begin, strip);
    if (before >= begins_at(part + 1)) range.end = std::min(range.end, strip);
    before += shape.triangles_of(strip);
  }
  return range;
}

ShapePart with_strips(const StripShape& shape, StripRange range, const Progress& progress) {
  const std::size_t blocks = shape.block_sizes.size();
  std::vector<std::uint8_t> wanted(blocks);
  for (std::size_t strip = range.begin; strip < range.end; ++strip) {
    for (const std::size_t block : shape.blocks_of(strip)) wanted[block] = 1;
  }
  std::size_t vertices = 0, triangles = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    if (wanted[block]) vertices += shape.block_sizes[block];
  }
  for (std::size_t strip = range.begin; strip < range.end; ++strip) {
    triangles += shape.triangles_of(strip);
  }
  ShapePart made;
  made.mesh.positions.reserve(vertices);
  made.vertex_ids.reserve(vertices);
  made.mesh.triangles.reserve(triangles);
  std::vector<Index> first(blocks);
  std::uint64_t number = 0;
  Reporter placed(progress.part(0, 0.8), vertices);
  for (std::size_t block = 0; block < blocks; number += shape.block_sizes[block++]) {
    if (!wanted[block]) continue;
    first[block] = static_cast<Index>(made.vertex_ids.size());
    for (Index i = 0; i < shape.block_sizes[block]; ++i) {
      made.mesh.positions.push_back(shape.position(block, i));
      made.vertex_ids.push_back(number + i);
      placed.done(1);
    }
  }
  std::vector<Index> firsts;
  Reporter joined(progress.part(0.8, 1), triangles);
  for (std::size_t strip = range.begin; strip < range.end; ++strip) {
    firsts.clear();
    for (const std::size_t block : shape.blocks_of(strip)) firsts.push_back(first[block]);
    shape.add_strip(strip, firsts, made.mesh.triangles);
    joined.done(shape.triangles_of(strip));
  }
  return made;
}

void drop_unused(ShapePart& part) {
  std::vector<std::uint8_t> used(part.vertex_ids.size());
  for (const Triangle& triangle : part.mesh.triangles) {
    for (const Index v : triangle) used[v] = 1;
  }
  std::vector<std::uint64_t> ids;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) ids.push_back(part.vertex_ids[v]);
  }
  part.vertex_ids = std::move(ids);
  drop_unreferenced_vertices(part.mesh);
}

}  // namespace

ShapeSize size_of(const StripShape& shape) {
  ShapeSize size;
  for (const Index block : shape.block_sizes) size.vertices += block;
  for (std::size_t strip = 0; strip < shape.strips; ++strip) {
    size.triangles += shape.triangles_of(strip);
  }
  return size;
}

Mesh mesh_of(const StripShape& shape, const Progress& progress) {
  const ShapeSize size = size_of(shape);
  const auto vertices = static_cast<double>(size.vertices);
  const double bytes = vertices * (sizeof(Vec3) + sizeof(std::uint64_t)) +
                       static_cast<double>(size.triangles) * sizeof(Triangle);
  check_fits(vertices, bytes / std::max(1.0, vertices), "the surface", "vertices",
             [](double most) { return "one of " + rounded_down(most) + " would do"; });
  return with_strips(shape, {0, shape.strips}, progress).mesh;
}

ShapePart part_of(const StripShape& shape, int part, int parts) {
  ShapePart made = with_strips(shape, strips_of_part(shape, part, parts), {});
  drop_unused(made);
  return made;
}

StripShape joined_shapes(std::vector<MovedShape> shapes) {
  struct Place {
    std::size_t shape, first;  // index of the shape, and of its first block or strip
  };
  struct Joined {
    std::vector<MovedShape> shapes;
    std::vector<Place> of_block, of_strip;
    std::vector<std::size_t> first_block;
  };
  const auto all = std::make_shared<Joined>();
  all->shapes = std::move(shapes);
  StripShape joined;
  for (std::size_t s = 0; s < all->shapes.size(); ++s) {
    const StripShape& shape = all->shapes[s].shape;
    all->first_block.push_back(joined.block_sizes.size());
    all->of_block.resize(joined.block_sizes.size() + shape.block_sizes.size(),
                         {s, joined.block_sizes.size()});
    all->of_strip.resize(joined.strips + shape.strips, {s, joined.strips});
    joined.block_sizes.insert(joined.block_sizes.end(), shape.block_sizes.begin(),
                              shape.block_sizes.end());
    joined.strips += shape.strips;
  }
  joined.position = [all](std::size_t block, Index number) -> Vec3 {
    const auto [s, first] = all->of_block[block];
    return all->shapes[s].shape.position(block - first, number) + all->shapes[s].way;
  };
  joined.triangles_of = [all](std::size_t strip) {
    const auto [s, first] = all->of_strip[strip];
    return all->shapes[s].shape.triangles_of(strip - first);
  };
  joined.blocks_of = [all](std::size_t strip) {
    const auto [s, first] = all->of_strip[strip];
    std::vector<std::size_t> blocks = all->shapes[s].shape.blocks_of(strip - first);
    for (std::size_t& block : blocks) block += all->first_block[s];
    return blocks;
  };
  joined.add_strip = [all](std::size_t strip, std::span<const Index> first,
                           std::vector<Triangle>& triangles) {
    const auto [s, first_strip] = all->of_strip[strip];
    all->shapes[s].shape.add_strip(strip - first_strip, first, triangles);
  };
  return joined;
}

}  // namespace brindle
