/// The one exception type that brindle throws for failures that a user can fix.
#pragma once

#include <stdexcept>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// A failed job. The message names the cause (file and line where there is one) and, where one is
/// known, the remedy.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brindle
