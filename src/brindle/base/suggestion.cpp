#include "brindle/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <vector>

namespace brindle {
namespace {

constexpr std::size_t kMostEdits = 3;

bool alike(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// How many letters are put in, left out, replaced or swapped to make one word of the other.
std::size_t edits(std::string_view from, std::string_view to) {
  // Rows of the table of distances between beginnings: two before, one before, this.
  std::array<std::vector<std::size_t>, 3> rows;
  for (auto& row : rows) row.resize(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) rows[2][j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    rows[2][0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = rows[1][j - 1] + (alike(from[i - 1], to[j - 1]) ? 0 : 1);
      rows[2][j] = std::min({rows[1][j] + 1, rows[2][j - 1] + 1, replaced});
      const bool swapped =
          i > 1 && j > 1 && alike(from[i - 1], to[j - 2]) && alike(from[i - 2], to[j - 1]);
      if (swapped) rows[2][j] = std::min(rows[2][j], rows[0][j - 2] + 1);
    }
  }
  return rows[2][to.size()];
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> known) {
  std::string best;
  std::size_t fewest = kMostEdits + 1;
  for (const std::string& name : known) {
    // A shorter word is no nearer than the letters that are missing.
    if (word.size() > name.size() + kMostEdits || name.size() > word.size() + kMostEdits) continue;
    const std::size_t allowed = std::max<std::size_t>(1, name.size() / 3);
    const std::size_t distance = edits(word, name);
    if (distance > allowed || distance >= fewest || distance >= name.size()) continue;
    fewest = distance;
    best = name;
  }
  return best;
}

}  // namespace brindle
