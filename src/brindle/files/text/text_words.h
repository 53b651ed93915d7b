/// Words and numbers of text files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/data_arrays.h"

namespace brindle {

std::string small_letters(std::string_view text);

/// Whether words are equal, ignoring case.
bool same_letters(std::string_view a, std::string_view b);

/// Decodes "my%20data.bin" to "my data.bin".
std::string percent_decoded(std::string_view name);

/// Takes the first word off a multi-line text; empty if none is left.
std::string_view take_word_of_lines(std::string_view& text);

/// Takes `count` numbers, separated by white space, off the text, in this machine's representation;
/// floating-point numbers are rounded to nearest. Calls `fail`, which must throw, with the reason
/// if a word is no number of the type or words are missing. Allocates no more memory than the text
/// can fill.
std::vector<std::byte> take_numbers(std::string_view& text, NumberType type, std::uint64_t count,
                                    const std::function<void(const std::string&)>& fail);

}  // namespace brindle
