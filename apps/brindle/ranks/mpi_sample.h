/// `brindle sample`.
#pragma once

#include "brindle/communicator.h"
#include "cli/commands.h"

namespace brindle::tool {

/// `ranks` must outlive the command's run, which is collective.
Command add_mpi_sample_command(CLI::App& app, Communicator& ranks);

}  // namespace brindle::tool
