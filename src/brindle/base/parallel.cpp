#include "brindle/base/parallel.h"

#ifdef BRINDLE_HAS_TBB

#include <algorithm>

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

}  // namespace brindle

#else

namespace brindle {

std::size_t thread_capacity() { return 1; }
std::size_t thread_number() { return 0; }

}  // namespace brindle

#endif
