/// Meshes that many tests use.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "brindle/shapes.h"

namespace brindle {

/// Every built-in shape, built once per test program. Shapes that are polygonised take long, above
/// all with sanitizers, and are coarser than by default.
inline const std::map<std::string, Mesh>& every_shape() {
  static const std::map<std::string, Mesh> shapes = [] {
    const std::map<std::string, std::string> coarser = {
        {"vessels", ",resolution=50"}, {"molecule", ",resolution=25"}, {"box", ",resolution=25"}};
    std::map<std::string, Mesh> all;
    for (const std::string& name : shape_names()) {
      const auto found = coarser.find(name);
      all[name] = make_shape(found == coarser.end() ? name : name + found->second);
    }
    return all;
  }();
  return shapes;
}

/// The mesh with a third of its triangles, spread over it, wound the other way.
inline Mesh with_turned_triangles(Mesh mesh) {
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (t * 2654435761u % 9 < 3) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  }
  return mesh;
}

}  // namespace brindle
