/// What somebody may have meant who mistyped a name.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace brindle {

/// Of `known`, the name that becomes `word` with the fewest letters put in, left out, replaced or
/// swapped with their neighbour: at most one in three of its letters, and at most three. Capitals
/// make no difference; of equally near names the first is taken. Empty if nothing is near.
std::string nearest(std::string_view word, std::span<const std::string> known);

}  // namespace brindle
