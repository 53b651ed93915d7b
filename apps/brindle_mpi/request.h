/// What ranks are asked for, and what they read, which must be the same everywhere.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/communicator.h"

namespace brindle::tool {

/// The words that one rank was started with.
struct Request {
  std::string key;    ///< what must be the same: options in one order, and the version
  std::string words;  ///< as they were given
};

/// Of words that were understood: `app` has parsed them. Options that concern one rank alone
/// (--threads, --quiet, --stall-limit) may differ.
Request request_of(const CLI::App& app, int argc, char** argv);

/// Of words that were not.
Request request_of(int argc, char** argv);

/// Collective. Throws CLI::ValidationError on all ranks, with which rank has which words, unless
/// all have the same request.
void check_same_request(Communicator& ranks, const Request& own);

/// Collective. Throws CLI::ValidationError on all ranks, naming the file and who sees what, if two
/// ranks see different files of one name. What is not there, or can be read only once as pipes can,
/// does not count.
void check_same_files(Communicator& ranks, const std::vector<std::filesystem::path>& own);

}  // namespace brindle::tool
