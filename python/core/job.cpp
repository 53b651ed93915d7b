#include "job.h"

#include <string>
#include <string_view>

namespace brindle::python {
namespace {

// Taking the GIL for every report would make frames wait for other threads.
constexpr std::chrono::milliseconds kBetweenLooks{20};

// Python's False, or numpy's from a comparison.
bool is_false(const py::object& answer) {
  const std::string_view type = Py_TYPE(answer.ptr())->tp_name;
  if (type != "bool" && type != "numpy.bool_" && type != "numpy.bool") return false;
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw py::error_already_set();
  return truth == 0;
}

}  // namespace

Job::Job(py::object callback, int threads)
    : callback_(std::move(callback)),
      threads_(threads),
      last_look_(std::chrono::steady_clock::now()) {
  if (!callback_.is_none() && PyCallable_Check(callback_.ptr()) == 0) {
    throw py::type_error("progress: expected a function of (stage, fraction)");
  }
  if (threads < 0) throw Error("threads: " + std::to_string(threads) + "; give 0 for all, or more");
}

bool Job::go_on(std::string_view stage, double fraction) {
  if (is_leaving()) return false;
  const auto now = std::chrono::steady_clock::now();
  if (callback_.is_none() && now - last_look_ < kBetweenLooks) return true;
  last_look_ = now;
  const BackInPython back;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (callback_.is_none()) return true;
    return !is_false(back.call(callback_, py::make_tuple(stage, fraction)));
  } catch (py::error_already_set& error) {
    pending_.emplace(std::move(error));
    return false;
  }
}

void Job::raise_pending() {
  if (!pending_) return;
  py::error_already_set error = std::move(*pending_);
  pending_.reset();
  throw error;
}

OneAtATime::OneAtATime(std::atomic<bool>& busy, const char* what) : busy_(busy) {
  if (busy.exchange(true)) {
    throw Error(
        std::string(what) +
        " is at work already, in another thread or around this callback; take one for each");
  }
}

}  // namespace brindle::python
