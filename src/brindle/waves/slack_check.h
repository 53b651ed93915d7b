/// Validates `Slack`.
#pragma once

#include <cstddef>

#include "brindle/spacing_tolerance.h"

namespace brindle {

/// Throws Error for a slack that is negative or not finite and for `branch_penalty` outside 0 to 1,
/// naming the vertex; and for a nonempty list without one entry per vertex.
void check_slack(const Slack& slack, std::size_t vertices);

}  // namespace brindle
