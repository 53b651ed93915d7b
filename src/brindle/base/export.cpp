#include "brindle/export.h"

#include "brindle/error.h"
#include "brindle/version.h"

namespace brindle {

void refuse_moved_from() {
  throw Error("an object is used that was moved from; assign another one to it first");
}

const char* version() { return BRINDLE_VERSION; }

}  // namespace brindle
