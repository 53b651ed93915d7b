/// Orders of lines with little travel between them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// A line in an order.
struct PlacedLine {
  Index line = 0;
  bool reversed = false;
  Index first =
      0;  ///< of closed lines: the point, counted in the line, at which they begin and end
};

/// The first and the last point of a placed line.
const Vec3& begin_of(const Polylines& lines, const PlacedLine& placed);
const Vec3& end_of(const Polylines& lines, const PlacedLine& placed);

/// The sum of distances from each line's end to the next one's beginning, and from `start`, if any,
/// to the first one.
double travel_of(const Polylines& lines, std::span<const PlacedLine> order,
                 const std::optional<Vec3>& start = {});

/// For each line, the lines beside it; empty: none.
using LinesBeside = std::vector<std::vector<Index>>;

/// Goes on at the nearest end of the lines left, and at any point of closed ones; with `beside`, at
/// that of the lines beside the last one while any is left. Begins at the end nearest to `start`;
/// without one, at the end farthest from the mean of all ends. `chosen` are numbers of lines, each
/// with a point or more. Of equally near ends, the first one counts.
std::vector<PlacedLine> nearest_order(const Polylines& lines, std::span<const Index> chosen,
                                      const std::optional<Vec3>& start = {},
                                      const LinesBeside& beside = {},
                                      const Progress& progress = {});

/// Shortens the travel of an order, which never grows: reverses and moves runs of lines (2-opt and
/// Or-opt between near ends) and turns closed lines until nothing helps. Up to eight open lines
/// travel the least possible way. The first and the last end are free, but for `start`.
void shorten_travel(const Polylines& lines, std::vector<PlacedLine>& order,
                    const std::optional<Vec3>& start = {}, const Progress& progress = {});

}  // namespace brindle
