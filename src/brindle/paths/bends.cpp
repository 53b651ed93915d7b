#include "brindle/paths/bends.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

namespace brindle {
namespace {

/// A line by its length; a closed one goes round.
class MeasuredLine {
 public:
  MeasuredLine(const Polylines& lines, std::size_t line)
      : points_(lines.points_of(line)), closed_(lines.closed[line] != 0) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 step = points_[(i + 1) % points_.size()] - points_[i];
      lengths_.push_back(lengths_.back() + step.cast<double>().norm());
    }
    if (!closed_) lengths_.pop_back();
  }

  std::size_t size() const { return points_.size(); }

  /// Infinite within `reach` of the ends.
  double radius(std::size_t point, double reach) const {
    constexpr double kStraight = std::numeric_limits<double>::infinity();
    const double at = lengths_[point], all = lengths_.back();
    if (closed_ ? all < 3 * reach : at < reach || all - at < reach) return kStraight;
    const Eigen::Vector3d a = place(at - reach), b = points_[point].cast<double>(),
                          c = place(at + reach);
    const double doubled_area = (b - a).cross(c - a).norm();
    const double sides = (b - a).norm() * (c - b).norm() * (c - a).norm();
    // Rounding of floats bends straight lines a little.
    return doubled_area > 1e-5 * reach * reach ? sides / (2 * doubled_area) : kStraight;
  }

 private:
  Eigen::Vector3d place(double length) const {
    const double all = lengths_.back();
    if (closed_) length -= all * std::floor(length / all);
    const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto i = static_cast<std::size_t>(after - lengths_.begin()) - 1;
    const double step = lengths_[i + 1] - lengths_[i];
    const double share = step > 0 ? (length - lengths_[i]) / step : 0;
    const Eigen::Vector3d from = points_[i].cast<double>();
    return from + share * (points_[(i + 1) % points_.size()].cast<double>() - from);
  }

  std::span<const Vec3> points_;
  bool closed_;
  std::vector<double> lengths_ = {0};  // before each point; the last one of all
};

std::vector<double> radii_of(const Polylines& lines, std::size_t line, float reach) {
  const MeasuredLine measured(lines, line);
  std::vector<double> radii;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    radii.push_back(measured.radius(i, static_cast<double>(reach)));
  }
  return radii;
}

/// The tightest point of each run of points below the least radius.
std::vector<std::size_t> tight_bends(std::span<const double> radii, double least) {
  std::vector<std::size_t> bends;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (radii[i] >= least) continue;
    if (i > 0 && radii[i - 1] < least) {
      if (radii[i] < radii[bends.back()]) bends.back() = i;
    } else {
      bends.push_back(i);
    }
  }
  return bends;
}

/// Points `first` to `last`, beyond the last one from the first one on.
void add_run(const Polylines& lines, std::size_t line, std::size_t first, std::size_t last,
             Polylines& result) {
  const std::size_t size = lines.points_of(line).size();
  for (std::size_t i = first; i <= last; ++i) {
    result.add(lines.points_of(line)[i % size], lines.normals_of(line)[i % size]);
  }
  result.end_line(false);
}

void add_parts(const Polylines& lines, std::size_t line, std::span<const std::size_t> bends,
               Polylines& result) {
  const std::size_t size = lines.points_of(line).size();
  if (bends.empty()) {
    for (std::size_t i = 0; i < size; ++i) {
      result.add(lines.points_of(line)[i], lines.normals_of(line)[i]);
    }
    return result.end_line(lines.closed[line] != 0);
  }
  std::size_t first = lines.closed[line] != 0 ? bends.front() : 0;
  for (const std::size_t bend : bends) {
    if (bend > first) add_run(lines, line, first, bend, result);
    first = bend;
  }
  const std::size_t last = lines.closed[line] != 0 ? bends.front() + size : size - 1;
  if (last > first) add_run(lines, line, first, last, result);
}

}  // namespace

double least_radius_of(const Polylines& lines, float reach) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t line = 0; line < lines.count(); ++line) {
    for (const double radius : radii_of(lines, line, reach)) least = std::min(least, radius);
  }
  return least;
}

Polylines kept_curves(const Polylines& lines, const KeptCurves& kept, ToolPathMetrics& metrics) {
  Polylines result;
  result.origin = lines.origin;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    Polylines parts;
    const std::vector<std::size_t> bends =
        kept.least_radius > 0
            ? tight_bends(radii_of(lines, line, kept.reach), static_cast<double>(kept.least_radius))
            : std::vector<std::size_t>();
    metrics.bends_cut += bends.size();
    add_parts(lines, line, bends, parts);
    for (std::size_t part = 0; part < parts.count(); ++part) {
      const double length = length_of(parts, part);
      if (!(length > 0) || length < static_cast<double>(kept.least_length)) {
        ++metrics.left_out;
        continue;
      }
      result.add(parts, parts.offsets[part], parts.offsets[part + 1]);
      result.end_line(parts.closed[part] != 0);
    }
  }
  return result;
}

}  // namespace brindle
