/// Starts a program anew without threads that its libraries start before `main`, where these would
/// keep it from ending.
///
/// OpenBLAS, which the global solver stands on, starts a thread for every core as soon as it is
/// loaded, whatever the command is. Each asks for 128 MB of addresses, again and again if there are
/// none (ulimit -v), and is waited for at the end, which then never comes. The global solver works
/// on one thread in any case.
#pragma once

#include <cstdlib>

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace brindle::tool {

/// To be called first in `main`. Does nothing unless addresses are limited and nobody has said how
/// many threads OpenBLAS may start.
inline void leave_out_blas_threads([[maybe_unused]] char** arguments) {
#if defined(__linux__)
  constexpr const char* kThreads = "OPENBLAS_NUM_THREADS";
  constexpr const char* kAnew = "BRINDLE_STARTED_ANEW";
  if (std::getenv(kAnew) != nullptr) {
    // Programs that this one starts have what the user says.
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
  // It goes on as it was started where there is no such file.
  unsetenv(kAnew);
  unsetenv(kThreads);
#endif
}

}  // namespace brindle::tool
