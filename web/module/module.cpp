#include <emscripten/bind.h>

#include "brindle/version.h"
#include "objects.h"

EMSCRIPTEN_BINDINGS(brindle) {
  brindle::web::bind_surfaces();
  brindle::web::bind_fields();
  brindle::web::bind_patterns();
  brindle::web::bind_animators();
  brindle::web::bind_files();
  emscripten::function("version",
                       emscripten::optional_override([] { return std::string(BRINDLE_VERSION); }));
}
