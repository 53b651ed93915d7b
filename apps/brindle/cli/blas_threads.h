/// Restarts the program without OpenBLAS threads where they would keep it from ending.
///
/// OpenBLAS, a dependency of the global solver, starts a thread per core when it is loaded, for any
/// command. Each requests 128 MB of address space, retries forever if that fails (ulimit -v), and
/// is joined at exit, which then hangs. The global solver uses one thread anyway.
#pragma once

#include <cstdlib>

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace brindle::tool {

/// Call this first in `main`. Does nothing unless the address space is limited and the user has not
/// set OpenBLAS's number of threads.
inline void leave_out_blas_threads([[maybe_unused]] char** arguments) {
#if defined(__linux__)
  constexpr const char* kThreads = "OPENBLAS_NUM_THREADS";
  constexpr const char* kAnew = "BRINDLE_STARTED_ANEW";
  if (std::getenv(kAnew) != nullptr) {
    // Child processes get the user's setting.
    unsetenv(kAnew);
    unsetenv(kThreads);
    return;
  }
  rlimit addresses{};
  if (getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur == RLIM_INFINITY) return;
  if (std::getenv(kThreads) != nullptr) return;
  setenv(kThreads, "1", 1);
  setenv(kAnew, "1", 1);
  execv("/proc/self/exe", arguments);
  // Continues unchanged if there is no such file.
  unsetenv(kAnew);
  unsetenv(kThreads);
#endif
}

}  // namespace brindle::tool
