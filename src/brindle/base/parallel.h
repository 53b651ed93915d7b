/// Threads behind two functions. Both give bit-identical results for every number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "brindle/base/task_order.h"

namespace tbb::detail::d1 {
class global_control;
}

namespace brindle {

/// Ranges shorter than this run on the calling thread: waking another costs more.
inline constexpr std::size_t kParallelGrain = 2048;

/// Calls `body(begin, end)` on disjoint ranges that cover [0, count). The body must not depend on
/// how the range is cut.
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = kParallelGrain) {
  if (count <= grain) {
    if (count > 0) body(std::size_t{0}, count);
    return;
  }
  TaskOrder::call();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                    [&](const tbb::blocked_range<std::size_t>& r) {
                      TaskOrder::begin_task();
                      body(r.begin(), r.end());
                      TaskOrder::end_task();
                    });
  TaskOrder::join();
}

/// The sum of `body(begin, end)` over ranges that cover [0, count). Ranges and the order of the
/// additions depend on `count` and `grain` alone, so the sum is the same for any thread count.
template <class Value, class Body>
Value parallel_sum(std::size_t count, const Body& body, std::size_t grain = kParallelGrain) {
  TaskOrder::call();
  const Value total = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, count, grain), Value{},
      [&](const tbb::blocked_range<std::size_t>& r, Value sum) {
        if (r.empty()) return sum;
        TaskOrder::begin_task();
        sum = sum + body(r.begin(), r.end());
        TaskOrder::end_task();
        return sum;
      },
      std::plus<Value>());
  TaskOrder::join();
  return total;
}

/// The most threads that can work at the same time, and the number, from 0, of the one that asks.
/// A thread keeps its number during a body of `parallel_for`.
std::size_t thread_capacity();
std::size_t thread_number();

/// Limits the number of threads while it lives; 0 means all that the machine has.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

  /// The number of threads now in force.
  static int current();

 private:
  std::unique_ptr<tbb::detail::d1::global_control> control_;
};

}  // namespace brindle
