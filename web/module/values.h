/// Converts numbers and errors between JavaScript and the library.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <emscripten/val.h>

#include "brindle/arrays.h"
#include "brindle/mesh.h"
#include "brindle/types.h"

namespace brindle::web {

using emscripten::val;

/// Throws a JavaScript BrindleError.
[[noreturn]] void raise(const std::string& message);

/// The message of the current exception.
std::string message_of_exception();

template <auto work>
struct Guarded;
template <class Result, class... Arguments, Result (*work)(Arguments...)>
struct Guarded<work> {
  static Result call(Arguments... arguments) {
    std::string message;
    try {
      return work(static_cast<Arguments&&>(arguments)...);
    } catch (...) {
      message = message_of_exception();
    }
    raise(message);
  }
};

/// A function as JavaScript calls it: its exceptions become BrindleError.
template <auto work>
inline constexpr auto guarded = &Guarded<work>::call;

/// A table of numbers: a copy of a Float32Array, Float64Array, Int32Array or Uint32Array, which the
/// JavaScript layer has checked.
class Table {
 public:
  Table(const val& array, std::size_t columns);
  const ArrayView& view() const { return view_; }

 private:
  std::vector<std::byte> bytes_;
  ArrayView view_;
};

/// A property of an object; the JavaScript layer has checked its type.
float float_of(const val& object, const char* name);
int int_of(const val& object, const char* name);
std::string text_of(const val& object, const char* name);

void put(val& object, const char* name, const val& value);
void put(val& object, const char* name, double number);

/// Copies of typed arrays; undefined and null give empty ones.
std::vector<float> floats_of(const val& array);
std::vector<Vec3> vectors_of(const val& array);

/// Copies into a JavaScript array of the same length.
void fill_array(const val& array, std::span<const float> numbers);

/// Copies into new JavaScript arrays.
val array_of(std::span<const float> numbers);
val array_of(std::span<const Vec3> vectors);
val array_of(std::span<const Complex> numbers);
val array_of(std::span<const Triangle> triangles);
val array_of(std::span<const std::uint32_t> numbers);
val array_of(std::span<const std::uint8_t> numbers);
val array_of(const std::vector<std::string>& words);

}  // namespace brindle::web
