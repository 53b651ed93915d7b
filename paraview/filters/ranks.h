/// This process among those that run ParaView together.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <brindle/communicator.h>

namespace brindle::paraview {

/// The library's Communicator, or this process alone, which sends nothing. All members but `rank`,
/// `size` and `alone` must be called by all ranks, in the same order and by the thread that started
/// MPI. Copies share one Communicator.
class Ranks {
 public:
  /// This process alone.
  Ranks() = default;
  explicit Ranks(MPI_Comm comm)
      : comm_(comm), communicator_(std::make_shared<Communicator>(comm)) {}

  /// Those of VTK's global controller.
  static Ranks of_controller();

  int rank() const { return alone() ? 0 : communicator_->rank(); }
  int size() const { return alone() ? 1 : communicator_->size(); }
  bool alone() const { return !communicator_ || communicator_->size() == 1; }
  MPI_Comm communicator() const { return comm_; }

  /// As Communicator::together. Alone: throws whatever `work` throws.
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

  /// What every rank has for this one: `to` has one list per rank.
  template <class T>
  std::vector<std::vector<T>> swap_lists(const std::vector<std::vector<T>>& to) const {
    if (alone()) return to;
    return communicator_->swap_lists(to);
  }

  /// Ends all ranks: for what one of them cannot tell the others.
  [[noreturn]] void abort() const;

 private:
  MPI_Comm comm_ = MPI_COMM_NULL;
  std::shared_ptr<Communicator> communicator_;  ///< none: this process is alone
};

}  // namespace brindle::paraview
