/// This rank among the others: messages between ranks behind a few functions.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "brindle/distributed_surface.h"
#include "brindle/export.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// A wait of this process for other ranks, as a watchdog reads it.
struct Waiting {
  const char* what;  ///< "for messages of other ranks"
  std::chrono::steady_clock::duration time;
};

/// What the process waits for now, and for how long; nothing if it works. From any thread.
std::optional<Waiting> waiting_now();

/// Bytes that go to a rank, or for which there is room when they come from there.
struct Outgoing {
  int rank;
  std::span<const std::byte> bytes;
};
struct Incoming {
  int rank;
  std::span<std::byte> bytes;
};

/// All functions but `rank`, `size` and those of single messages must be called by all ranks.
/// Sums are over ranks in ascending order, so that they are the same in every run.
class Communicator {
 public:
  /// With messages of its own, which meet none of the caller's.
  explicit Communicator(MPI_Comm comm);
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Every rank's value.
  template <class T>
  std::vector<T> all(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(static_cast<std::size_t>(size_));
    all_gather(&value, values.data(), sizeof(T));
    return values;
  }

  /// The sum of all ranks' values; that of one rank is its value, to the bit.
  template <class T>
  T sum(const T& value) {
    const std::vector<T> values = all(value);
    T total = values[0];
    for (std::size_t r = 1; r < values.size(); ++r) total = total + values[r];
    return total;
  }

  template <class T>
  T greatest(const T& value) {
    T result = value;
    for (const T& other : all(value)) result = other > result ? other : result;
    return result;
  }

  bool any(bool value) { return greatest<std::uint8_t>(value ? 1 : 0) != 0; }

  /// Runs `work`. If it throws on any rank, all ranks throw: Cancelled if the lowest of those was
  /// cancelled, otherwise an Error with its message, which names the rank if there are several.
  void throw_on_all(const std::function<void()>& work);

  /// Runs `work` on rank 0, while the others wait, and throws what `together` throws. What it
  /// reports, all ranks' `progress` hears: each can cancel it.
  void on_first(const Progress& progress, const std::function<void(const Progress&)>& work);

  /// What every rank has for this one: `to` has one list per rank.
  template <class T>
  std::vector<std::vector<T>> swap_lists(const std::vector<std::vector<T>>& to) {
    // Eigen's vectors are numbers alone, though they are not trivial to copy.
    static_assert(std::is_trivially_destructible_v<T>);
    std::vector<std::uint64_t> counts;
    for (const auto& list : to) counts.push_back(list.size());
    std::vector<std::vector<T>> from(to.size());
    const std::vector<std::uint64_t> theirs = swap_counts(counts);
    std::vector<Outgoing> outgoing;
    std::vector<Incoming> incoming;
    for (std::size_t r = 0; r < to.size(); ++r) {
      from[r].resize(theirs[r]);
      outgoing.push_back({static_cast<int>(r), std::as_bytes(std::span(to[r]))});
      incoming.push_back({static_cast<int>(r), std::as_writable_bytes(std::span(from[r]))});
    }
    transfer(outgoing, incoming);
    return from;
  }

  /// Rank 0's list, on all ranks.
  template <class T>
  std::vector<T> of_first(const std::vector<T>& list) {
    std::vector<std::vector<T>> to(static_cast<std::size_t>(size_));
    if (rank_ == 0) std::ranges::fill(to, list);
    return std::move(swap_lists(to)[0]);
  }

  /// Numbers of so many things, if those of all ranks are counted rank by rank.
  std::vector<std::uint64_t> numbers_of(std::size_t count);

  /// All ranks' bytes on rank 0, one list per rank; nothing elsewhere.
  std::vector<std::vector<std::byte>> gather(std::span<const std::byte> bytes);

  /// Sends and receives single messages, and waits for them. Empty ones are not sent.
  void transfer(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming);

  /// The two halves of the same: what is sent and received must stay where it is in between. One
  /// transfer at a time.
  void start(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming);
  void finish();

  /// What this rank has sent so far, and how long it has waited for others.
  const Traffic& traffic() const { return traffic_; }
  Traffic& traffic() { return traffic_; }

 private:
  void all_gather(const void* value, void* values, std::size_t bytes);
  std::vector<std::uint64_t> swap_counts(const std::vector<std::uint64_t>& counts);

  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
  std::vector<MPI_Request> requests_;
  Traffic traffic_;
};

/// What ranks have sent, one behind the other.
template <class T>
std::vector<T> joined(const std::vector<std::vector<std::byte>>& parts) {
  std::vector<T> result;
  for (const std::vector<std::byte>& part : parts) {
    const std::size_t before = result.size();
    result.resize(before + part.size() / sizeof(T));
    std::ranges::copy(part, std::as_writable_bytes(std::span(result).subspan(before)).begin());
  }
  return result;
}

}  // namespace brindle
