#include "ranks.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include <brindle/error.h>
#include <brindle/progress.h>
#include <vtkMPI.h>
#include <vtkMPICommunicator.h>
#include <vtkMultiProcessController.h>

namespace brindle::paraview {
namespace {

enum class Outcome : std::uint8_t { done, cancelled, failed };

struct Failure {
  Outcome outcome = Outcome::done;
  std::string message;
};

Failure outcome_of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const Cancelled& cancelled) {
    return {Outcome::cancelled, cancelled.what()};
  } catch (const std::bad_alloc&) {
    return {Outcome::failed, "there is not enough memory"};
  } catch (const std::exception& error) {
    return {Outcome::failed, error.what()};
  }
}

/// Where every rank's items begin.
std::vector<int> begins_of(const std::vector<int>& counts) {
  std::vector<int> begins(counts.size());
  for (std::size_t r = 1; r < counts.size(); ++r) begins[r] = begins[r - 1] + counts[r - 1];
  return begins;
}

}  // namespace

Ranks::Ranks(MPI_Comm communicator) : communicator_(communicator) {
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &size_);
}

Ranks Ranks::of_controller() {
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (controller == nullptr || controller->GetNumberOfProcesses() == 1) return {};
  auto* communicator = vtkMPICommunicator::SafeDownCast(controller->GetCommunicator());
  if (communicator == nullptr) throw Error("ParaView's processes do not talk over MPI");
  return Ranks(*communicator->GetMPIComm()->GetHandle());
}

void Ranks::together(const std::function<void()>& work) const {
  if (alone()) return work();
  const Failure failure = outcome_of(work);
  const std::vector<Outcome> outcomes = all(failure.outcome);
  const auto first = std::ranges::find_if(outcomes, [](Outcome o) { return o != Outcome::done; });
  if (first == outcomes.end()) return;
  const auto failed = static_cast<int>(first - outcomes.begin());
  std::string message = failure.message;
  std::uint64_t length = message.size();
  MPI_Bcast(&length, 1, MPI_UINT64_T, failed, communicator_);
  message.resize(length);
  MPI_Bcast(message.data(), static_cast<int>(length), MPI_CHAR, failed, communicator_);
  if (*first == Outcome::cancelled) throw Cancelled(message);
  throw Error("rank " + std::to_string(failed) + ": " + message);
}

bool Ranks::any(bool value) const {
  const std::vector<std::uint8_t> values = all<std::uint8_t>(value ? 1 : 0);
  return std::ranges::find(values, 1) != values.end();
}

void Ranks::abort() const {
  MPI_Abort(communicator_, EXIT_FAILURE);
  std::abort();
}

void Ranks::gather(const void* value, void* values, std::size_t bytes) const {
  const int count = static_cast<int>(bytes);
  MPI_Allgather(value, count, MPI_BYTE, values, count, MPI_BYTE, communicator_);
}

void Ranks::check_count(std::size_t items) const {
  if (!any(items > INT_MAX)) return;
  throw Error("a rank has too many points for MPI; use more ranks");
}

std::vector<int> Ranks::swap_counts(const std::vector<int>& counts) const {
  if (alone()) return counts;
  std::vector<int> theirs(counts.size());
  MPI_Alltoall(counts.data(), 1, MPI_INT, theirs.data(), 1, MPI_INT, communicator_);
  return theirs;
}

void Ranks::swap_items(const void* sent, const std::vector<int>& counts, void* received,
                       const std::vector<int>& theirs, std::size_t bytes_each) const {
  if (alone()) {
    std::copy_n(static_cast<const std::byte*>(sent),
                bytes_each * static_cast<std::size_t>(counts[0]),
                static_cast<std::byte*>(received));
    return;
  }
  MPI_Datatype item;
  MPI_Type_contiguous(static_cast<int>(bytes_each), MPI_BYTE, &item);
  MPI_Type_commit(&item);
  const std::vector<int> from = begins_of(counts), to = begins_of(theirs);
  MPI_Alltoallv(sent, counts.data(), from.data(), item, received, theirs.data(), to.data(), item,
                communicator_);
  MPI_Type_free(&item);
}

}  // namespace brindle::paraview
