/// How many threads brindle works with. Results do not depend on it, bit for bit.
///
/// Functions may be called from several threads at the same time, and different objects used there.
/// One object must not be changed by one thread while another uses it; const members of one object
/// may be called from several threads at once. Objects that draw or solve with OpenGL belong to the
/// thread on which their context is current.
#pragma once

#include <memory>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// Limits the number of threads of the whole process while it lives, whichever thread asks, also
/// for other users of oneTBB; of several limits the lowest holds. 0 means no limit. A build without
/// oneTBB works on the calling thread alone.
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
