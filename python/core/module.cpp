// The C++ module of the Python package: arrays, objects and jobs. The layer above, python/brindle,
// has names, defaults and documentation.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "brindle/error.h"
#include "brindle/option_table.h"
#include "brindle/phases/parsed_words.h"
#include "brindle/progress.h"
#include "brindle/solver.h"
#include "brindle/version.h"
#include "pattern_data.h"
#include "process.h"
#include "surface_data.h"
#include "words.h"

namespace brindle::python {
namespace {

py::list option_rows() {
  static constexpr const char* kKinds[] = {"flag",    "choice", "whole", "number",
                                           "numbers", "length", "text"};
  py::list rows;
  for (const OptionInfo& row : option_table()) {
    rows.append(py::dict(
        "name"_a = row.name, "words"_a = row.words, "kind"_a = kKinds[static_cast<int>(row.kind)],
        "form"_a = row.form, "unit"_a = row.unit, "standard"_a = row.standard,
        "group"_a = row.group, "part_of"_a = row.part_of, "excludes"_a = row.excludes,
        "range"_a = std::pair(row.range.least, row.range.most),
        "slider"_a = std::pair(row.slider.lowest, row.slider.highest), "help"_a = row.help));
  }
  return rows;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The C++ side of brindle; use the package brindle.";
  // pybind11 tries the last registered first.
  const auto& error = py::register_exception<Error>(module, "Error", PyExc_ValueError);
  py::register_exception<Cancelled>(module, "Cancelled", error);
  module.def("version", version);
  module.def("has_solver", [](const std::string& name) {
    const auto solver = parse_solver(name);
    return solver && is_available(*solver);
  });
  module.def("converted_arrays", converted_arrays,
             "How many arrays were converted to be read where none had to be; for tests.");
  module.def("unmasked", unmasked, py::arg("array"));
  module.def("in_pythons_words", in_pythons_words, py::arg("text"));
  module.def("option_rows", option_rows, "The table of options; names as in the tool.");
  module.def(
      "check_number",
      [](const std::string& option, double value, const std::string& written) {
        saying_in_pythons_words([&] { check_number("--" + option, value, written); });
      },
      py::arg("option"), py::arg("value"), py::arg("written"),
      "Raises Error for a number that the tool's option does not take.");
  module.def(
      "check_choice",
      [](const std::string& option, const std::string& word) {
        saying_in_pythons_words([&] { check_choice("--" + option, word); });
      },
      py::arg("option"), py::arg("word"),
      "Raises Error for none of the words of the tool's option.");
  bind_process(module);
  bind_surfaces(module);
  bind_fields(module);
  bind_solving(module);
  bind_patterns(module);
  bind_textures(module);
  bind_pictures(module);
  bind_curves(module);
  bind_paths(module);
  bind_loops(module);
  bind_animators(module);
  bind_field_animators(module);
  bind_pattern_frames(module);
  bind_files(module);
}

}  // namespace brindle::python
