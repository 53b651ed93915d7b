/// Meshes that many tests use.
#pragma once

#include <map>
#include <string>

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

}  // namespace brindle
