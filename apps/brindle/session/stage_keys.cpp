#include "session/stage_keys.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include "brindle/recipe/json_text.h"
#include "input/make_waves.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

/// Says whether a file has become another one.
std::string stamp_of(const std::string& path) {
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(path, missing);
  return missing ? "" : std::to_string(time.time_since_epoch().count());
}

/// Options, and of which files they speak.
std::string key_of(const OptionValues& options) {
  std::string key = json_text(options_to_json(options));
  for (const auto& [name, values] : options) {
    for (const std::string& value : values) key += '|' + stamp_of(value);
  }
  return key + '\n';
}

/// Those of the document's options that are named.
OptionValues named_options(const SessionDocument& document, std::span<const char* const> names) {
  const OptionValues all = shown_options(document);
  OptionValues options;
  for (const char* name : names) {
    const auto found = all.find(name);
    if (found != all.end()) options.insert(*found);
  }
  return options;
}

/// Which axis points up, by --up alone: of which the mesh is a shape or a file, its own key says.
std::string up_key(const SessionDocument& document) {
  constexpr std::array kUp = {"up"};
  return key_of(named_options(document, kUp));
}

std::string view_key(const SessionDocument& document) {
  return view_text(document.camera) + std::to_string(document.size.width) + 'x' +
         std::to_string(document.size.height) + up_key(document);
}

bool has_values(const SessionDocument& document, SessionStage stage,
                bool (*depend)(const std::string&)) {
  return std::ranges::any_of(shown_options(document), [&](const auto& entry) {
    const SessionOption* option = find_session_option(entry.first, document.shown);
    return option != nullptr && option->stage == stage && std::ranges::any_of(entry.second, depend);
  });
}

}  // namespace

std::string options_key(const SessionDocument& document, SessionStage stage) {
  OptionValues options;
  for (const auto& [name, values] : shown_options(document)) {
    const SessionOption* option = find_session_option(name, document.shown);
    if (option != nullptr && option->stage == stage) options[name] = values;
  }
  return key_of(options);
}

std::string surface_key(const SessionDocument& document) {
  return document.mesh + '|' + stamp_of(document.mesh) + '\n' +
         options_key(document, SessionStage::surface);
}

std::string camera_key(const SessionDocument& document, SessionStage stage) {
  if (has_values(document, stage, depends_on_camera)) return view_key(document);
  return has_values(document, stage, depends_on_up) ? up_key(document) : "";
}

std::string field_key(const SessionDocument& document) {
  SessionDocument without = document;
  for (const std::string& name : kOptionsAfterField) without.options.erase(name);
  std::string key = options_key(without, SessionStage::waves);
  // A smooth field goes on from that of the previous pattern. How both are turned is noted.
  if (document.options.contains("previous")) {
    constexpr std::array kLast = {"previous", "lambda", "match", "along", "rotate"};
    key += key_of(named_options(document, kLast));
  }
  for (const FieldStroke& stroke : document.strokes) key += stroke_to_json(stroke).dump();
  return key + '\n';
}

std::string waves_key(const SessionDocument& document) {
  return options_key(document, SessionStage::waves) +
         nlohmann::json(frequency_factor(document)).dump() +
         camera_key(document, SessionStage::waves) + '\n';
}

std::string pattern_key(const SessionDocument& document) {
  return surface_key(document) + field_key(document) + waves_key(document) +
         options_key(document, SessionStage::phases);
}

std::string others_key(const SessionDocument& document, const std::string& waves) {
  const auto found = document.options.find("with");
  if (found == document.options.end()) return "";
  const bool striped = std::ranges::any_of(found->second, [](const std::string& value) {
    return value.find("@striped") != std::string::npos ||
           value.find("@discarded") != std::string::npos;
  });
  return key_of({*found}) + (striped ? waves : "");
}

std::string values_key(const SessionDocument& document, const StyleOptions& style,
                       const std::string& others) {
  constexpr std::array kReading = {"width-by",     "color-by",   "opacity-by",  "texture-by",
                                   "tile-size-by", "field-mesh", "max-distance"};
  constexpr std::array kMargin = {"legend", "no-legend", "color-range", "width-range"};
  std::string key = key_of(named_options(document, kReading)) + up_key(document);
  if (!style.follows_camera()) return key;
  return key + key_of(named_options(document, kMargin)) + others + view_key(document);
}

std::string second_key(const SessionDocument& document) {
  constexpr std::array kSecond = {"field-v", "stripes-v", "frequency-v", "wales"};
  return key_of(named_options(document, kSecond));
}

}  // namespace brindle::tool
