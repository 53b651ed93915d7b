#include "brindle/communicator.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <new>
#include <numeric>
#include <optional>
#include <string>

#include "brindle/base/stopwatch.h"
#include "brindle/error.h"

namespace brindle {
namespace {

constexpr int kTag = 1;

using Clock = std::chrono::steady_clock;

// A reader between the two stores sees a wait that has just begun or ended, which is harmless.
std::atomic<const char*> waited_for{nullptr};
std::atomic<Clock::rep> waiting_since{0};

/// Marks the process as waiting. One at a time: MPI is called from one thread.
class WaitMark {
 public:
  explicit WaitMark(const char* what) {
    waiting_since.store(Clock::now().time_since_epoch().count(), std::memory_order_relaxed);
    waited_for.store(what, std::memory_order_release);
  }
  ~WaitMark() { waited_for.store(nullptr, std::memory_order_release); }
  WaitMark(const WaitMark&) = delete;
  WaitMark& operator=(const WaitMark&) = delete;
};

constexpr const char* kForAll = "for all other ranks";
constexpr const char* kForMessages = "for messages of other ranks";

/// MPI counts in ints.
constexpr std::size_t kLongestMessage = std::size_t{1} << 30;

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
    return {Outcome::failed, "not enough memory"};
  } catch (const std::exception& error) {
    return {Outcome::failed, error.what()};
  }
}

/// A serializable ProgressReport.
struct SentReport {
  bool is_last = true;  ///< the work has ended, without a report
  double fraction = 0, step_fraction = 0;
  std::array<char, 48> step = {};

  ProgressReport report() const { return {fraction, step.data(), step_fraction, {}, 0}; }
};

SentReport sent(const ProgressReport& report) {
  SentReport result{false, report.fraction, report.step_fraction, {}};
  report.step.copy(result.step.data(), result.step.size() - 1);
  return result;
}

/// Calls `visit(first, count)` for the messages that carry these bytes.
template <class Visit>
void for_each_message(std::size_t bytes, const Visit& visit) {
  for (std::size_t first = 0; first < bytes; first += kLongestMessage) {
    visit(first, static_cast<int>(std::min(kLongestMessage, bytes - first)));
  }
}

}  // namespace

std::optional<Waiting> waiting_now() {
  const char* what = waited_for.load(std::memory_order_acquire);
  if (what == nullptr) return std::nullopt;
  const Clock::duration since(waiting_since.load(std::memory_order_relaxed));
  return Waiting{what, Clock::now().time_since_epoch() - since};
}

