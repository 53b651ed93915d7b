/// Why there are no curves, in the same words for the tool and for Python.
#pragma once

#include <cstddef>
#include <string>

namespace brindle {

/// A line; `short_curves` were left out.
inline std::string why_no_curves(const std::string& family, std::size_t short_curves) {
  if (short_curves == 0) {
    return family + ": no curves: no stripe's centre runs over the surface; ask for more stripes\n";
  }
  return family + ": no curves left: all " + std::to_string(short_curves) +
         " are shorter than --min-length\n";
}

}  // namespace brindle
