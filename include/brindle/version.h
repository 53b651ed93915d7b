/// The version of brindle. The build reads the number from here.
#pragma once

#define BRINDLE_VERSION_MAJOR 0
#define BRINDLE_VERSION_MINOR 3
#define BRINDLE_VERSION_PATCH 0
#define BRINDLE_VERSION "1.0.0"

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// The version of the library at run time; BRINDLE_VERSION is that of the headers at compile time.
const char* version();

}  // namespace brindle
