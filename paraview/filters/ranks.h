/// This process among those that run ParaView together.
#pragma once

#include <climits>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

// C alone, as distributed_surface.h has it.
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

namespace brindle::paraview {

/// A rank of MPI. All members but `rank`, `size` and `alone` must be called by all ranks, in the
/// same order and by the thread that started MPI. A process that is alone sends nothing.
class Ranks {
 public:
  /// This process alone.
  Ranks() = default;
  explicit Ranks(MPI_Comm communicator);

  /// Those of VTK's global controller.
  static Ranks of_controller();

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool alone() const { return size_ == 1; }
  MPI_Comm communicator() const { return communicator_; }

  /// Runs `work`, which must not wait for other ranks. If it throws on any rank, all ranks throw:
  /// Cancelled if the lowest of those was cancelled, otherwise an Error with its message, which
  /// names the rank. Alone: whatever it throws.
  void together(const std::function<void()>& work) const;

  /// Every rank's value.
  template <class T>
  std::vector<T> all(const T& value) const {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(static_cast<std::size_t>(size_), value);
    if (!alone()) gather(&value, values.data(), sizeof(T));
    return values;
  }
  bool any(bool value) const;
  bool every(bool value) const { return !any(!value); }

  /// What every rank has for this one: `to` has one list per rank.
  template <class T>
  std::vector<std::vector<T>> swap_lists(const std::vector<std::vector<T>>& to) const {
    // Eigen's vectors are numbers alone, though they are not trivial to copy.
    static_assert(std::is_trivially_destructible_v<T>);
    std::vector<T> sent;
    std::vector<int> counts;
    for (const auto& list : to) {
      sent.insert(sent.end(), list.begin(), list.end());
      counts.push_back(static_cast<int>(list.size()));
    }
    check_count(sent.size());
    const std::vector<int> theirs = swap_counts(counts);
    std::size_t total = 0;
    for (const int count : theirs) total += static_cast<std::size_t>(count);
    check_count(total);
    std::vector<T> received(total);
    swap_items(sent.data(), counts, received.data(), theirs, sizeof(T));
    std::vector<std::vector<T>> from;
    auto next = received.begin();
    for (const int count : theirs) {
      from.emplace_back(next, next + count);
      next += count;
    }
    return from;
  }

  /// Ends all ranks: for what one of them cannot tell the others.
  [[noreturn]] void abort() const;

 private:
  void gather(const void* value, void* values, std::size_t bytes) const;
  /// MPI counts in ints.
  void check_count(std::size_t items) const;
  std::vector<int> swap_counts(const std::vector<int>& counts) const;
  void swap_items(const void* sent, const std::vector<int>& counts, void* received,
                  const std::vector<int>& theirs, std::size_t bytes_each) const;

  MPI_Comm communicator_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
};

}  // namespace brindle::paraview
