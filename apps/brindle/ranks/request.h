/// Checks that all ranks have the same command line and input files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/communicator.h"

namespace brindle::tool {

/// The command line of a rank.
struct Request {
  std::string key;    ///< must be the same: options in a fixed order, and the version
  std::string words;  ///< as given
};

/// For a valid command line, parsed by `app`. Options of one rank alone (--threads, --quiet,
/// --stall-limit) may differ.
Request request_of(const CLI::App& app, int argc, char** argv);

/// For an invalid command line.
Request request_of(int argc, char** argv);

/// Collective. Throws CLI::ValidationError on all ranks, with the ranks and their words, unless all
/// have the same request.
void check_same_request(Communicator& ranks, const Request& own);

/// Collective. Throws CLI::ValidationError on all ranks, with the file and the ranks, if two ranks
/// see different files of one name. Ignores missing files and pipes.
void check_same_files(Communicator& ranks, const std::vector<std::filesystem::path>& own);

}  // namespace brindle::tool
