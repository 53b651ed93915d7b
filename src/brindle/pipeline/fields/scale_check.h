/// What the scale of measured data may be.
#pragma once

#include <cmath>
#include <string>

#include "brindle/error.h"

namespace brindle {

/// Throws Error, "<of>: ...", for numbers of periods that cannot be: P, and how far holes are
/// filled.
inline void check_scale(const std::string& of, float periods, float fill) {
  if (!(periods > 0 && periods <= 100)) {
    throw Error(of + ": the detail must be a number of periods above 0, and 100 at most");
  }
  if (!(std::isfinite(fill) && fill >= 0)) {
    throw Error(of + ": holes are filled for a finite number of periods, 0 or above");
  }
}

}  // namespace brindle
