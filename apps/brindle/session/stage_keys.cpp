#include "session/stage_keys.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "brindle/recipe/json_text.h"
#include "input/make_waves.h"
#include "input/vertex_values.h"

namespace brindle::tool {
namespace {

/// Changes when a file changes.
std::string stamp_of(const std::string& path) {
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(path, missing);
  return missing ? "" : std::to_string(time.time_since_epoch().count());
}

/// Options, with stamps of their files.
std::string key_of(const OptionValues& options) {
  std::string key = json_text(options_to_json(options));
  for (const auto& [name, values] : options) {
    for (const std::string& value : values) key += '|' + stamp_of(value);
  }
  return key + '\n';
}

/// The document's options that `counts` selects, by name and row.
template <class Counts>
OptionValues chosen_options(const SessionDocument& document, const Counts& counts) {
  OptionValues options;
  for (const auto& [name, values] : shown_options(document)) {
    const OptionInfo* info = find_session_option(name, document.shown);
    if (info != nullptr && counts(*info)) options[name] = values;
  }
  return options;
}

/// The key of the options with these names.
std::string key_of_named(const SessionDocument& document,
                         std::initializer_list<std::string_view> names) {
  return key_of(chosen_options(document, [&](const OptionInfo& info) {
    return std::ranges::find(names, info.name) != names.end();
  }));
}

constexpr OptionStage kWaveStages = OptionStage::field | OptionStage::waves;

/// The up axis of --up; the mesh's own key covers its default.
std::string up_key(const SessionDocument& document) { return key_of_named(document, {"up"}); }

/// The direction of the light.
std::string light_key(const SessionDocument& document) {
  return key_of_named(document, {"light-from"});
}

/// The visible sides of surfaces; the position of a slice does not matter.
std::string sides_key(const SessionDocument& document) {
  return shown_options(document).contains("slice") ? "both sides" : "";
}

std::string view_key(const SessionDocument& document) {
  return view_text(document.camera) + std::to_string(document.size.width) + 'x' +
         std::to_string(document.size.height) + up_key(document);
}

bool has_values(const SessionDocument& document, OptionStage stages,
                bool (*depend)(const std::string&)) {
  const OptionValues options =
      chosen_options(document, [&](const OptionInfo& info) { return has(stages, info.stale); });
  return std::ranges::any_of(
      options, [&](const auto& entry) { return std::ranges::any_of(entry.second, depend); });
}

}  // namespace

std::string options_key(const SessionDocument& document, OptionStage stages) {
  return key_of(
      chosen_options(document, [&](const OptionInfo& info) { return has(stages, info.stale); }));
}

std::string surface_key(const SessionDocument& document) {
  return document.mesh + '|' + stamp_of(document.mesh) + '\n' +
         options_key(document, OptionStage::surface);
}

std::string camera_key(const SessionDocument& document, OptionStage stages) {
  if (has_values(document, stages, depends_on_light)) {
    // Waves are those of the whole surface.
    const bool seen = has(stages, OptionStage::style);
    return view_key(document) + light_key(document) + (seen ? sides_key(document) : "");
  }
  if (has_values(document, stages, depends_on_camera)) return view_key(document);
  return has_values(document, stages, depends_on_up) ? up_key(document) : "";
}

std::string ornaments_key(const SessionDocument& document) {
  const OptionValues looks = chosen_options(document, [](const OptionInfo& info) {
    return has(OptionStage::style, info.stale) && info.name != "light-from" && info.name != "slice";
  });
  return key_of(looks) + camera_key(document, OptionStage::style);
}

std::string field_key(const SessionDocument& document) {
  std::string key = options_key(document, OptionStage::field);
  // A smooth field starts from that of the previous pattern; both turns are noted.
  if (document.options.contains("previous")) {
    key += key_of_named(document, {"previous", "lambda", "match", "along", "rotate"});
  }
  for (const FieldStroke& stroke : all_strokes(document)) key += stroke_to_json(stroke).dump();
  return key + '\n';
}

std::string waves_key(const SessionDocument& document) {
  return options_key(document, kWaveStages) + nlohmann::json(frequency_factor(document)).dump() +
         camera_key(document, kWaveStages) + '\n';
}

std::string pattern_key(const SessionDocument& document) {
  return surface_key(document) + field_key(document) + waves_key(document) +
         options_key(document, OptionStage::phases);
}

std::string others_key(const StyleOptions& style, const std::string& waves) {
  std::string key;
  for (const OtherSurfaceChoice& other : style.others) {
    key += text_of(without_looks(other)) + '|' + stamp_of(other.mesh) + '\n';
  }
  const bool waved = std::ranges::any_of(style.others, &OtherSurfaceChoice::has_pattern);
  return key + (waved ? waves : "");
}

std::string values_key(const SessionDocument& document, const StyleOptions& style,
                       const std::string& others) {
  std::string key = options_key(document, OptionStage::values) + up_key(document);
  for (const OtherSurfaceChoice& other : style.others) {
    key += other.color_by + '|' + stamp_of(value_file(other.color_by)) + '\n';
    if (!other.color_by.empty()) key += others;
  }
  if (!style.follows_camera()) return key;
  return key + options_key(document, OptionStage::margin) + others + view_key(document) +
         (has_values(document, OptionStage::values, depends_on_light)
              ? light_key(document) + sides_key(document)
              : "");
}

}  // namespace brindle::tool
