#include "ranks.h"

#include <cstdlib>

#include <brindle/error.h>
#include <vtkMPI.h>
#include <vtkMPICommunicator.h>
#include <vtkMultiProcessController.h>

namespace brindle::paraview {

Ranks Ranks::of_controller() {
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller == nullptr || controller->GetNumberOfProcesses() == 1) return {};
  auto* communicator = vtkMPICommunicator::SafeDownCast(controller->GetCommunicator());
  if (communicator == nullptr) throw Error("ParaView's processes do not talk over MPI");
  return Ranks(*communicator->GetMPIComm()->GetHandle());
}

std::size_t Ranks::rank_of(std::span<const std::uint64_t> numbers) const {
  std::uint64_t hash = 0;
  for (const std::uint64_t number : numbers) {
    for (const std::uint64_t part : {number >> 32, number & 0xffffffffu}) {
      hash = (hash ^ part) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
  }
  return hash % static_cast<std::size_t>(size());
}

void Ranks::abort() const {
  MPI_Abort(comm_, EXIT_FAILURE);
  std::abort();
}

}  // namespace brindle::paraview
