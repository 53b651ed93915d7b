#include "brindle/base/parallel.h"

#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

namespace brindle {

std::size_t thread_capacity() {
  return static_cast<std::size_t>(
      std::max(tbb::info::default_concurrency(), tbb::this_task_arena::max_concurrency()));
}

std::size_t thread_number() {
  return static_cast<std::size_t>(std::max(0, tbb::this_task_arena::current_thread_index()));
}

ThreadLimit::ThreadLimit(int threads)
    : control_(threads > 0 ? std::make_unique<tbb::global_control>(
                                 tbb::global_control::max_allowed_parallelism, threads)
                           : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

int ThreadLimit::current() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace brindle
