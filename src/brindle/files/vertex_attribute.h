/// Named values per vertex that a mesh file carries.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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

/// A colour's level as files store it: 0 to 1 becomes 0 to 255; what is no number becomes 0.
inline unsigned char color_byte(float level) {
  return static_cast<unsigned char>(std::lround(255 * (level > 0 ? std::min(level, 1.0f) : 0.0f)));
}

}  // namespace brindle
