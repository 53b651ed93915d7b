/// Maps the tool's names to Python's.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "brindle/error.h"
#include "brindle/recipe/refusals.h"

namespace brindle::python {

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

}  // namespace brindle::python
