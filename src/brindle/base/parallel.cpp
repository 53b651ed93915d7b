#include "brindle/base/parallel.h"

#ifdef BRINDLE_HAS_TBB

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace brindle {

struct ThreadLimit::Control {
  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads) {
  if (threads <= 0) return;
  const auto most = static_cast<std::size_t>(threads);
  control_.reset(new Control{{tbb::global_control::max_allowed_parallelism, most}});
}

int ThreadLimit::current() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

std::size_t thread_capacity() {
  return static_cast<std::size_t>(
      std::max(tbb::info::default_concurrency(), tbb::this_task_arena::max_concurrency()));
}

std::size_t thread_number() {
  return static_cast<std::size_t>(std::max(0, tbb::this_task_arena::current_thread_index()));
}

}  // namespace brindle

#else

namespace brindle {

struct ThreadLimit::Control {};

ThreadLimit::ThreadLimit(int /*threads*/) {}

int ThreadLimit::current() { return 1; }

std::size_t thread_capacity() { return 1; }
std::size_t thread_number() { return 0; }

}  // namespace brindle

#endif

namespace brindle {

ThreadLimit::~ThreadLimit() = default;

}  // namespace brindle
