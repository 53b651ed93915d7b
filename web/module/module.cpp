#include <emscripten/bind.h>

#include "brindle/version.h"
#include "objects.h"

EMSCRIPTEN_BINDINGS(brindle) {
  brindle::web::bind_surfaces();
  brindle::web::bind_fields();
  brindle::web::bind_patterns();
  brindle::web::bind_animators();
#if !defined(BRINDLE_STRIPES_ALONE)
  brindle::web::bind_meshes();
  brindle::web::bind_lines();
  brindle::web::bind_cameras();
  brindle::web::bind_textures();
#endif
  emscripten::function("version",
                       emscripten::optional_override([] { return std::string(BRINDLE_VERSION); }));
}
