/// Values of JSON objects, and what is wrong with them.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace brindle::tool {

/// An object of which everything is known. All functions throw Error naming the place, such as
/// `camera.zoom`, and what to write there instead.
class JsonReader {
 public:
  /// `place` is "" for the whole file. Throws Error if it is no object.
  JsonReader(const nlohmann::json& object, std::string place);

  /// Throws Error for the first key that is none of these.
  void allow(std::initializer_list<const char*> keys) const;

  bool has(const char* key) const { return object_.contains(key); }
  /// Throws Error if there is no such key.
  const nlohmann::json& at(const char* key) const;

  std::string text(const char* key) const;
  bool flag(const char* key) const;
  double number(const char* key) const;
  /// A number within bounds.
  float number(const char* key, double lowest, double highest) const;
  /// A whole number within bounds.
  int whole(const char* key, int lowest, int highest) const;
  const nlohmann::json& list(const char* key) const;
  /// A list of so many numbers.
  std::vector<double> numbers(const char* key, std::size_t count) const;
  std::vector<std::string> texts(const char* key) const;

  /// "camera.zoom"
  std::string place_of(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  const nlohmann::json& object_;
  std::string place_;
};

/// A float as the shortest number that is read as it again.
double short_number(float value);

/// The whole of a JSON text. Throws Error naming the line and column where it is damaged.
nlohmann::json parse_json(const std::string& text);

}  // namespace brindle::tool
