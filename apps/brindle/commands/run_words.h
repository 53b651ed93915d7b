/// Commands of the tool that other commands run, as if they had been typed.
#pragma once

#include <string>
#include <vector>

namespace brindle::tool {

/// Runs `words`, the command's name first, in this process: stripe, curves, sample or animate.
/// Throws CLI::ParseError for words that the command does not understand, and what it throws.
void run_words(std::vector<std::string> words);

}  // namespace brindle::tool
