#include "brindle/files/read_arrays.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "brindle/base/input_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/files/text/text_words.h"

namespace brindle {
namespace {

using Columns = std::vector<std::size_t>;

/// Columns whose names share everything up to their ending, by the ending in lower case.
using Family = std::map<std::string, std::size_t>;

/// A name's family and ending: what stands before and after the last ':' or '_', or its last letter
/// in vx, vy and vz. The ends of a tensor's components, as in sxx, are none.
std::optional<std::pair<std::string, std::string>> family_of(const std::string& name) {
  const std::size_t separator = name.find_last_of(":_");
  if (separator != std::string::npos) {
    if (separator == 0) return std::nullopt;
    return std::pair(name.substr(0, separator + 1), small_letters(name.substr(separator + 1)));
  }
  constexpr std::string_view kAxes = "xyzXYZ";
  const bool has_axis = name.size() > 1 && kAxes.find(name.back()) != std::string_view::npos &&
                        kAxes.find(name[name.size() - 2]) == std::string_view::npos;
  if (!has_axis) return std::nullopt;
  // A separator that no name has.
  return std::pair(name.substr(0, name.size() - 1) + '\0',
                   small_letters(name.substr(name.size() - 1)));
}

/// Endings that make up one array, in the order of its components.
std::vector<std::vector<std::string>> sets_of_endings(const Family& family) {
  std::vector<std::vector<std::string>> sets = {
      {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"},
      {"xx", "yy", "zz", "xy", "yz", "xz"},
      {"x", "y", "z"}};
  std::vector<std::string> numbers;
  while (family.contains(std::to_string(numbers.size()))) {
    numbers.push_back(std::to_string(numbers.size()));
  }
  const auto counted = std::count_if(family.begin(), family.end(), [](const auto& entry) {
    return parse_integer(entry.first).has_value();
  });
  // With a gap they are separate arrays.
  if (numbers.size() > 1 && numbers.size() == static_cast<std::size_t>(counted)) {
    sets.push_back(std::move(numbers));
  }
  return sets;
}

/// The columns of these endings; empty if one is missing or has another type.
Columns columns_with(const Family& family, const std::vector<std::string>& endings,
                     std::span<const DataArray> columns) {
  Columns found;
  for (const std::string& ending : endings) {
    const auto entry = family.find(ending);
    if (entry == family.end()) return {};
    if (!found.empty() && columns[entry->second].type != columns[found[0]].type) return {};
    found.push_back(entry->second);
  }
  return found;
}

DataArray joined(std::string name, std::span<const DataArray> columns, const Columns& numbers) {
  const DataArray& first = columns[numbers[0]];
  DataArray array{std::move(name), first.type, static_cast<int>(numbers.size()), {}};
  const std::size_t size = size_of(first.type), rows = first.rows();
  array.bytes.resize(first.bytes.size() * numbers.size());
  std::byte* out = array.bytes.data();
  for (std::size_t row = 0; row < rows; ++row) {
    for (const std::size_t column : numbers) {
      std::memcpy(out, &columns[column].bytes[row * size], size);
      out += size;
    }
  }
  return array;
}

}  // namespace

std::vector<DataArray> grouped_columns(std::vector<DataArray> columns) {
  std::map<std::string, Family> families;  // by the name up to and including the separator
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (const auto found = family_of(columns[c].name)) {
      families[found->first].try_emplace(found->second, c);
    }
  }
  std::vector<std::pair<std::size_t, DataArray>> arrays;  // with the index of their first columns
  std::vector<char> taken(columns.size(), 0);
  for (const auto& [name, family] : families) {
    for (const auto& endings : sets_of_endings(family)) {
      const Columns group = columns_with(family, endings, columns);
      if (group.empty() || taken[group[0]]) continue;
      for (const std::size_t column : group) taken[column] = 1;
      arrays.emplace_back(*std::min_element(group.begin(), group.end()),
                          joined(name.substr(0, name.size() - 1), columns, group));
    }
  }
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (!taken[c]) arrays.emplace_back(c, std::move(columns[c]));
  }
  ranges::sort(arrays, {}, [](const auto& entry) { return entry.first; });
  std::vector<DataArray> result;
  for (auto& entry : arrays) result.push_back(std::move(entry.second));
  return result;
}

void PiecewiseArrays::add(std::vector<DataArray> piece) {
  make_names_unique(piece);
  if (!std::exchange(begun_, true)) {
    arrays_ = std::move(piece);
    return;
  }
  std::map<std::string_view, const DataArray*> others;  // their names are distinct by now
  for (const DataArray& array : piece) others.emplace(array.name, &array);
  std::erase_if(arrays_, [&](DataArray& array) {
    const auto next = others.find(array.name);
    const bool same = next != others.end() && next->second->type == array.type &&
                      next->second->components == array.components;
    if (!same) {
      incomplete_.push_back(array.name);
      return true;
    }
    const std::vector<std::byte>& bytes = next->second->bytes;
    array.bytes.insert(array.bytes.end(), bytes.begin(), bytes.end());
    others.erase(next);
    return false;
  });
  for (const auto& [name, array] : others) incomplete_.emplace_back(name);
}

std::vector<DataArray> PiecewiseArrays::take(const std::string& of, std::string& left_out) {
  ranges::sort(incomplete_);
  incomplete_.erase(std::unique(incomplete_.begin(), incomplete_.end()), incomplete_.end());
  for (const std::string& name : incomplete_) {
    left_out += "array " + in_quotes(name) + " of " + of +
                ": left out, because pieces of the file lack it or have it of another type\n";
  }
  return std::move(arrays_);
}

void make_names_unique(std::vector<DataArray>& arrays) {
  std::set<std::string> taken;
  for (const DataArray& array : arrays) taken.insert(array.name);
  std::map<std::string, std::size_t> met;  // occurrences
  for (DataArray& array : arrays) {
    if (array.name.empty()) array.name = "unnamed";
    const std::string name = array.name;
    std::size_t& number = met[name];
    if (++number == 1) continue;
    while (!taken.insert(name + '_' + std::to_string(number)).second) ++number;
    array.name = name + '_' + std::to_string(number);
  }
}

}  // namespace brindle
