/// The ranks of a parallel ParaView.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <brindle/communicator.h>

namespace brindle::paraview {

/// The library's Communicator, or a single process, which sends nothing. All members but `rank`,
/// `size` and `alone` are collective, in the same order and on the thread that started MPI. Copies
/// share one Communicator.
class Ranks {
 public:
  /// A single process.
  Ranks() = default;
  explicit Ranks(MPI_Comm comm)
      : comm_(comm), communicator_(std::make_shared<Communicator>(comm)) {}

  /// The ranks of VTK's global controller.
  static Ranks of_controller();

  int rank() const { return alone() ? 0 : communicator_->rank(); }
  int size() const { return alone() ? 1 : communicator_->size(); }
  bool alone() const { return !communicator_ || communicator_->size() == 1; }
  MPI_Comm communicator() const { return comm_; }
  /// Not of a single process.
  Communicator& messages() const { return *communicator_; }

  /// As Communicator::together. In a single process, throws what `work` throws.
  void throw_on_all(const std::function<void()>& work) const {
    if (alone()) return work();
    communicator_->throw_on_all(work);
  }

  /// Every rank's value.
  template <class T>
  std::vector<T> all(const T& value) const {
    if (alone()) return {value};
    return communicator_->all(value);
  }
  bool any(bool value) const { return alone() ? value : communicator_->any(value); }
  bool every(bool value) const { return !any(!value); }

  /// The values for this rank from all ranks: `to` has one list per rank.
  template <class T>
  std::vector<std::vector<T>> swap_lists(const std::vector<std::vector<T>>& to) const {
    if (alone()) return to;
    return communicator_->swap_lists(to);
  }

  /// The rank to ask (`answers_to`) about something with these numbers: spread over ranks, also for
  /// those of a lattice.
  std::size_t rank_of(std::span<const std::uint64_t> numbers) const;

  /// Ends all ranks, after an error that one rank cannot share.
  [[noreturn]] void abort() const;

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
  std::shared_ptr<Communicator> communicator_;  ///< null for a single process
};

}  // namespace brindle::paraview
