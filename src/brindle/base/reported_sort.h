/// Sorting that reports: long lists take longer than a caller should wait.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {

/// Comparisons between two reports.
inline constexpr std::size_t kComparedPerReport = 16 * kReportSlice;

/// Sorts as `std::sort` does, comparison by comparison, and `progress` hears how far it is. What
/// was to be sorted is in no order, and may have lost entries, where that throws.
template <class Iterator, class Less>
void reported_sort(Iterator begin, Iterator end, const Progress& progress, const Less& less) {
  if (!progress.is_heard()) {
    ranges::sort(begin, end, less);
    return;
  }
  const auto count = static_cast<double>(std::distance(begin, end));
  const double expected = 1.2 * count * std::log2(std::max(2.0, count));
  std::size_t compared = 0;
  ranges::sort(begin, end, [&](const auto& a, const auto& b) {
    if (++compared % kComparedPerReport == 0) {
      progress.report(std::min(1.0, static_cast<double>(compared) / expected));
    }
    return less(a, b);
  });
}

}  // namespace brindle
