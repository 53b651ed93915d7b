/// Parallel loops with bit-identical results for every number of threads, also without oneTBB.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#ifdef BRINDLE_HAS_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#endif

#include "brindle/base/standard.h"
#include "brindle/progress.h"
#include "brindle/threads.h"

#if defined(__SANITIZE_THREAD__)
#define BRINDLE_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define BRINDLE_THREAD_SANITIZER
#endif
#endif

namespace brindle {

/// Tells ThreadSanitizer the order of tasks that oneTBB guarantees: all before `call` happens
/// before every task, and every task before all after `join`. The distribution's oneTBB is not
/// instrumented: every task would seem to race with its caller, and suppressing that would hide
/// true races. Costs nothing without ThreadSanitizer.
class TaskOrder {
 public:
#ifdef BRINDLE_THREAD_SANITIZER
  static void call() { called_.fetch_add(1, std::memory_order_release); }
  static void begin_task() { called_.load(std::memory_order_acquire); }
  static void end_task() { done_.fetch_add(1, std::memory_order_release); }
  static void join() { done_.load(std::memory_order_acquire); }

 private:
  // Shared by all calls: to find a counter of its own call, a task would have to read what that
  // call wrote.
  inline static std::atomic<unsigned> called_ = 0, done_ = 0;
#else
  static void call() {}
  static void begin_task() {}
  static void end_task() {}
  static void join() {}
#endif
};

/// Ranges shorter than this run on the calling thread: waking another costs more.
inline constexpr std::size_t kParallelGrain = 2048;

/// Calls `body(begin, end)` on disjoint ranges that cover [0, count). The result must not depend on
/// how the range is cut.
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = kParallelGrain) {
#ifdef BRINDLE_HAS_TBB
  if (count > grain) {
    TaskOrder::call();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](const tbb::blocked_range<std::size_t>& r) {
                        TaskOrder::begin_task();
                        body(r.begin(), r.end());
                        TaskOrder::end_task();
                      });
    TaskOrder::join();
    return;
  }
#else
  static_cast<void>(grain);
#endif
  if (count > 0) body(std::size_t{0}, count);
}

/// Iterations between two reports. Few enough to cancel a job of some microseconds per iteration
/// within a tenth of a second; enough that waiting for the last thread costs nothing.
inline constexpr std::size_t kReportSlice = 1 << 14;

/// Calls both, concurrently if a thread is free. Neither may read what the other writes.
template <class First, class Second>
void parallel_both(const First& first, const Second& second) {
#ifdef BRINDLE_HAS_TBB
  TaskOrder::call();
  const auto as_task = [](const auto& body) {
    return [&body] {
      TaskOrder::begin_task();
      body();
      TaskOrder::end_task();
    };
  };
  tbb::parallel_invoke(as_task(first), as_task(second));
  TaskOrder::join();
#else
  first();
  second();
#endif
}

/// As above; `progress` reports the fraction done before every slice of the range. The number of
/// reports depends on `count` alone; they come from the calling thread.
template <class Body>
void parallel_for(std::size_t count, const Progress& progress, const Body& body,
                  std::size_t grain = kParallelGrain, std::size_t slice = kReportSlice) {
  if (!progress.is_heard()) return parallel_for(count, body, grain);
  for (std::size_t first = 0; first < count; first += slice) {
    progress.report(static_cast<double>(first) / static_cast<double>(count));
    parallel_for(
        std::min(slice, count - first),
        [&](std::size_t begin, std::size_t end) { body(first + begin, first + end); }, grain);
  }
}

/// Calls `body(i)` for every i below `count`, in order; reports as above.
template <class Body>
void reported_for(std::size_t count, const Progress& progress, const Body& body,
                  std::size_t slice = kReportSlice) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i % slice == 0) progress.report(static_cast<double>(i) / static_cast<double>(count));
    body(i);
  }
}

/// Resizes a list in steps: touching new memory for the first time takes longer than a caller
/// should wait. `progress` ticks.
template <class Value>
void ticking_resize(std::vector<Value>& list, std::size_t count, const Progress& progress) {
  constexpr std::size_t kBytesPerTick = 1 << 24;
  list.reserve(count);
  while (progress.is_heard() && list.size() < count) {
    progress.tick();
    list.resize(std::min(count, list.size() + kBytesPerTick / sizeof(Value)));
  }
  list.resize(count);
}

/// Sorts as `std::sort` does, comparison by comparison, while `progress` ticks. If that throws, the
/// range is unordered and may have lost entries.
template <class Iterator, class Less>
void ticking_sort(Iterator begin, Iterator end, const Progress& progress, const Less& less) {
  constexpr std::size_t kComparedPerTick = 16 * kReportSlice;
  if (!progress.is_heard()) {
    ranges::sort(begin, end, less);
    return;
  }
  std::size_t compared = 0;
  ranges::sort(begin, end, [&](const auto& a, const auto& b) {
    if (++compared % kComparedPerTick == 0) progress.tick();
    return less(a, b);
  });
}

