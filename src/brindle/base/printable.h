/// Text of unknown origin in messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace brindle {

/// `text` as a terminal can show it: bytes that are not printable ASCII as \xe9, and three dots
/// instead of what follows the first `most` bytes.
std::string printable(std::string_view text, std::size_t most = 200);

/// A word or line of a file for a message: printable, short, between quotation marks.
std::string in_quotes(std::string_view text);

}  // namespace brindle
