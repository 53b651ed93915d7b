#include "brindle/base/number_text.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

template <class Number>
std::string text_of(Number number, std::to_chars_result (*write)(char*, char*, Number)) {
  char text[64];
  const auto [end, error] = write(text, text + sizeof text, number);
  return error == std::errc() ? std::string(text, end) : "does not fit";
}

template <class Number>
std::string by_library(Number number) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// All kinds of numbers, by their bits.
template <class Number, class Bits>
std::vector<Number> numbers() {
  std::vector<Number> list;
  for (const double number :
       {0.0, 1.0, 10.0, 100.0, 123456.0, 16777217.0, 1e5, 1e15, 1e16, 1e21, 1e22, 0.1, 0.001, 1e-4,
        1e-5, 1234567.0, 0.30000001192092896, 5e-324, 3.4e38}) {
    list.push_back(static_cast<Number>(number));
  }
  list.push_back(std::numeric_limits<Number>::max());
  list.push_back(std::numeric_limits<Number>::min());
  list.push_back(std::numeric_limits<Number>::denorm_min());
  list.push_back(std::numeric_limits<Number>::infinity());
  Bits bits = 1;
  for (int i = 0; i < 20000; ++i) {
    bits = bits * static_cast<Bits>(6364136223846793005u) + static_cast<Bits>(1442695040888963407u);
    const auto number = std::bit_cast<Number>(bits);
    if (!std::isnan(number)) list.push_back(number);
    list.push_back(static_cast<Number>(static_cast<std::int64_t>(bits % 1000000)) / 1000);
  }
  for (std::size_t i = 0, count = list.size(); i < count; ++i) list.push_back(-list[i]);
  return list;
}

template <class Number>
void expect_read_alike(std::string_view text) {
  Number ours = -7, theirs = -7;
  const auto a = read_portably(text.data(), text.data() + text.size(), ours);
  const auto b = std::from_chars(text.data(), text.data() + text.size(), theirs);
  EXPECT_EQ(a.ptr - text.data(), b.ptr - text.data()) << text;
  EXPECT_EQ(a.ec, b.ec) << text;
  if (std::isnan(theirs)) {
    EXPECT_TRUE(std::isnan(ours)) << text;
  } else {
    EXPECT_EQ(ours, theirs) << text;
  }
}

TEST(NumberText, WritesTheShortestTextAsTheLibraryDoes) {
  for (const float number : numbers<float, std::uint32_t>()) {
    ASSERT_EQ(text_of<float>(number, write_portably), by_library(number));
  }
  for (const double number : numbers<double, std::uint64_t>()) {
    ASSERT_EQ(text_of<double>(number, write_portably), by_library(number));
  }
}

TEST(NumberText, ReadsWhatItWrote) {
  for (const float number : numbers<float, std::uint32_t>()) {
    expect_read_alike<float>(by_library(number));
  }
  for (const double number : numbers<double, std::uint64_t>()) {
    expect_read_alike<double>(by_library(number));
  }
}

TEST(NumberText, TakesAndRefusesWhatTheLibraryDoes) {
  for (const char* text :
       {"1",
        "-1",
        "+1",
        " 1",
        "1 ",
        "",
        "-",
        ".",
        ".5",
        "5.",
        "-.5e1",
        "1e",
        "1e+",
        "1e5",
        "1E-5",
        "1e5x",
        "0x10",
        "inf",
        "-INF",
        "infinity",
        "infinit",
        "nan",
        "NaN",
        "nanx",
        "1,5",
        "1e400",
        "1e-400",
        "-1e400",
        "1e39",
        "1e-50",
        "0e999",
        "0.0e-999",
        "00012.50",
        "x",
        "--1",
        "1e5e5",
        "12345678901234567890123456789012345678901234567890123456789012345678901234567890123456789"
        "0",
        "0.00000000000000000000000000000000000000000000000000000000000000000000000000000001"}) {
    expect_read_alike<float>(text);
    expect_read_alike<double>(text);
  }
}

TEST(NumberText, SaysIfThereIsNoRoom) {
  char text[3];
  EXPECT_EQ(write_portably(text, text + sizeof text, 0.125).ec, std::errc::value_too_large);
  EXPECT_EQ(write_portably(text, text + sizeof text, 0.5).ec, std::errc());
}

}  // namespace
}  // namespace brindle
