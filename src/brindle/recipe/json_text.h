/// JSON text, for names of any bytes.
#pragma once

#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "brindle/base/text.h"

namespace brindle {

/// `json` with `utf8_text` applied to every text and key.
template <class Json>
Json utf8_json(const Json& json) {
  if (json.is_string()) return utf8_text(json.template get_ref<const std::string&>());
  if (json.is_array()) {
    Json list = Json::array();
    for (const Json& value : json) list.push_back(utf8_json(value));
    return list;
  }
  if (!json.is_object()) return json;
  Json object = Json::object();
  for (const auto& [key, value] : json.items()) object[utf8_text(key)] = utf8_json(value);
  return object;
}

/// Writes bytes that are not UTF-8, as in file names, as \xe9: JSON only allows UTF-8, and a
/// finished job must not fail because of them.
template <class Json>
std::string json_text(const Json& json, int indent = -1) {
  try {
    return json.dump(indent);
  } catch (const typename Json::type_error&) {
    return utf8_json(json).dump(indent);
  }
}

}  // namespace brindle
