/// Meshes that many tests use.
#pragma once

#include <map>
#include <string>

#include "brindle/surface/shapes.h"

namespace brindle {

/// Every built-in shape with its defaults, built once per test program.
inline const std::map<std::string, Mesh>& default_shapes() {
  static const std::map<std::string, Mesh> shapes = [] {
    std::map<std::string, Mesh> all;
    for (const std::string& name : shape_names()) all[name] = make_shape(name);
    return all;
  }();
  return shapes;
}

}  // namespace brindle
