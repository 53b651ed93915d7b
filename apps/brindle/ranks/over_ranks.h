/// The tool as one of the processes that a launcher of MPI programs has started.
#pragma once

#include <functional>

namespace brindle::tool {

/// Runs the command line over all ranks and returns the exit code. Rank 0 alone prints help and
/// errors. A single rank runs commands that have no ranks by `alone`.
int run_over_ranks(int argc, char** argv, const std::function<int(int, char**)>& alone);

}  // namespace brindle::tool
