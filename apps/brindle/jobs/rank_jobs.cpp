#include "jobs/rank_jobs.h"

#include "brindle/base/file_names.h"
#include "outputs/outputs.h"

namespace brindle::tool {

void refuse_pieces(const std::vector<std::string>& outputs) {
  for (const std::string& path : outputs) {
    if (lower_extension(path) != ".pvtp") continue;
    refuse_output(path, "it has a piece per MPI rank; start brindle by mpirun, or write .vtp");
  }
}

}  // namespace brindle::tool
