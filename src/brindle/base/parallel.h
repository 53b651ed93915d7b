/// Threads behind two functions. Both give bit-identical results for every number of threads, and
/// without oneTBB.
#pragma once

#include <cstddef>
#include <functional>

#ifdef BRINDLE_HAS_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include "brindle/base/task_order.h"
#endif

#include "brindle/threads.h"

namespace brindle {

/// Ranges shorter than this run on the calling thread: waking another costs more.
inline constexpr std::size_t kParallelGrain = 2048;

/// Calls `body(begin, end)` on disjoint ranges that cover [0, count). The body must not depend on
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

/// The sum of `body(begin, end)` over the halves of [begin, end), halved until no piece is longer
/// than `grain`: the order in which oneTBB's deterministic reduction adds.
template <class Value, class Body>
Value halving_sum(std::size_t begin, std::size_t end, const Body& body, std::size_t grain) {
  if (begin == end) return Value{};
  if (end - begin <= grain) return Value{} + body(begin, end);
  const std::size_t middle = begin + (end - begin) / 2;
  const Value first = halving_sum<Value>(begin, middle, body, grain);
  return first + halving_sum<Value>(middle, end, body, grain);
}

#ifdef BRINDLE_HAS_TBB
/// What oneTBB's reduction asks for. Its reduction of functions would copy the neutral element out
/// of the caller before a task has begun, where `TaskOrder` cannot tell of it.
template <class Value, class Body>
class PartialSum {
 public:
  explicit PartialSum(const Body& body) : body_(body) {}
  PartialSum(const PartialSum& other, tbb::split) : body_(other.body_) {
    // Another thread may go on with the neutral element that this one wrote.
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

/// The sum of `body(begin, end)` over ranges that cover [0, count). Ranges and the order of the
/// additions depend on `count` and `grain` alone (`halving_sum`), so the sum is the same for any
/// number of threads.
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

/// The most threads that can work at the same time, and the number, from 0, of the one that asks.
/// A thread keeps its number during a body of `parallel_for`.
std::size_t thread_capacity();
std::size_t thread_number();

}  // namespace brindle
