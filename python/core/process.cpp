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

struct Process {
  std::atomic<int> calls{0};         // outside the GIL
  std::atomic<int> in_callbacks{0};  // of these, not at work in C++
  std::atomic<bool> leaving{false};
  std::thread::id leaving_thread;
  bool forked_amid = false;
  std::array<std::atomic<bool>, 2> used{}, used_before{};  // per UnforkableWork; before a fork
};

// Never destroyed: stopped threads outlive static destruction.
Process& here = *new Process;
thread_local int own_calls = 0;

[[noreturn]] void stand_still() {
  for (;;) std::this_thread::sleep_for(1h);
}

// Only the forking thread exists in the child. Locks of other threads stay held.
void after_fork() {
  here.forked_amid = here.forked_amid || here.calls > own_calls;
  here.calls = here.in_callbacks = own_calls;
  for (std::size_t i = 0; i < here.used.size(); ++i) {
    if (here.used[i]) here.used_before[i] = true;
  }
}

// Waits until no thread is at work in C++. Those in callbacks stop when they come back.
void leave() {
  here.leaving_thread = std::this_thread::get_id();
  here.leaving = true;
  const py::gil_scoped_release released;
  while (here.calls > here.in_callbacks) std::this_thread::sleep_for(1ms);
}

constexpr const char* kSpawn =
    "start processes by multiprocessing's 'spawn', as multiprocessing.get_context('spawn') does";

}  // namespace

OutsidePython::OutsidePython() {
  if (here.forked_amid) {
    throw std::runtime_error(
        std::string("this process was forked while another thread was in brindle, which holds what "
                    "calls need; ") +
        kSpawn);
  }
  ++here.calls;
  ++own_calls;
  thread_ = PyEval_SaveThread();
  if (!is_leaving()) return;
  --here.calls;
  stand_still();
}

OutsidePython::~OutsidePython() {
  if (is_leaving()) {
    --here.calls;
    stand_still();
  }
  PyEval_RestoreThread(thread_);
  --own_calls;
  --here.calls;
}

BackInPython::BackInPython() {
  locked_.emplace();  // `leave` waits until this thread has it
  ++here.in_callbacks;
}

BackInPython::~BackInPython() {
  locked_.reset();
  --here.in_callbacks;
  if (!is_leaving()) return;  // or `leave` has seen the decrement
  ++here.in_callbacks;
  stand_still();
}

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

bool is_leaving() { return here.leaving && here.leaving_thread != std::this_thread::get_id(); }

void use_unforkable(UnforkableWork work) {
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
  static const int once = pthread_atfork(nullptr, nullptr, after_fork);
  static_cast<void>(once);
  py::module_::import("atexit").attr("register")(py::cpp_function(leave));
}

}  // namespace brindle::python
