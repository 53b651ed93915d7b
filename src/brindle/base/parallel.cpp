#include "brindle/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

namespace brindle {

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
