/// Runs commands of the tool from other commands.
#pragma once

#include <string>
#include <vector>

namespace brindle::tool {

/// Runs `words` in this process; the first one is the command: stripe, curves, sample or animate.
/// Throws CLI::ParseError for wrong usage, and whatever the command throws.
void run_words(std::vector<std::string> words);

}  // namespace brindle::tool
