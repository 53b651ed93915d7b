/// Validated access to JSON objects.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace brindle::tool {

/// A JSON object. All functions throw Error with the path, such as `camera.zoom`, and the valid
/// values.
class JsonReader {
 public:
  /// `place` is "" for the whole file. Throws Error if it is no object.
  JsonReader(const nlohmann::ordered_json& object, std::string place);

  /// Throws Error for the first key not in the list.
  void allow(const std::vector<std::string>& known) const;

  bool has(const char* key) const { return object_.contains(key); }
  /// Throws Error if there is no such key.
  const nlohmann::ordered_json& at(const char* key) const;

  std::string text(const char* key) const;
  bool flag(const char* key) const;
  double number(const char* key) const;
  /// A number within bounds.
  float number(const char* key, double lowest, double highest) const;
  /// An integer within bounds.
  int whole(const char* key, int lowest, int highest) const;
  const nlohmann::ordered_json& list(const char* key) const;
  /// A list of `count` numbers.
  std::vector<double> numbers(const char* key, std::size_t count) const;
  std::vector<std::string> texts(const char* key) const;

  /// "camera.zoom"
  std::string place_of(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  const nlohmann::ordered_json& object_;
  std::string place_;
};

/// The shortest number that parses to the same float.
double short_number(float value);

/// Parses a JSON text. Throws Error with the line and column of a syntax error.
nlohmann::ordered_json parse_json(const std::string& text);

}  // namespace brindle::tool
