// Replaces pictures in builds without OpenGL.
#include "brindle/error.h"
#include "pictures.h"

namespace brindle::python {

void bind_renderer(py::module_& module) {
  module.attr("has_opengl") = false;
  for (const char* name : {"render", "render_texture", "triangles_with_broken_tiles",
                           "render_ornaments", "write_png", "read_png", "tile_png"}) {
    module.def(name, [](const py::args&, const py::kwargs&) {
      throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
    });
  }
}

}  // namespace brindle::python
