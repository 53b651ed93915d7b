/// What becomes of calls where the process forks, or Python leaves while a thread is in Brindle.
#pragma once

#include <pybind11/pybind11.h>

namespace brindle::python {

namespace py = pybind11;

/// Work outside of Python's lock. While the interpreter leaves, threads other than its own do not
/// come back: they would be ended in the midst of C++, which aborts the process. They stand still
/// instead until the process is gone, and no new work of theirs begins.
class OutsidePython {
 public:
  /// Gives the lock back. Throws RuntimeError in a process that was forked while a call was at
  /// work.
  OutsidePython();
  ~OutsidePython();
  OutsidePython(const OutsidePython&) = delete;
  OutsidePython& operator=(const OutsidePython&) = delete;

 private:
  PyThreadState* thread_;
};

/// A callback of a call that is at work: Python's lock again, for as long.
class BackInPython {
 public:
  BackInPython() = default;

  /// Calls the function. A thread that Python ends in it stands still instead.
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

/// Whether the interpreter leaves and this thread is to end its work.
bool is_leaving();

/// What works no longer in a process that was forked after its first use: threads that it has
/// started, and waits for, are not there.
enum class UnforkableWork { pictures, global_solver };

/// Throws RuntimeError, naming the remedy, if that is so; otherwise notes its use.
void use_unforkable(UnforkableWork work);

void bind_process(py::module_& module);

}  // namespace brindle::python
