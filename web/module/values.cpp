#include "values.h"

#include <cstring>
#include <exception>
#include <new>

#include <emscripten.h>

#include "brindle/error.h"

namespace brindle::web {
namespace {

// The exception passes through the module like one of C++, with destructors.
EM_JS(void, throw_error, (const char* text),
      { throw new Module.BrindleError(UTF8ToString(text)); });

template <class Number>
val copied(const Number* data, std::size_t count) {
  return val(emscripten::typed_memory_view(count, data)).call<val>("slice");
}

template <class Number>
std::vector<Number> numbers_of(const val& array) {
  if (array.isUndefined() || array.isNull()) return {};
  std::vector<Number> numbers(array["length"].as<std::size_t>());
  val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<void>("set", array);
  return numbers;
}

template <class Number>
ArrayView filled(std::vector<std::byte>& bytes, const val& array, std::size_t columns) {
  const std::size_t count = array["length"].as<std::size_t>();
  bytes.resize(count * sizeof(Number));
  auto* const numbers = reinterpret_cast<Number*>(bytes.data());
  val(emscripten::typed_memory_view(count, numbers)).call<void>("set", array);
  return {std::span<const Number>(numbers, count), columns};
}

}  // namespace

void raise(const std::string& message) {
  throw_error(message.c_str());
  std::terminate();
}

std::string message_of_exception() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "memory does not suffice; use a smaller mesh or close other pages";
  } catch (const std::exception& error) {
    return error.what();
  }
}

Table::Table(const val& array, std::size_t columns) {
  const auto is = [&](const char* type) { return array.instanceof (val::global(type)); };
  if (is("Float64Array")) {
    view_ = filled<double>(bytes_, array, columns);
  } else if (is("Int32Array")) {
    view_ = filled<std::int32_t>(bytes_, array, columns);
  } else if (is("Uint32Array")) {
    view_ = filled<std::uint32_t>(bytes_, array, columns);
  } else {
    view_ = filled<float>(bytes_, array, columns);
  }
}

float float_of(const val& object, const char* name) { return object[name].as<float>(); }
int int_of(const val& object, const char* name) { return object[name].as<int>(); }
std::string text_of(const val& object, const char* name) { return object[name].as<std::string>(); }

void put(val& object, const char* name, const val& value) { object.set(name, value); }
void put(val& object, const char* name, double number) { object.set(name, number); }

std::vector<float> floats_of(const val& array) { return numbers_of<float>(array); }

std::vector<Vec3> vectors_of(const val& array) {
  if (array.isUndefined() || array.isNull()) return {};
  const std::size_t count = array["length"].as<std::size_t>();
  if (count % 3 != 0) throw Error("vectors have three numbers each, not " + std::to_string(count));
  std::vector<Vec3> vectors(count / 3);
  val(emscripten::typed_memory_view(count, reinterpret_cast<float*>(vectors.data())))
      .call<void>("set", array);
  return vectors;
}

void fill_array(const val& array, std::span<const float> numbers) {
  array.call<void>("set", val(emscripten::typed_memory_view(numbers.size(), numbers.data())));
}

val array_of(std::span<const float> numbers) { return copied(numbers.data(), numbers.size()); }
val array_of(std::span<const Vec3> vectors) {
  return copied(reinterpret_cast<const float*>(vectors.data()), 3 * vectors.size());
}
val array_of(std::span<const Complex> numbers) {
  return copied(reinterpret_cast<const float*>(numbers.data()), 2 * numbers.size());
}
val array_of(std::span<const Triangle> triangles) {
  return copied(reinterpret_cast<const Index*>(triangles.data()), 3 * triangles.size());
}
val array_of(std::span<const std::uint32_t> numbers) {
  return copied(numbers.data(), numbers.size());
}
val array_of(std::span<const std::uint8_t> numbers) {
  return copied(numbers.data(), numbers.size());
}
val array_of(const std::vector<std::string>& words) {
  val list = val::array();
  for (const std::string& word : words) list.call<void>("push", word);
  return list;
}

}  // namespace brindle::web
