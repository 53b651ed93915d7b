/// What rank 0 alone does for all.
#pragma once

#include <functional>

#include "brindle/communicator.h"

namespace brindle::tool {

/// Collective. As `Communicator::together`, with wrong usage staying wrong usage: then all ranks
/// throw CLI::ValidationError.
void together_as_used(Communicator& ranks, const std::function<void()>& work);

/// The same of what rank 0 does and the others wait for.
void on_first_rank(Communicator& ranks, const std::function<void()>& work);

}  // namespace brindle::tool
