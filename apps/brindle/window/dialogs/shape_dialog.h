/// Built-in shapes with their parameters.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "brindle/shapes.h"
#include "window/base/live_session.h"

namespace brindle::tool {

/// "shape:torus,minor=0.2": only values other than the defaults.
std::string shape_text(const ShapeInfo& shape, const std::map<std::string, std::string>& values);

/// The parameters of "shape:torus,minor=0.2".
std::map<std::string, std::string> shape_values(const std::string& text);

/// A Dear ImGui window with the parameters of the session's shape.
class ShapeDialog {
 public:
  /// `open` is called with a shape to replace the present one.
  ShapeDialog(LiveSession& live, WindowLog& log, std::function<void(const std::string&)> open);

  const std::vector<ShapeInfo>& shapes() const { return shapes_; }
  void open() { is_open_ = true; }

  /// While it is open.
  void draw();

 private:
  void draw_parameter(const ShapeInfo& shape, const ShapeParameter& parameter);

  LiveSession& live_;
  WindowLog& log_;
  std::function<void(const std::string&)> open_;
  std::vector<ShapeInfo> shapes_;
  bool is_open_ = false;
};

}  // namespace brindle::tool
