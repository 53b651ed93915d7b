/// Named values per vertex that a mesh file carries.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/base/types.h"

namespace brindle {

/// `components` numbers per vertex, 1 or 3, vertex by vertex. The names "normal" (unit vectors) and
/// "color" (red, green, blue between 0 and 1), with 3 components, and "uv" (texture coordinates in
/// sides of the picture, from its lower left corner to the right and up), with 2, are stored the
/// way that every program understands; other names consist of letters, digits and underscores.
struct VertexAttribute {
  std::string name;
  int components = 1;
  std::vector<float> values;

  bool is_normal() const { return name == "normal" && components == 3; }
  bool is_color() const { return name == "color" && components == 3; }
  bool is_uv() const { return name == "uv" && components == 2; }
};

/// Gives every vertex v with an entry in `partner` the values of the vertex partner[v]; others keep
/// theirs. For vertices that were joined with another at their place, and so have none of their
/// own.
inline void copy_from_partners(std::span<VertexAttribute> attributes,
                               std::span<const Index> partner) {
  for (VertexAttribute& attribute : attributes) {
    const auto n = static_cast<std::size_t>(attribute.components);
    for (std::size_t v = 0; v < partner.size(); ++v) {
      std::copy_n(&attribute.values[n * partner[v]], partner[v] == v ? 0 : n,
                  &attribute.values[n * v]);
    }
  }
}

/// A colour's level as files store it: 0 to 1 becomes 0 to 255; what is no number becomes 0.
inline unsigned char color_byte(float level) {
  return static_cast<unsigned char>(std::lround(255 * (level > 0 ? std::min(level, 1.0f) : 0.0f)));
}

}  // namespace brindle
