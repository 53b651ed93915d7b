/// Numbers of a known type in text, with any white space between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

/// Takes the first word off a text that may have several lines; empty if there is none left.
std::string_view take_word_of_lines(std::string_view& text);

/// Takes `count` numbers off the text, as this machine stores them: of floating-point ones the
/// nearest. Calls `fail` with what is wrong, and expects it to throw, for a word that is no number
/// of the type and for too few of them; no more memory is asked for than the text can fill.
std::vector<std::byte> take_numbers(std::string_view& text, NumberType type, std::uint64_t count,
                                    const std::function<void(const std::string&)>& fail);

}  // namespace brindle
