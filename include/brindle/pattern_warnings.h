/// What is probably not meant by a pattern, in the words that every program of brindle has for it.
#pragma once

#include <string>
#include <vector>

#include "brindle/export.h"
#include "brindle/measured_field.h"
#include "brindle/stripe_pattern.h"
#include "brindle/wave_figures.h"

namespace BRINDLE_EXPORT brindle {

/// `surface_warnings`, and `wave_warnings` and `branch_warnings` of the waves that were asked for:
/// a sentence each without a full stop, empty if there is nothing to say. `surface` is the one that
/// the pattern was made for.
std::vector<std::string> pattern_warnings(const Surface& surface, const StripePattern& pattern,
                                          const WarningWords& words = {});

/// The same of more singularities than `FieldDetailOptions::singularities` asks for.
std::vector<std::string> detail_warnings(const FieldDetailFigures& figures,
                                         const WarningWords& words = {});

}  // namespace brindle
