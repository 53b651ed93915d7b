/// Replacements for older standard libraries: `ranges`, the algorithms of std::ranges (libc++
/// before 15), and `bit_cast` (libc++ before 14).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>
#include <version>

#if defined(__cpp_lib_ranges)

namespace brindle {
namespace ranges = std::ranges;
}  // namespace brindle

#else

namespace brindle::ranges {

/// Compares two elements by their projections.
template <class Less, class Projection>
auto by(Less less, Projection projection) {
  return [less, projection](const auto& a, const auto& b) {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  };
}

template <class Predicate, class Projection>
auto where(Predicate predicate, Projection projection) {
  return [predicate, projection](auto&& a) {
    return static_cast<bool>(std::invoke(predicate, std::invoke(projection, a)));
  };
}

template <class Value, class Projection>
auto equals(const Value& value, Projection projection) {
  return [&value, projection](auto&& a) { return std::invoke(projection, a) == value; };
}

template <class Range, class Predicate, class Projection = std::identity>
bool all_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::all_of(std::begin(range), std::end(range), where(predicate, projection));
}

template <class Range, class Predicate, class Projection = std::identity>
bool any_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::any_of(std::begin(range), std::end(range), where(predicate, projection));
}

template <class Range, class Predicate, class Projection = std::identity>
bool none_of(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::none_of(std::begin(range), std::end(range), where(predicate, projection));
}

template <class Range, class Value, class Projection = std::identity>
auto count(Range&& range, const Value& value, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), equals(value, projection));
}

template <class Range, class Predicate, class Projection = std::identity>
auto count_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::count_if(std::begin(range), std::end(range), where(predicate, projection));
}

template <class Range, class Value, class Projection = std::identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), equals(value, projection));
}

template <class Range, class Predicate, class Projection = std::identity>
auto find_if(Range&& range, Predicate predicate, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range), where(predicate, projection));
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
auto max_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), by(less, projection));
}

template <class Range, class Value, class Less = std::less<>, class Projection = std::identity>
auto lower_bound(Range&& range, const Value& value, Less less = {}, Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value,
                          [less, projection](const auto& a, const Value& v) {
                            return std::invoke(less, std::invoke(projection, a), v);
                          });
}

template <class Range, class Value>
bool binary_search(Range&& range, const Value& value) {
  return std::binary_search(std::begin(range), std::end(range), value);
}

/// Sorts short runs by insertion, then merges them in pairs. A quarter of the code of libc++'s
/// std::sort, which matters for programs that are downloaded.
template <class Value, class Less>
void merge_sort(Value* values, std::size_t count, const Less& less) {
  constexpr std::size_t kRun = 12;
  for (std::size_t i = 1; i < count; ++i) {
    Value value = std::move(values[i]);
    std::size_t place = i;
    for (; place % kRun != 0 && less(value, values[place - 1]); --place) {
      values[place] = std::move(values[place - 1]);
    }
    values[place] = std::move(value);
  }
  if (count <= kRun) return;
  std::vector<Value> others(std::make_move_iterator(values),
                            std::make_move_iterator(values + count));
  Value *from = others.data(), *to = values;
  for (std::size_t run = kRun; run < count; run *= 2) {
    for (std::size_t begin = 0; begin < count; begin += 2 * run) {
      const std::size_t middle = std::min(begin + run, count);
      const std::size_t end = std::min(middle + run, count);
      std::size_t left = begin, right = middle;
      for (std::size_t place = begin; place < end; ++place) {
        const bool take_right = left == middle || (right < end && less(from[right], from[left]));
        to[place] = std::move(from[take_right ? right++ : left++]);
      }
    }
    std::swap(from, to);
  }
  if (from != values) std::move(from, from + count, values);
}

template <class Iterator, class Less = std::less<>, class Projection = std::identity>
requires std::contiguous_iterator<Iterator>
void sort(Iterator first, Iterator last, Less less = {}, Projection projection = {}) {
  merge_sort(std::to_address(first), static_cast<std::size_t>(last - first), by(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
requires requires(Range& range) { std::begin(range); }
void sort(Range&& range, Less less = {}, Projection projection = {}) {
  sort(std::begin(range), std::end(range), less, projection);
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
void stable_sort(Range&& range, Less less = {}, Projection projection = {}) {
  sort(range, less, projection);
}

template <class Range>
void reverse(Range&& range) {
  std::reverse(std::begin(range), std::end(range));
}

template <class Range, class Value>
void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}

template <class Range, class Value>
void replace(Range&& range, const Value& before, const Value& after) {
  std::replace(std::begin(range), std::end(range), before, after);
}

template <class Range, class Output>
void copy(Range&& range, Output output) {
  std::copy(std::begin(range), std::end(range), output);
}

template <class Range, class Output, class Function>
void transform(Range&& range, Output output, Function function) {
  std::transform(std::begin(range), std::end(range), output, std::move(function));
}

template <class First, class Second, class Output, class Function>
requires requires(Second& second) { std::begin(second); }
void transform(First&& first, Second&& second, Output output, Function function) {
  // As long as the shorter input.
  auto a = std::begin(first);
  auto b = std::begin(second);
  for (; a != std::end(first) && b != std::end(second); ++a, ++b, ++output) {
    *output = std::invoke(function, *a, *b);
  }
}

template <class First, class Second, class Equal = std::equal_to<>>
bool equal(First&& first, Second&& second, Equal equal = {}) {
  return std::equal(std::begin(first), std::end(first), std::begin(second), std::end(second),
                    equal);
}

}  // namespace brindle::ranges

#endif

namespace brindle {

#if defined(__cpp_lib_bit_cast)
using std::bit_cast;
#else
/// The value of another type that has the same bits.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

}  // namespace brindle
