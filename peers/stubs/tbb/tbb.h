// Instant Meshes was written for a TBB that had task_scheduler_init. oneTBB starts its threads by
// itself; how many there are says a tbb::global_control of the driver.
#pragma once

#include_next <tbb/tbb.h>

namespace tbb {

struct task_scheduler_init {
  static constexpr int automatic = -1;
  explicit task_scheduler_init(int /*threads*/ = automatic) {}
};

}  // namespace tbb
