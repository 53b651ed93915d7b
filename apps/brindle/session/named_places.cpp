#include "session/named_places.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "brindle/base/text.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

std::optional<Eigen::Vector3d> place_in_text(const std::string& text) {
  if (std::ranges::count(text, ',') != 2) return std::nullopt;
  try {
    return parse_place("", text);
  } catch (const CLI::ValidationError&) {
    return std::nullopt;
  }
}

using NewPlace = std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector3d&)>;

/// Replaces a place "X,Y,Z" by `new_place`. Other text stays.
std::string replaced(const std::string& text, const NewPlace& new_place) {
  const auto place = place_in_text(text);
  const auto other = place ? new_place(*place) : std::nullopt;
  if (!other) return text;
  return formatted("%.7g,%.7g,%.7g", other->x(), other->y(), other->z());
}

/// The same for a value "distance:X,Y,Z".
std::string with_distance(const std::string& value, const NewPlace& new_place) {
  constexpr std::string_view kDistance = "distance:";
  if (!value.starts_with(kDistance)) return value;
  return std::string(kDistance) + replaced(value.substr(kDistance.size()), new_place);
}

/// The same for a part of another surface.
std::string with_place_of_part(const std::string& part, const NewPlace& new_place) {
  constexpr std::string_view kColor = "color-by=";
  if (!part.starts_with(kColor)) return replaced(part, new_place);
  return std::string(kColor) + with_distance(part.substr(kColor.size()), new_place);
}

/// The value with replaced places.
std::string with_places(const std::string& option, const std::string& value,
                        const NewPlace& new_place) {
  if (option != "with") return with_distance(value, new_place);
  const std::vector<std::string> parts = split(value, '@');
  std::string result = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    result += '@' + with_place_of_part(parts[i], new_place);
  }
  return result;
}

}  // namespace

std::vector<NamedPlace> named_places(const OptionValues& options) {
  std::vector<NamedPlace> places;
  for (const auto& [name, values] : options) {
    for (const std::string& value : values) {
      with_places(name, value, [&, &option = name](const Eigen::Vector3d& at) {
        auto found = std::ranges::find(places, at, &NamedPlace::at);
        if (found == places.end()) found = places.insert(found, {at, {}});
        if (std::ranges::find(found->options, option) == found->options.end()) {
          found->options.push_back(option);
        }
        return std::nullopt;
      });
    }
  }
  return places;
}

OptionValues with_place_at(const Eigen::Vector3d& to, const NamedPlace& place,
                           const OptionValues& options) {
  OptionValues result;
  for (const std::string& name : place.options) {
    for (const std::string& value : options.at(name)) {
      result[name].push_back(with_places(name, value, [&](const Eigen::Vector3d& at) {
        return at == place.at ? std::optional(to) : std::nullopt;
      }));
    }
  }
  return result;
}

}  // namespace brindle::tool
