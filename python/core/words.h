/// Maps the tool's names to Python's, and back.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "brindle/error.h"
#include "brindle/recipe/refusals.h"
#include "brindle/stripe_pattern.h"

namespace brindle::python {

namespace py = pybind11;

/// Replaces option names in the tool's messages by argument names: --frequency-by is frequency_by.
std::string in_pythons_words(const std::string& text);

/// The number of a word among the choices of "--option". Throws Error, in Python's words, for
/// others.
std::size_t choice(const std::string& option, const std::string& word);

/// Calls `work` and translates errors from the tool's sources.
template <class Work>
auto saying_in_pythons_words(const Work& work) {
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error(in_pythons_words(error.what()));
  }
}

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
