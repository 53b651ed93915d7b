/// Names of phase shifts on command lines and in scripts.
#pragma once

#include <optional>
#include <string_view>

#include "brindle/phase_shift.h"

namespace brindle {

/// "aligned", "common_source" or "trapezoid"; empty for other names.
std::optional<PhaseShiftKind> parse_phase_shift_kind(std::string_view name);

}  // namespace brindle
