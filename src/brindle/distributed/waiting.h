/// What this process waits for at other ranks, told to whoever watches.
#pragma once

#include <chrono>
#include <optional>

namespace brindle {

struct Waiting {
  const char* what;  ///< "for messages of other ranks"
  std::chrono::steady_clock::duration time;
};

/// What the process waits for now and for how long; nothing if it works. From any thread.
std::optional<Waiting> waiting_now();

/// The process waits while this lives. One at a time: MPI is called from one thread.
class WaitMark {
 public:
  explicit WaitMark(const char* what);
  ~WaitMark();
  WaitMark(const WaitMark&) = delete;
  WaitMark& operator=(const WaitMark&) = delete;
};

}  // namespace brindle
