/// Values as bytes of a file, written and read by the same statements.
#pragma once

#include <array>
#include <bit>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include "brindle/error.h"

namespace brindle {

static_assert(std::endian::native == std::endian::little, "archives are little endian");

/// Types whose values are their bytes, on every system: numbers, and arrays and structs of numbers
/// of one type.
template <class T>
inline constexpr bool kIsArchivedAsBytes = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <class Number, int Rows>
inline constexpr bool kIsArchivedAsBytes<Eigen::Matrix<Number, Rows, 1>> = Rows > 0;
template <class Number>
inline constexpr bool kIsArchivedAsBytes<std::complex<Number>> = true;
template <class Number, std::size_t Count>
inline constexpr bool kIsArchivedAsBytes<std::array<Number, Count>> = kIsArchivedAsBytes<Number>;

/// Writes values into bytes or reads them from bytes. Reading throws Error where bytes end too
/// early or a value has no meaning; it trusts no size.
class Archive {
 public:
  Archive() = default;
  explicit Archive(std::string_view bytes) : read_(bytes), reads_(true) {}

  bool reads() const { return reads_; }
  const std::string& bytes() const { return written_; }

  /// Throws Error if bytes are left.
  void check_end() const {
    if (!read_.empty()) fail();
  }

  template <class... Values>
  void operator()(Values&... values) {
    (value(values), ...);
  }

  /// An enumerator from 0 to `last`.
  template <class Enum>
  void choice(Enum& chosen, std::type_identity_t<Enum> last) {
    auto number = static_cast<std::uint8_t>(chosen);
    value(number);
    if (number > static_cast<std::uint8_t>(last)) fail();
    if (reads_) chosen = static_cast<Enum>(number);
  }

  /// A list of `count` entries.
  template <class List>
  void list_of(std::size_t count, List& values) {
    value(values);
    if (values.size() != count) fail();
  }

  /// The same, or an empty one.
  template <class List>
  void list_of_or_none(std::size_t count, List& values) {
    value(values);
    if (!values.empty() && values.size() != count) fail();
  }

  [[noreturn]] static void fail() { throw Error("the file is damaged; save it again"); }

 private:
  void raw(void* data, std::size_t size) {
    if (!reads_) {
      written_.append(static_cast<const char*>(data), size);
      return;
    }
    if (size > read_.size()) fail();
    if (size > 0) std::memcpy(data, read_.data(), size);
    read_.remove_prefix(size);
  }

  template <class T>
  requires(kIsArchivedAsBytes<T>) void value(T& number) { raw(&number, sizeof number); }

  void value(bool& is) {
    std::uint8_t number = is ? 1 : 0;
    raw(&number, 1);
    if (number > 1) fail();
    is = number == 1;
  }

  template <class T>
  void value(std::vector<T>& values) {
    static_assert(kIsArchivedAsBytes<T>);
    std::uint64_t count = values.size();
    value(count);
    if (reads_) {
      if (count > read_.size() / sizeof(T)) fail();
      values.resize(static_cast<std::size_t>(count));
    }
    raw(values.data(), values.size() * sizeof(T));
  }

  template <class T>
  void value(std::optional<T>& maybe) {
    bool has = maybe.has_value();
    value(has);
    if (reads_ && !has) maybe.reset();
    if (reads_ && has) maybe.emplace();
    if (has) value(*maybe);
  }

  std::string written_;
  std::string_view read_;
  bool reads_ = false;
};

}  // namespace brindle
