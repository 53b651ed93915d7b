// The C++ module of the Python package: arrays, objects and jobs. The layer above, python/brindle,
// has names, defaults and documentation.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/phases/parsed_words.h"
#include "brindle/progress.h"
#include "brindle/solver.h"
#include "brindle/threads.h"
#include "brindle/version.h"
#include "pattern_data.h"
#include "process.h"
#include "surface_data.h"
#include "words.h"

namespace brindle::python {

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ side of brindle; use the package brindle.";
  // pybind11 tries the last registered first.
  const auto& error = py::register_exception<Error>(module, "Error", PyExc_ValueError);
  py::register_exception<Cancelled>(module, "Cancelled", error);
  module.def("version", version);
  module.def("threads", ThreadLimit::current);
  module.def("has_solver", [](const std::string& name) {
    const auto solver = parse_solver(name);
    return solver && is_available(*solver);
  });
  module.def("converted_arrays", converted_arrays,
             "How many arrays were converted to be read where none had to be; for tests.");
  module.def("unmasked", unmasked, py::arg("array"));
  module.def("in_pythons_words", in_pythons_words, py::arg("text"));
  module.def(
      "check_number",
      [](const std::string& name, double value, const std::string& written) {
        saying_in_pythons_words([&] { check_number("--" + name, value, written); });
      },
      py::arg("name"), py::arg("value"), py::arg("written"),
      "Raises Error for a number that the tool's option does not take.");
  module.def(
      "check_choice",
      [](const std::string& name, const std::string& word) {
        saying_in_pythons_words([&] { check_choice("--" + name, word); });
      },
      py::arg("name"), py::arg("word"), "Raises Error for none of the words of the tool's option.");
  bind_process(module);
  bind_surfaces(module);
  bind_fields(module);
  bind_solving(module);
  bind_patterns(module);
  bind_textures(module);
  bind_curves(module);
  bind_loops(module);
  bind_animators(module);
  bind_field_smoothing(module);
  bind_texture_animator(module);
  bind_pattern_frames(module);
  bind_files(module);
  bind_pictures(module);
}

}  // namespace brindle::python
