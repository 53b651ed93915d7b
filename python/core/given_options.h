/// Options that Python gives by the names of arguments.
#pragma once

#include <algorithm>
#include <concepts>
#include <map>
#include <string>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "brindle/recipe/refusals.h"
#include "brindle/stripe_pattern.h"

namespace brindle::python {

namespace py = pybind11;

/// Options by the names of arguments, which were checked in Python: sets fields to those given.
class GivenOptions {
 public:
  explicit GivenOptions(const py::dict& given) {
    for (const auto& [name, value] : given) {
      std::string option = "--" + py::cast<std::string>(name);
      std::ranges::replace(option, '_', '-');
      values_[option] = py::reinterpret_borrow<py::object>(value);
    }
  }

  void add(const std::string& option) { values_[option] = py::none(); }
  brindle::IsGiven is_given() const {
    return [this](const std::string& option) { return values_.contains(option); };
  }

  template <class Field, class... Parse>
  void operator()(const std::string& option, Field& field, const Parse&... parse) const {
    const auto found = values_.find(option);
    if (found == values_.end()) return;
    if constexpr (std::same_as<Field, EdgeWeights>) {
      const bool paper = py::cast<std::string>(found->second) == "paper";
      field = paper ? EdgeWeights::paper : EdgeWeights::cotangent;
    } else if constexpr (sizeof...(Parse) > 0) {
      field = (parse(py::cast<std::string>(found->second)), ...).value();
    } else {
      field = py::cast<Field>(found->second);
    }
  }

 private:
  std::map<std::string, py::object> values_;
};

}  // namespace brindle::python
