#include "brindle/option_table.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brindle/base/ranges.h"
#include "brindle/recipe/job_rows.h"
#include "brindle/recipe/mark_rows.h"
#include "brindle/recipe/solving_rows.h"
#include "brindle/recipe/style_rows.h"
#include "brindle/recipe/texture_rows.h"
#include "brindle/recipe/wave_rows.h"

namespace brindle {
namespace {

template <std::size_t... Sizes>
constexpr auto joined(const OptionInfo (&... parts)[Sizes]) {
  std::array<OptionInfo, (Sizes + ...)> rows;
  auto next = rows.begin();
  ((next = std::copy(std::begin(parts), std::end(parts), next)), ...);
  return rows;
}

constexpr auto kTable =
    joined(kWaveRows, kSolvingRows, kTextureRows, kStyleRows, kMarkRows, kJobRows);

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

}  // namespace brindle
