/// Work of rank 0 on behalf of all.
#pragma once

#include <functional>

#include "brindle/communicator.h"

namespace brindle::tool {

/// Collective. As `Communicator::together`, but CLI::ValidationError on one rank is thrown on all.
void together_as_used(Communicator& ranks, const std::function<void()>& work);

/// The same for work on rank 0 that the others wait for.
void on_first_rank(Communicator& ranks, const std::function<void()>& work);

}  // namespace brindle::tool