Communicator::Communicator(MPI_Comm comm) {
  const WaitMark mark(kForAll);
  MPI_Comm_dup(comm, &comm_);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

Communicator::~Communicator() {
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (finalized == 0) MPI_Comm_free(&comm_);
}

void Communicator::all_gather(const void* value, void* values, std::size_t bytes) {
  if (size_ == 1) {
    std::memcpy(values, value, bytes);
    return;
  }
  const WaitMark mark(kForAll);
  Stopwatch watch;
  const int count = static_cast<int>(bytes);
  MPI_Allgather(value, count, MPI_BYTE, values, count, MPI_BYTE, comm_);
  traffic_.waiting_milliseconds += watch.lap();
}

std::vector<std::uint64_t> Communicator::swap_counts(const std::vector<std::uint64_t>& counts) {
  std::vector<std::uint64_t> theirs(counts.size());
  const WaitMark mark(kForAll);
  MPI_Alltoall(counts.data(), 1, MPI_UINT64_T, theirs.data(), 1, MPI_UINT64_T, comm_);
  return theirs;
}

void Communicator::throw_on_all(const std::function<void()>& work) {
  if (size_ == 1) return work();
  const Failure failure = outcome_of(work);
  const std::vector<Outcome> outcomes = all(failure.outcome);
  const auto first = std::ranges::find_if(outcomes, [](Outcome o) { return o != Outcome::done; });
  if (first == outcomes.end()) return;
  const auto failed = static_cast<int>(first - outcomes.begin());
  std::string message = failure.message;
  std::uint64_t length = message.size();
  const WaitMark mark(kForAll);
  MPI_Bcast(&length, 1, MPI_UINT64_T, failed, comm_);
  message.resize(length);
  MPI_Bcast(message.data(), static_cast<int>(length), MPI_CHAR, failed, comm_);
  if (*first == Outcome::cancelled) throw Cancelled(message);
  throw Error("rank " + std::to_string(failed) + ": " + message);
}

void Communicator::on_first(const Progress& progress,
                            const std::function<void(const Progress&)>& work) {
  if (size_ == 1) return work(progress);
  const bool is_heard = any(progress.is_heard());
  const auto hear = [&](const SentReport& report) {
    throw_on_all([&] { progress.report(report.report()); });
  };
  if (rank_ > 0) {
    for (SentReport report; !(report = all(SentReport())[0]).is_last;) hear(report);
    return throw_on_all([] {});
  }
  bool all_have_thrown = false;
  const Progress told(Progress::JobCallback([&](const ProgressReport& report) {
    all_have_thrown = true;
    hear(all(sent(report))[0]);
    all_have_thrown = false;
    return true;
  }));
  std::exception_ptr failure;
  try {
    work(is_heard ? told : Progress());
  } catch (...) {
    if (all_have_thrown) throw;
    failure = std::current_exception();
  }
  all(SentReport());
  throw_on_all([&] {
    if (failure) std::rethrow_exception(failure);
  });
}

std::vector<std::uint64_t> Communicator::numbers_of(std::size_t count) {
  const std::vector<std::size_t> counts = all(count);
  std::vector<std::uint64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(),
            std::accumulate(counts.begin(), counts.begin() + rank_, std::uint64_t{0}));
  return numbers;
}

std::vector<std::vector<std::byte>> Communicator::gather(std::span<const std::byte> bytes) {
  const std::vector<std::uint64_t> sizes = all<std::uint64_t>(bytes.size());
  std::vector<std::vector<std::byte>> lists;
  std::vector<Incoming> incoming;
  if (rank_ == 0) {
    for (const std::uint64_t size : sizes) lists.emplace_back(size);
    for (int r = 0; r < size_; ++r) incoming.push_back({r, lists[static_cast<std::size_t>(r)]});
  }
  const Outgoing outgoing{0, bytes};
  transfer({&outgoing, 1}, incoming);
  return lists;
}

void Communicator::transfer(std::span<const Outgoing> outgoing,
                            std::span<const Incoming> incoming) {
  start(outgoing, incoming);
  finish();
}

void Communicator::start(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming) {
  for (const Incoming& in : incoming) {
    if (in.rank == rank_) continue;
    for_each_message(in.bytes.size(), [&](std::size_t first, int count) {
      MPI_Irecv(in.bytes.data() + first, count, MPI_BYTE, in.rank, kTag, comm_,
                &requests_.emplace_back());
    });
  }
  for (const Outgoing& out : outgoing) {
    if (out.rank == rank_) {
      const auto own = std::ranges::find(incoming, rank_, &Incoming::rank);
      std::ranges::copy(out.bytes, own->bytes.begin());
      continue;
    }
    for_each_message(out.bytes.size(), [&](std::size_t first, int count) {
      MPI_Isend(out.bytes.data() + first, count, MPI_BYTE, out.rank, kTag, comm_,
                &requests_.emplace_back());
      ++traffic_.messages;
    });
    traffic_.bytes += out.bytes.size();
  }
}

void Communicator::finish() {
  if (requests_.empty()) return;
  const WaitMark mark(kForMessages);
  Stopwatch watch;
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  requests_.clear();
  traffic_.waiting_milliseconds += watch.lap();
}

}  // namespace brindle
