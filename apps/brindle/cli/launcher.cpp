#include "cli/launcher.h"

#include <cstdlib>

namespace brindle::tool {

std::optional<int> launched_processes() {
  // Open MPI; MPICH, Intel MPI and Slurm's PMI; MVAPICH.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"}) {
    if (const char* count = std::getenv(name)) return std::atoi(count);
  }
  // Others that use PMIx give each process its rank alone.
  if (std::getenv("PMIX_RANK") != nullptr) return 0;
  return std::nullopt;
}

}  // namespace brindle::tool
