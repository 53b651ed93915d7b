#include "session/json_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle::tool {

JsonReader::JsonReader(const nlohmann::ordered_json& object, std::string place)
    : object_(object), place_(std::move(place)) {
  if (object.is_object()) return;
  throw Error((place_.empty() ? "the whole" : place_) + " must be an object, not " +
              object.type_name());
}

std::string JsonReader::place_of(std::string_view key) const {
  return place_.empty() ? std::string(key) : place_ + '.' + std::string(key);
}

void JsonReader::fail(std::string_view key, const std::string& what) const {
  throw Error(place_of(key) + ' ' + what);
}

void JsonReader::allow(const std::vector<std::string>& known) const {
  for (const auto& [key, value] : object_.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string meant = nearest(key, known);
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    throw Error((place_.empty() ? "unknown key " : place_ + ": unknown key ") + in_quotes(key) +
                (meant.empty() ? "" : " (did you mean '" + meant + "'?)") + "; known are: " + list);
  }
}

const nlohmann::ordered_json& JsonReader::at(const char* key) const {
  const auto found = object_.find(key);
  if (found != object_.end()) return *found;
  throw Error((place_.empty() ? "lacks '" : place_ + " lacks '") + std::string(key) + "'; add it");
}

std::string JsonReader::text(const char* key) const {
  const nlohmann::ordered_json& value = at(key);
  if (!value.is_string()) fail(key, std::string("must be text, not ") + value.type_name());
  return value.get<std::string>();
}

bool JsonReader::flag(const char* key) const {
  const nlohmann::ordered_json& value = at(key);
  if (!value.is_boolean()) {
    fail(key, std::string("must be true or false, not ") + value.type_name());
  }
  return value.get<bool>();
}

double JsonReader::number(const char* key) const {
  const nlohmann::ordered_json& value = at(key);
  if (!value.is_number()) fail(key, std::string("must be a number, not ") + value.type_name());
  return value.get<double>();
}

float JsonReader::number(const char* key, double lowest, double highest) const {
  const double value = number(key);
  if (!(value >= lowest && value <= highest)) {
    fail(key, formatted("must be a number from %g to %g", lowest, highest));
  }
  return static_cast<float>(value);
}

int JsonReader::whole(const char* key, int lowest, int highest) const {
  const double value = number(key);
  if (!(value >= lowest && value <= highest && value == std::floor(value))) {
    fail(key, "must be a whole number from " + std::to_string(lowest) + " to " +
                  std::to_string(highest));
  }
  return static_cast<int>(value);
}

const nlohmann::ordered_json& JsonReader::list(const char* key) const {
  const nlohmann::ordered_json& value = at(key);
  if (!value.is_array()) fail(key, std::string("must be a list, not ") + value.type_name());
  return value;
}

std::vector<double> JsonReader::numbers(const char* key, std::size_t count) const {
  const nlohmann::ordered_json& values = list(key);
  const bool fits = values.size() == count && std::ranges::all_of(values, [](const auto& value) {
                      return value.is_number();
                    });
  if (!fits) fail(key, "must be a list of " + std::to_string(count) + " numbers");
  return values.get<std::vector<double>>();
}

std::vector<std::string> JsonReader::texts(const char* key) const {
  const nlohmann::ordered_json& values = list(key);
  if (!std::ranges::all_of(values, [](const auto& value) { return value.is_string(); })) {
    fail(key, "must be a list of texts");
  }
  return values.get<std::vector<std::string>>();
}

double short_number(float value) {
  char text[64];
  const char* end = std::to_chars(text, text + sizeof text, value).ptr;
  double number = 0;
  std::from_chars(text, end, number);
  return number + 0.0;  // -0 would be read as an integer
}

nlohmann::ordered_json parse_json(const std::string& text) {
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    // Without the JSON library's prefix.
    const std::string reason = printable(error.what());
    const std::size_t tag = reason.find("] ");
    throw Error("damaged JSON: " + (tag == std::string::npos ? reason : reason.substr(tag + 2)) +
                "; correct it there or write the file again");
  }
}

}  // namespace brindle::tool
