/// Calls during a fork or the interpreter's exit.
#pragma once

#include <optional>

#include <pybind11/pybind11.h>

namespace brindle::python {

namespace py = pybind11;

/// Releases the GIL for C++ work. The exiting interpreter would terminate threads that take it
/// within C++, which aborts the process: they stop instead until the process ends.
class OutsidePython {
 public:
  /// Throws RuntimeError in a process that was forked during another thread's call.
  OutsidePython();
  ~OutsidePython();
  OutsidePython(const OutsidePython&) = delete;
  OutsidePython& operator=(const OutsidePython&) = delete;

 private:
  PyThreadState* thread_ = nullptr;
};

/// Takes the GIL for a callback within a call.
class BackInPython {
 public:
  BackInPython();
  ~BackInPython();
  BackInPython(const BackInPython&) = delete;
  BackInPython& operator=(const BackInPython&) = delete;

  /// Calls the function. A thread that the exiting interpreter would terminate stops instead.
  py::object call(py::handle function, const py::tuple& arguments) const;

 private:
  std::optional<py::gil_scoped_acquire> locked_;
};

/// Whether the interpreter is exiting and this thread must end its work.
bool is_leaving();

/// Work that waits for threads that a forked process does not have.
enum class UnforkableWork { pictures, global_solver };

/// Throws RuntimeError with the remedy if the parent process used it before the fork.
void use_unforkable(UnforkableWork work);

void bind_process(py::module_& module);

}  // namespace brindle::python
