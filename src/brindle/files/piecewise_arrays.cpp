#include "brindle/files/piecewise_arrays.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "brindle/base/standard.h"
#include "brindle/base/text.h"

namespace brindle {

void PiecewiseArrays::add(std::vector<DataArray> piece) {
  make_names_unique(piece);
  if (!std::exchange(begun_, true)) {
    arrays_ = std::move(piece);
    return;
  }
  std::map<std::string_view, const DataArray*> others;  // whose names differ, by now
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
  std::map<std::string, std::size_t> met;  // how often
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
