/// Names in which some letters stand as %20.
#pragma once

#include <string>
#include <string_view>

namespace brindle {

/// "my%20data.bin" as "my data.bin".
std::string percent_decoded(std::string_view name);

}  // namespace brindle
