/// Launchers of MPI programs.
#pragma once

#include <optional>

namespace brindle::tool {

/// The number of processes that mpirun, mpiexec or srun has started, by the environment; 0 if there
/// are several and none of it gives their number. Empty without a launcher.
std::optional<int> launched_processes();

}  // namespace brindle::tool
