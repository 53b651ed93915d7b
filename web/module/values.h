/// Numbers of JavaScript into the library and out of it, and errors across the border.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <emscripten/val.h>

#include "brindle/arrays.h"
#include "brindle/types.h"

namespace brindle::web {

using emscripten::val;

/// Throws the message as a BrindleError of JavaScript.
[[noreturn]] void raise(const std::string& message);

/// The message of the exception that is being handled.
std::string message_of_exception();

/// What `work` returns; what it throws becomes a BrindleError.
template <class Work>
auto guarded(const Work& work) -> decltype(work()) {
  std::string message;
  try {
    return work();
  } catch (...) {
    message = message_of_exception();
  }
  raise(message);
}

/// A table of JavaScript's numbers: a copy of a Float32Array, Float64Array, Int32Array or
/// Uint32Array, which the layer in JavaScript has made sure of.
class Table {
 public:
  Table(const val& array, std::size_t columns);
  const ArrayView& view() const { return view_; }

 private:
  std::vector<std::byte> bytes_;
  ArrayView view_;
};

/// What an object says under a name; the layer in JavaScript has made sure of the type.
float float_of(const val& object, const char* name);
int int_of(const val& object, const char* name);
std::string text_of(const val& object, const char* name);

void put(val& object, const char* name, const val& value);
void put(val& object, const char* name, double number);

/// Copies of typed arrays; undefined and null are empty.
std::vector<float> floats_of(const val& array);
std::vector<Vec3> vectors_of(const val& array);

/// Copies into an array that JavaScript owns and that is as long.
void fill_array(const val& array, std::span<const float> numbers);

/// Copies, as arrays that JavaScript owns.
val array_of(std::span<const float> numbers);
val array_of(std::span<const Vec3> vectors);
val array_of(std::span<const Complex> numbers);
val array_of(std::span<const std::uint32_t> numbers);
val array_of(std::span<const std::uint8_t> numbers);
val array_of(const std::vector<std::string>& words);

}  // namespace brindle::web
