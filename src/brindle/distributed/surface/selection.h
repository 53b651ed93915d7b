/// Ranks of numbers that many processes hold.
#pragma once

#include <cstddef>
#include <span>

#include "brindle/communicator.h"

namespace brindle {

/// The k-th smallest, from 0, of all ranks' numbers, none of which is negative or not a number;
/// infinity if there are not so many.
float kth_smallest(Communicator& ranks, std::span<const float> numbers, std::size_t k);
double kth_smallest(Communicator& ranks, std::span<const double> numbers, std::size_t k);

}  // namespace brindle
