#include "cli/option_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "brindle/error.h"
#include "brindle/recipe/refusals.h"

namespace brindle::tool {

void wrong_usage(const std::string& option, const std::string& expected, const std::string& value) {
  throw CLI::ValidationError(option, "expected " + expected + ", got '" + value + "'");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) return std::nullopt;
  if (!std::isfinite(static_cast<double>(value))) return std::nullopt;
  return value;
}

template std::optional<int> number_in(std::string_view text);
template std::optional<float> number_in(std::string_view text);
template std::optional<double> number_in(std::string_view text);

namespace {

/// The same with or without a plus.
template <class Number = float>
std::optional<Number> finite_number(std::string_view text) {
  return number_in<Number>(text.starts_with('+') ? text.substr(1) : text);
}

}  // namespace

float parse_number(const std::string& option, const std::string& text) {
  const auto value = finite_number<float>(text);
  if (!value) wrong_usage(option, "a finite number", text);
  return *value;
}

Eigen::Vector3d parse_place(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  Eigen::Vector3d place;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parts.size() == 3 ? finite_number<double>(parts[i]) : std::nullopt;
    if (!value) wrong_usage(option, "three finite numbers X,Y,Z", text);
    place[static_cast<Eigen::Index>(i)] = *value;
  }
  return place;
}

std::pair<std::string, std::string> parse_ends(const std::string& option,
                                               const std::string& expected,
                                               const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == text.npos) wrong_usage(option, expected, text);
  return {text.substr(0, dots), text.substr(dots + 2)};
}

ValueRange parse_range(const std::string& option, const std::string& text) {
  const char* expected = "two finite numbers A..B";
  const auto [lowest, highest] = parse_ends(option, expected, text);
  const auto from = finite_number(lowest), to = finite_number(highest);
  if (!from || !to) wrong_usage(option, expected, text);
  return {*from, *to};
}

ValueRange parse_rising_range(const std::string& option, const std::string& text) {
  const ValueRange range = parse_range(option, text);
  if (!(range.lowest < range.highest)) {
    wrong_usage(option, "two numbers A..B, the smaller one first", text);
  }
  return range;
}

float parse_not_negative_number(const std::string& option, const std::string& text) {
  const float value = parse_number(option, text);
  if (value < 0) wrong_usage(option, "a finite number, zero or more", text);
  return value;
}

float parse_positive_number(const std::string& option, const std::string& text) {
  const auto value = finite_number(text);
  if (!value || *value <= 0) wrong_usage(option, "a finite number above zero", text);
  return *value;
}

float parse_number_of(const OptionInfo& row, const std::string& option, const std::string& text) {
  const auto value = finite_number(text);
  if (!value || !row.range.contains(*value)) wrong_usage(option, taken_by(row), text);
  return *value;
}

Length parse_length_of(const OptionInfo& row, const std::string& option, const std::string& text) {
  const bool percent = text.ends_with('%');
  const auto value = finite_number(percent ? text.substr(0, text.size() - 1) : text);
  if (!value || !row.range.contains(*value)) wrong_usage(option, taken_by(row), text);
  return {percent ? *value / 100 : *value, percent};
}

std::size_t parse_choice_of(const OptionInfo& row, const std::string& option,
                            const std::string& text) {
  const std::vector<std::string> words = split(std::string(row.form), '|');
  const auto word = std::ranges::find(words, text);
  if (word == words.end()) wrong_usage(option, taken_by(row), text);
  return static_cast<std::size_t>(word - words.begin());
}

Vec3 parse_direction(const std::string& option, const std::string& text) {
  const char* expected = "x,y,z: three finite numbers, not all zero; or an axis such as x or -z";
  constexpr std::array kAxes = {"x", "y", "z", "-x", "-y", "-z"};
  if (const auto axis = std::ranges::find(kAxes, text); axis != kAxes.end()) {
    Vec3 direction = Vec3::Zero();
    direction[(axis - kAxes.begin()) % 3] = text.starts_with('-') ? -1.0f : 1.0f;
    return direction;
  }
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3) wrong_usage(option, expected, text);
  Vec3 direction;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = finite_number(parts[static_cast<std::size_t>(axis)]);
    if (!value) wrong_usage(option, expected, text);
    direction[axis] = *value;
  }
  if (direction.isZero(0)) wrong_usage(option, expected, text);
  return direction;
}

}  // namespace brindle::tool
