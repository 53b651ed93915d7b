/// Errors, command lines and input files that all ranks share.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "brindle/communicator.h"

namespace brindle::tool {

/// Collective. As `Communicator::throw_on_all`, but CLI::ValidationError on one rank is thrown on
/// all.
void throw_usage_on_all(Communicator& ranks, const std::function<void()>& work);

/// The same for work on rank 0 that the others wait for.
void on_first_rank(Communicator& ranks, const std::function<void()>& work);

/// Collective. Throws CLI::ValidationError on all ranks, with two ranks and their words, unless all
/// have the same command line and version, but for --threads, --stall-limit and --quiet.
void check_same_words(Communicator& ranks, const std::vector<std::string>& words);

/// Collective. Throws CLI::ValidationError on all ranks, with the file and two ranks, if these see
/// different files of one name. Ignores missing files and pipes.
void check_same_files(Communicator& ranks, const std::vector<std::filesystem::path>& own);

}  // namespace brindle::tool
