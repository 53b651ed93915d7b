/// The number of threads that brindle uses. Results do not depend on it, bit for bit.
///
/// Several threads may call functions at the same time, each with its own objects. No thread may
/// change an object that another one uses; several threads may call const members of one object at
/// once. Objects that draw or solve with OpenGL belong to the thread on which their context is
/// current.
#pragma once

#include <memory>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// Limits the number of threads of the whole process during its lifetime, also for other users of
/// oneTBB; the lowest of several limits applies. 0 means no limit. A build without oneTBB works on
/// the calling thread alone.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

  /// The number of threads now in force.
  static int current();

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace brindle
