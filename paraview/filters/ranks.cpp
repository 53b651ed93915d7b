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

void Ranks::abort() const {
  MPI_Abort(comm_, EXIT_FAILURE);
  std::abort();
}

}  // namespace brindle::paraview
