// Instant Meshes sorts by a file of Intel's that needs TBB's old tasks. Sorting is no part of what
// is measured beyond preparing, and the order of what is equal stays.
#pragma once

#include <algorithm>
#include <functional>

namespace pss {

template <typename Iterator, typename Less>
void parallel_stable_sort(Iterator begin, Iterator end, Less less) {
  std::stable_sort(begin, end, less);
}

template <typename Iterator>
void parallel_stable_sort(Iterator begin, Iterator end) {
  std::stable_sort(begin, end);
}

}  // namespace pss
