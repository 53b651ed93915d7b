#include "brindle/version.h"

namespace brindle {

const char* version() { return BRINDLE_VERSION; }

}  // namespace brindle
