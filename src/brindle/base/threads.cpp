#include "brindle/threads.h"

#ifdef BRINDLE_HAS_TBB

#include <tbb/global_control.h>

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

}  // namespace brindle

#else

namespace brindle {

struct ThreadLimit::Control {};

ThreadLimit::ThreadLimit(int /*threads*/) {}

int ThreadLimit::current() { return 1; }

}  // namespace brindle

#endif

namespace brindle {

ThreadLimit::~ThreadLimit() = default;

}  // namespace brindle
