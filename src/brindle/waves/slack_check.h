/// How far no frequency can yield.
#pragma once

#include <cstddef>

#include "brindle/yielding_frequency.h"

namespace brindle {

/// Throws Error for a slack that is negative or not finite and for calm beyond 0 to 1, naming the
/// vertex, and unless lists are empty or have one entry for each of so many vertices.
void check_slack(const Slack& slack, std::size_t vertices);

}  // namespace brindle
