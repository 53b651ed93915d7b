/// Long calls: without the GIL, with progress, cancelled by Ctrl-C.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>
#include <utility>

#include <pybind11/pybind11.h>

#include "brindle/progress.h"
#include "brindle/threads.h"
#include "process.h"

namespace brindle::python {

namespace py = pybind11;

/// A long call. Other Python threads run meanwhile. `run` rethrows Ctrl-C and exceptions of
/// `callback`, and then leaves its objects unchanged.
class Job {
 public:
  /// `callback(stage, fraction)` may be None; returning False cancels. `threads`: 0 for all.
  explicit Job(py::object callback = py::none(), int threads = 0);

  /// Calls `work(progress)` without the GIL. Throws what it throws, or what Python raised.
  template <class Work>
  auto run(const Work& work) {
    try {
      const OutsidePython outside;
      const ThreadLimit limit(threads_);
      return work(Progress(
          [this](std::string_view stage, double fraction) { return go_on(stage, fraction); }));
    } catch (const Cancelled&) {
      raise_pending();
      throw;
    }
  }

 private:
  bool go_on(std::string_view stage, double fraction);
  void raise_pending();

  py::object callback_;
  int threads_;
  std::chrono::steady_clock::time_point last_look_;
  std::optional<py::error_already_set> pending_;
};

/// As `Job::run` without a callback: until Ctrl-C.
template <class Work>
auto until_interrupted(const Work& work) {
  return Job().run(work);
}

/// As `Job::run` for work without progress.
template <class Work>
auto without_lock(const Work& work) {
  const OutsidePython outside;
  return work();
}

/// Guards an object against concurrent calls. Throws Error for a second call, from another thread
/// or from a callback of the first.
class OneAtATime {
 public:
  OneAtATime(std::atomic<bool>& busy, const char* what);
  ~OneAtATime() { busy_ = false; }
  OneAtATime(const OneAtATime&) = delete;
  OneAtATime& operator=(const OneAtATime&) = delete;

 private:
  std::atomic<bool>& busy_;
};

}  // namespace brindle::python
