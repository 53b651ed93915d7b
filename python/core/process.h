/// Calls during a fork or the interpreter's exit.
#pragma once

#include <pybind11/pybind11.h>

namespace brindle::python {

namespace py = pybind11;

/// Releases the GIL for C++ work. During interpreter exit, threads that take the GIL would be
/// terminated within C++, which aborts the process. Here they stop instead until the process ends,
/// and start no new work.
class OutsidePython {
 public:
  /// The destructor takes the GIL back. The constructor throws RuntimeError in a process forked
  /// during a call.
  OutsidePython();
  ~OutsidePython();
  OutsidePython(const OutsidePython&) = delete;
  OutsidePython& operator=(const OutsidePython&) = delete;

 private:
  PyThreadState* thread_;
};

/// Takes the GIL for a callback within a call.
class BackInPython {
 public:
  BackInPython() = default;

  /// Calls the function. A thread that the exiting interpreter would terminate stops instead.
  py::object call(py::handle function, const py::tuple& arguments) const;

 private:
  struct Count {
    Count();
    ~Count();
    Count(const Count&) = delete;
    Count& operator=(const Count&) = delete;
  };
  Count count_;
  py::gil_scoped_acquire locked_;
};

/// Whether the interpreter is exiting and this thread must end its work.
bool is_leaving();

/// Features that cannot be used in a child process after their use in the parent: their threads do
/// not exist there.
enum class UnforkableWork { pictures, global_solver };

/// Throws RuntimeError with the remedy in such a child; otherwise records the use.
void use_unforkable(UnforkableWork work);

void bind_process(py::module_& module);

}  // namespace brindle::python
