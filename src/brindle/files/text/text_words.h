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

/// Whether words are the same but for capital letters.
bool same_letters(std::string_view a, std::string_view b);

/// "my%20data.bin" as "my data.bin".
std::string percent_decoded(std::string_view name);

/// Takes the first word off a text that may have several lines; empty if there is none left.
std::string_view take_word_of_lines(std::string_view& text);

/// Takes `count` numbers, with any white space between them, off the text, as this machine stores
/// them: the nearest floating-point number. Calls `fail` with the reason, and expects it to throw,
/// for a word that is no number of the type and for too few of them; asks for no more memory than
/// the text can fill.
std::vector<std::byte> take_numbers(std::string_view& text, NumberType type, std::uint64_t count,
                                    const std::function<void(const std::string&)>& fail);

}  // namespace brindle