/// Reports progress of loops with uneven rounds, after every `slice` of `all`.
class Reporter {
 public:
  Reporter(Progress progress, std::size_t all, std::size_t slice = kReportSlice)
      : progress_(std::move(progress)), all_(all), slice_(slice), next_(slice) {}

  /// Adds `more` finished work. Throws Cancelled if the callback asks for it.
  void done(std::size_t more) {
    done_ += more;
    if (done_ < next_) return;
    next_ = done_ + slice_;
    progress_.report(
        all_ > 0 ? std::min(1.0, static_cast<double>(done_) / static_cast<double>(all_)) : 1.0);
  }

 private:
  Progress progress_;
  std::size_t all_, slice_, next_;
  std::size_t done_ = 0;
};

/// The sum of `body(begin, end)` over [begin, end), halved recursively down to `grain`: the order
/// of addition in oneTBB's deterministic reduction.
template <class Value, class Body>
Value halving_sum(std::size_t begin, std::size_t end, const Body& body, std::size_t grain) {
  if (begin == end) return Value{};
  if (end - begin <= grain) return Value{} + body(begin, end);
  const std::size_t middle = begin + (end - begin) / 2;
  const Value first = halving_sum<Value>(begin, middle, body, grain);
  return first + halving_sum<Value>(middle, end, body, grain);
}

#ifdef BRINDLE_HAS_TBB
/// The body of oneTBB's reduction. Its functional form copies the neutral element from the caller
/// before a task has begun, where `TaskOrder` cannot record it.
template <class Value, class Body>
class PartialSum {
 public:
  explicit PartialSum(const Body& body) : body_(body) {}
  PartialSum(const PartialSum& other, tbb::split) : body_(other.body_) {
    // Another thread may continue with the neutral element written here.
    TaskOrder::call();
  }

  void operator()(const tbb::blocked_range<std::size_t>& r) {
    if (r.empty()) return;
    TaskOrder::begin_task();
    value_ = value_ + body_(r.begin(), r.end());
    TaskOrder::end_task();
  }
  void join(const PartialSum& right) {
    TaskOrder::begin_task();
    value_ = value_ + right.value_;
    TaskOrder::end_task();
  }
  const Value& value() const { return value_; }

 private:
  const Body& body_;
  Value value_{};
};
#endif

/// The sum of `body(begin, end)` over ranges that cover [0, count). Ranges and order of addition
/// only depend on `count` and `grain` (`halving_sum`): the sum is the same for any number of
/// threads.
template <class Value, class Body>
Value parallel_sum(std::size_t count, const Body& body, std::size_t grain = kParallelGrain) {
#ifdef BRINDLE_HAS_TBB
  PartialSum<Value, Body> sum(body);
  TaskOrder::call();
  tbb::parallel_deterministic_reduce(tbb::blocked_range<std::size_t>(0, count, grain), sum);
  TaskOrder::join();
  return sum.value();
#else
  return halving_sum<Value>(0, count, body, grain);
#endif
}

/// As above, bit for bit; `progress` reports the fraction done before every slice.
template <class Value, class Body>
Value parallel_sum(std::size_t count, const Progress& progress, const Body& body,
                   std::size_t grain = kParallelGrain, std::size_t slice = kReportSlice) {
  if (!progress.is_heard()) return parallel_sum<Value>(count, body, grain);
  const auto sum_slice = [&](std::size_t begin, std::size_t end) {
    progress.report(static_cast<double>(begin) / static_cast<double>(count));
    return parallel_sum<Value>(
        end - begin,
        [&](std::size_t from, std::size_t to) { return body(begin + from, begin + to); }, grain);
  };
  // Slices are halves of halves: halved further, they add up in the same order as the whole.
  return halving_sum<Value>(0, count, sum_slice, std::max(slice, grain));
}

/// The maximum number of concurrent threads, and the number, from 0, of the calling one. A thread
/// keeps its number during a body of `parallel_for`.
std::size_t thread_capacity();
std::size_t thread_number();

/// Sums for mean and deviation, which `parallel_sum` adds in a fixed order.
struct PowerSums {
  double count = 0, sum = 0, square_sum = 0;

  void add(double x) {
    count += 1;
    sum += x;
    square_sum += x * x;
  }
  PowerSums operator+(const PowerSums& other) const {
    return {count + other.count, sum + other.sum, square_sum + other.square_sum};
  }

  /// NaN without numbers.
  double mean() const { return sum / count; }
  double deviation() const {
    return std::sqrt(std::max(0.0, square_sum / count - mean() * mean()));
  }
};

}  // namespace brindle
