/// Words of phase shifts, as command lines and scripts have them.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/phase_shift.h"

namespace brindle {

/// Reads "aligned", "common_source" or "trapezoid".
std::optional<PhaseShiftKind> parse_phase_shift_kind(std::string_view name);

}  // namespace brindle
