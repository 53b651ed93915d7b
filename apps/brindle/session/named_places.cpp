#include "session/named_places.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "brindle/base/formatted.h"
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

/// The part of a value after `begin`, up to `end`, with what `new_place` says instead of a place.
std::string replaced(const std::string& value, std::size_t begin, std::size_t end,
                     const NewPlace& new_place) {
  const auto place = place_in_text(value.substr(begin, end - begin));
  const auto other = place ? new_place(*place) : std::nullopt;
  if (!other) return value.substr(begin, end - begin);
  return formatted("%.7g,%.7g,%.7g", other->x(), other->y(), other->z());
}

/// The value with other places.
std::string with_places(const std::string& option, const std::string& value,
                        const NewPlace& new_place) {
  constexpr std::string_view kDistance = "distance:";
  if (option != "with") {
    if (!value.starts_with(kDistance)) return value;
    return std::string(kDistance) + replaced(value, kDistance.size(), value.size(), new_place);
  }
  std::string result;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find('@', begin), value.size());
    if (begin > 0) result += '@';
    result += begin > 0 ? replaced(value, begin, end, new_place) : value.substr(0, end);
    begin = end + 1;
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
