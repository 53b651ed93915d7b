#include "brindle/option_table.h"

#include <algorithm>
#include <cmath>

#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/recipe/job_rows.h"
#include "brindle/recipe/mark_rows.h"
#include "brindle/recipe/path_rows.h"
#include "brindle/recipe/refusals.h"
#include "brindle/recipe/relief_rows.h"
#include "brindle/recipe/solving_rows.h"
#include "brindle/recipe/style_rows.h"
#include "brindle/recipe/texture_rows.h"
#include "brindle/recipe/wave_rows.h"

namespace brindle {
namespace {

constexpr auto kTable = joined(kWaveRows, kSolvingRows, kTextureRows, kReliefRows, kStyleRows,
                               kMarkRows, kPathRows, kJobRows);

template <class Condition>
const OptionInfo& first_row(const std::string& option, Condition is_meant) {
  for (const OptionInfo& row : kTable) {
    if (option.compare(2, option.npos, row.name) == 0 && is_meant(row)) return row;
  }
  throw Error(option + " is no option of this kind");
}

}  // namespace

bool NumberRange::contains(double value) const {
  return std::isfinite(value) && (above_least ? value > least : value >= least) &&
         (below_most ? value < most : value <= most);
}

std::span<const OptionInfo> option_table() { return kTable; }

const OptionInfo* find_option(std::string_view name, PatternJob job) {
  const auto row = ranges::find_if(
      kTable, [&](const OptionInfo& info) { return info.name == name && info.is_for(job); });
  return row == std::end(kTable) ? nullptr : &*row;
}

const OptionInfo& row_of(const std::string& option) {
  return first_row(option, [](const OptionInfo&) { return true; });
}

const OptionInfo& row_of(const std::string& option, OptionKind kind) {
  return first_row(option, [kind](const OptionInfo& row) { return row.kind == kind; });
}

}  // namespace brindle
