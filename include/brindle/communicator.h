/// Messages between MPI ranks behind a few functions.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
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

/// The current wait of this process for other ranks, for a watchdog.
struct Waiting {
  const char* what;  ///< "for messages of other ranks"
  std::chrono::steady_clock::duration time;
};

/// The current wait and its duration; empty while the process works. May be called by any thread.
std::optional<Waiting> waiting_now();

/// Bytes to send to a rank.
struct Outgoing {
  int rank;
  std::span<const std::byte> bytes;
};
/// Memory for bytes that a rank sends.
struct Incoming {
  int rank;
  std::span<std::byte> bytes;
};

/// All ranks must call every function except `rank`, `size`, `traffic` and those of single
/// messages. Sums add ranks in ascending order, so every run gives the same bits.
class Communicator {
 public:
  /// Duplicates `comm`, so that its messages never meet the caller's.
  explicit Communicator(MPI_Comm comm);
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Every rank's value, on all ranks.
  template <class T>
  std::vector<T> all(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> values(static_cast<std::size_t>(size_));
    all_gather(&value, values.data(), sizeof(T));
    return values;
  }

  /// The sum of all ranks' values; with one rank its value, bit for bit.
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

  /// Runs `work`. If it throws on any rank, all ranks throw for the lowest of those: Cancelled if
  /// that was cancelled, otherwise an Error with its message and, with several ranks, its number.
  void throw_on_all(const std::function<void()>& work);

  /// Runs `work` on rank 0 while the others wait, and throws as `throw_on_all` does. All ranks'
  /// `progress` receives its reports, and each can cancel it.
  void on_first(const Progress& progress, const std::function<void(const Progress&)>& work);

  /// Exchanges lists: `to` has one list for each rank, the result one from each rank.
  template <class T>
  std::vector<std::vector<T>> swap_lists(const std::vector<std::vector<T>>& to) {
    // Eigen's vectors contain only numbers, but are not trivially copyable.
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

  /// Numbers for `count` objects of this rank, counted rank by rank over all ranks.
  std::vector<std::uint64_t> numbers_of(std::size_t count);

  /// All ranks' bytes on rank 0, one list per rank; empty elsewhere.
  std::vector<std::vector<std::byte>> gather(std::span<const std::byte> bytes);

  /// Sends and receives single messages, and waits for them. Empty messages are not sent.
  void transfer(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming);

  /// The two halves of `transfer`. Sent and received memory must stay valid in between. One
  /// transfer at a time.
  void start(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming);
  void finish();

  /// Bytes sent by this rank so far, and its time waiting for others.
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

/// Collective. Sends every row to the rank `rank_of(row)`. There, `answer` maps the lists of all
/// ranks to lists of answers, which are returned in the order of the rows. `ranks` has the `size`
/// and `swap_lists` of a Communicator.
template <class Ranks, class Row, class RankOf, class Answer>
auto answers_to(Ranks& ranks, const std::vector<Row>& rows, const RankOf& rank_of,
                const Answer& answer) {
  std::vector<std::vector<Row>> asked(static_cast<std::size_t>(ranks.size()));
  for (const Row& row : rows) asked[rank_of(row)].push_back(row);
  const auto answers = ranks.swap_lists(answer(ranks.swap_lists(asked)));
  std::vector<std::size_t> next(asked.size());
  auto result = answers[0];
  result.clear();
  for (const Row& row : rows) {
    const std::size_t rank = rank_of(row);
    result.push_back(answers[rank][next[rank]++]);
  }
  return result;
}

}  // namespace brindle
