#include "process.h"

#include <array>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>

#include <cxxabi.h>
#include <pthread.h>

namespace brindle::python {
namespace {

using namespace std::chrono_literals;

// Never destroyed: stopped threads outlive static destruction.
struct Process {
  std::atomic<int> at_work{0};       // calls outside the GIL
  std::atomic<int> in_callbacks{0};  // of these, calls in callbacks
  std::atomic<bool> leaving{false};
  std::thread::id leaving_thread;
  bool forked_amid = false;
  std::array<std::atomic<bool>, 2> used{};         // per UnforkableWork
  std::array<std::atomic<bool>, 2> used_before{};  // in the parent process of a fork
};

Process& process() {
  static auto* the_process = new Process;
  return *the_process;
}

thread_local int own_calls = 0;  // nested calls of this thread

[[noreturn]] void stand_still() {
  for (;;) std::this_thread::sleep_for(1h);
}

// Only the forking thread exists in the child. Locks of other threads stay held.
void after_fork() {
  Process& here = process();
  here.forked_amid = here.forked_amid || here.at_work > own_calls;
  here.at_work = own_calls;
  here.in_callbacks = own_calls;
  for (std::size_t i = 0; i < here.used.size(); ++i) {
    if (here.used[i]) here.used_before[i] = true;
  }
}

// Waits until no thread is in C++. Threads in callbacks that do not return are left behind: nothing
// can wake them any more.
void leave() {
  constexpr auto kForCallbacks = 1s;
  Process& here = process();
  here.leaving_thread = std::this_thread::get_id();
  here.leaving = true;
  const py::gil_scoped_release released;
  auto deadline = std::chrono::steady_clock::now() + kForCallbacks;
  while (here.at_work > own_calls) {
    const bool working = here.at_work > here.in_callbacks + own_calls;
    const auto now = std::chrono::steady_clock::now();
    if (working) deadline = now + kForCallbacks;
    if (now > deadline) return;
    std::this_thread::sleep_for(1ms);
  }
}

constexpr const char* kSpawn =
    "start processes by multiprocessing's 'spawn', as multiprocessing.get_context('spawn') does";

}  // namespace

OutsidePython::OutsidePython() : thread_(nullptr) {
  Process& here = process();
  if (here.forked_amid) {
    throw std::runtime_error(
        std::string("this process was forked while another thread was in brindle, which holds what "
                    "calls need; ") +
        kSpawn);
  }
  ++here.at_work;
  ++own_calls;
  thread_ = PyEval_SaveThread();
  if (!is_leaving()) return;
  --here.at_work;
  stand_still();
}

OutsidePython::~OutsidePython() {
  Process& here = process();
  if (is_leaving()) {
    --here.at_work;
    stand_still();
  }
  PyEval_RestoreThread(thread_);
  --own_calls;
  --here.at_work;
}

BackInPython::Count::Count() { ++process().in_callbacks; }
BackInPython::Count::~Count() { --process().in_callbacks; }

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): the lock must be held.
py::object BackInPython::call(py::handle function, const py::tuple& arguments) const {
  PyObject* answer = nullptr;
  try {
    answer = PyObject_Call(function.ptr(), arguments.ptr(), nullptr);
  } catch (const abi::__forced_unwind&) {
    stand_still();
  }
  if (answer == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(answer);
}

bool is_leaving() {
  const Process& here = process();
  return here.leaving && here.leaving_thread != std::this_thread::get_id();
}

void use_unforkable(UnforkableWork work) {
  Process& here = process();
  const auto which = static_cast<std::size_t>(work);
  if (here.used_before[which]) {
    const bool pictures = work == UnforkableWork::pictures;
    throw std::runtime_error(std::string(pictures ? "pictures are" : "the solver 'global' is") +
                             " not to be had in a process that was forked after " +
                             (pictures ? "the first was drawn" : "its first use") +
                             ": threads that it waits for are not there; " + kSpawn +
                             (pictures ? ", or draw none before" : ", or use it not before"));
  }
  here.used[which] = true;
}

void bind_process(py::module_& /*module*/) {
  static const bool once = [] {
    pthread_atfork(nullptr, nullptr, after_fork);
    return true;
  }();
  static_cast<void>(once);
  py::module_::import("atexit").attr("register")(py::cpp_function(leave));
}

}  // namespace brindle::python
