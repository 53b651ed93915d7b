#include "brindle/tool_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/paths/path_order.h"
#include "brindle/paths/segments.h"
#include "brindle/polylines.h"

namespace brindle {
namespace {

// Radii of curves, and curves without tight bends.

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

/// The least radius of all lines: at each point, of the circle through it and the points `reach`
/// before and after it along the line. Infinite for straight lines.
double least_radius_of(const Polylines& lines, float reach) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t line = 0; line < lines.count(); ++line) {
    for (const double radius : radii_of(lines, line, reach)) least = std::min(least, radius);
  }
  return least;
}

/// Lines, cut at the tightest point of each bend below `least_radius`, without those shorter than
/// `least_length` or `cut_length`, or without two points. Counts cuts and lines left out.
Polylines kept_curves(const Polylines& lines, const ToolPathOptions& options,
                      ToolPathMetrics& metrics) {
  const float least_length = std::max(options.least_length, options.cut_length);
  Polylines result;
  result.origin = lines.origin;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    Polylines parts;
    const std::vector<std::size_t> bends =
        options.least_radius > 0 ? tight_bends(radii_of(lines, line, options.width / 2),
                                               static_cast<double>(options.least_radius))
                                 : std::vector<std::size_t>();
    metrics.bends_cut += bends.size();
    add_parts(lines, line, bends, parts);
    for (std::size_t part = 0; part < parts.count(); ++part) {
      const double length = length_of(parts, part);
      if (!(length > 0) || length < static_cast<double>(least_length)) {
        ++metrics.left_out;
        continue;
      }
      result.add(parts, parts.offsets[part], parts.offsets[part + 1]);
      result.end_line(parts.closed[part] != 0);
    }
  }
  return result;
}

void check_options(const Polylines& curves, const ToolPathOptions& options) {
  if (!(options.width > 0) || !std::isfinite(options.width)) {
    throw Error("tool paths: the width must be a finite number above 0");
  }
  for (const float length : {options.connect.value_or(0), options.least_radius,
                             options.least_length, options.cut_length}) {
    if (length >= 0 && std::isfinite(length)) continue;
    throw Error("tool paths: lengths must be finite numbers of 0 or more");
  }
  if (!(options.up.norm() > 0) || !options.up.allFinite()) {
    throw Error("tool paths: the direction that is up must be finite and not zero");
  }
  if (curves.normals.size() != curves.points.size()) {
    throw Error("tool paths: curves need a normal at each point");
  }
  if (options.order == PathOrder::spiral && (curves.count() != 1 || curves.closed[0] != 0)) {
    throw Error("a spiral is one open curve, and there are " + std::to_string(curves.count()) +
                " curves; wind stripes that close around once, without branches");
  }
}

float connect_of(const ToolPathOptions& options) {
  const bool alone = options.least_radius > 0 || options.order == PathOrder::spiral;
  return options.connect.value_or(alone ? 0 : 2 * options.width);
}

double height_of(const Polylines& lines, Index line, const Eigen::Vector3d& up) {
  double sum = 0;
  for (const Vec3& point : lines.points_of(line)) sum += point.cast<double>().dot(up);
  return sum / static_cast<double>(lines.points_of(line).size());
}

/// Lines by mean height; a layer ends half a width above its lowest line.
std::vector<PlacedLine> layered_order(const Polylines& lines, std::span<const Index> all,
                                      const ToolPathOptions& options, const Progress& progress) {
  std::vector<std::pair<double, Index>> heights;
  const Eigen::Vector3d up = options.up.cast<double>().normalized();
  for (const Index line : all) heights.emplace_back(height_of(lines, line, up), line);
  ranges::sort(heights);
  std::vector<PlacedLine> order;
  std::optional<Vec3> from;
  for (auto begin = heights.begin(); begin != heights.end();) {
    progress.report(static_cast<double>(order.size()) / static_cast<double>(all.size()));
    const double top = begin->first + static_cast<double>(options.width) / 2;
    const auto end =
        std::find_if(begin, heights.end(), [&](const auto& h) { return h.first > top; });
    std::vector<Index> layer;
    std::transform(begin, end, std::back_inserter(layer), [](const auto& h) { return h.second; });
    std::vector<PlacedLine> placed = nearest_order(lines, layer, from);
    shorten_travel(lines, placed, from);
    from = end_of(lines, placed.back());
    order.insert(order.end(), placed.begin(), placed.end());
    begin = end;
  }
  return order;
}

std::vector<PlacedLine> order_of(const Polylines& lines, const ToolPathOptions& options,
                                 ToolPathMetrics& metrics, const Progress& progress) {
  std::vector<Index> all(lines.count());
  std::iota(all.begin(), all.end(), Index{0});
  std::vector<PlacedLine> order = nearest_order(lines, all, {}, {}, progress.part(0, 0.2));
  metrics.travel_nearest = travel_of(lines, order);
  switch (options.order) {
    case PathOrder::nearest:
      shorten_travel(lines, order, {}, progress.part(0.2, 1));
      break;
    case PathOrder::boustrophedon: {
      const SegmentSearch search(lines);
      order = nearest_order(lines, all, {},
                            search.lines_beside(2 * options.width, progress.part(0.2, 0.8)),
                            progress.part(0.8, 1));
      break;
    }
    case PathOrder::layers:
      order = layered_order(lines, all, options, progress.part(0.2, 1));
      break;
    case PathOrder::spiral: {
      const Vec3 rise = lines.points.back() - lines.points.front();
      order[0].reversed = rise.dot(options.up) < 0;
      break;
    }
  }
  return order;
}

/// The points of a placed line in the order of travel; a closed one ends where it began.
std::vector<std::size_t> points_of(const Polylines& lines, const PlacedLine& placed) {
  const std::size_t begin = lines.offsets[placed.line], size = lines.points_of(placed.line).size();
  const bool closed = lines.closed[placed.line] != 0;
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < size + closed; ++i) {
    points.push_back(begin + (placed.first + i) % size);
  }
  if (placed.reversed) ranges::reverse(points);
  return points;
}

/// Joins and lines, one path after the other.
class PathBuilder {
 public:
  PathBuilder(const Mesh& mesh, const Polylines& curves, float connect, ToolPaths& paths)
      : curves_(curves), connect_(connect), paths_(paths) {
    paths.lines.origin = curves.origin;
    if (connect > 0 && curves.count() > 1) search_.emplace(mesh, curves);
  }

  void add(const PlacedLine& placed) {
    const std::vector<std::size_t> points = points_of(curves_, placed);
    if (!paths_.lines.points.empty()) join(points.front());
    for (const std::size_t i : points) add_point(curves_.points[i], curves_.normals[i], false);
  }

  void end_path() { paths_.lines.end_line(false); }

 private:
  void add_point(const Vec3& point, const Vec3& normal, bool joined) {
    paths_.lines.add(point, normal);
    paths_.joined.push_back(joined);
  }

  /// Joins the last path to the next one, or ends it.
  void join(std::size_t next) {
    const Vec3 from = paths_.lines.points.back(), to = curves_.points[next];
    const double travel = (to - from).cast<double>().norm();
    const auto way = search_ && travel <= static_cast<double>(connect_)
                         ? search_->way({from, paths_.lines.normals.back()},
                                        {to, curves_.normals[next]}, connect_)
                         : std::nullopt;
    ToolPathMetrics& metrics = paths_.metrics;
    if (!way) {
      metrics.travel += travel;
      return end_path();
    }
    ++metrics.joins;
    paths_.joined.back() = 1;
    Vec3 last = from;
    for (const PathPoint& point : *way) {
      add_point(point.position, point.normal, true);
      metrics.joined_length += (point.position - last).cast<double>().norm();
      last = point.position;
    }
    metrics.joined_length += (to - last).cast<double>().norm();
  }

  const Polylines& curves_;
  float connect_;
  ToolPaths& paths_;
  std::optional<JoinSearch> search_;
};

/// Inserts a point `length` before the end of each path and marks all from there on.
void mark_cuts(float length, ToolPaths& paths) {
  ToolPaths marked;
  const Polylines& lines = paths.lines;
  marked.lines.origin = lines.origin;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    double left = length_of(lines, line) - static_cast<double>(length);
    bool cut = false;
    for (std::size_t i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
      const auto add = [&](const Vec3& point, const Vec3& normal, std::uint8_t joined) {
        marked.lines.add(point, normal);
        marked.joined.push_back(joined);
        marked.cut.push_back(cut);
      };
      cut = cut || left <= 0;
      add(lines.points[i], lines.normals[i], paths.joined[i]);
      if (i + 1 == lines.offsets[line + 1] || cut) continue;
      const double step = (lines.points[i + 1] - lines.points[i]).cast<double>().norm();
      if (left < step) {
        cut = true;
        const auto share = static_cast<float>(left / step);
        add(lines.points[i] + share * (lines.points[i + 1] - lines.points[i]),
            (lines.normals[i] + share * (lines.normals[i + 1] - lines.normals[i])).normalized(),
            paths.joined[i]);
      }
      left -= step;
    }
    marked.lines.end_line(false);
  }
  paths.lines = std::move(marked.lines);
  paths.joined = std::move(marked.joined);
  paths.cut = std::move(marked.cut);
}

/// Central differences in the tangent plane; the neighbour's direction where points coincide.
void set_directions(ToolPaths& paths) {
  const Polylines& lines = paths.lines;
  paths.directions.resize(lines.points.size(), Vec3::Zero());
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const std::size_t begin = lines.offsets[line], last = lines.offsets[line + 1] - 1;
    for (std::size_t i = begin; i <= last; ++i) {
      const auto unit = [&](std::size_t from, std::size_t to) -> Vec3 {
        const Vec3 way = lines.points[to] - lines.points[from];
        return way.stableNormalized();
      };
      const Vec3 sum = (i > begin ? unit(i - 1, i) : Vec3(Vec3::Zero())) +
                       (i < last ? unit(i, i + 1) : Vec3(Vec3::Zero()));
      const Vec3& normal = lines.normals[i];
      const Vec3 tangent = sum - sum.dot(normal) * normal;
      paths.directions[i] = tangent.squaredNorm() > 1e-12f ? tangent.normalized()
                            : i > begin                    ? paths.directions[i - 1]
                                                           : normal.unitOrthogonal();
    }
  }
}

void set_widths(ToolPaths& paths, const Progress& progress) {
  const Polylines& lines = paths.lines;
  const SegmentSearch search(lines);
  paths.widths.assign(lines.points.size(), paths.width);
  parallel_for(lines.points.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (paths.joined[i] != 0) continue;
      const auto [left, right] =
          search.gaps({lines.points[i], lines.normals[i]}, paths.directions[i], 2 * paths.width);
      if (left && right)
        paths.widths[i] = (*left + *right) / 2;
      else if (left || right)
        paths.widths[i] = left ? *left : *right;
    }
  });
}

void measure(const Polylines& curves, ToolPaths& paths) {
  ToolPathMetrics& metrics = paths.metrics;
  for (std::size_t line = 0; line < paths.lines.count(); ++line) {
    metrics.length += length_of(paths.lines, line);
  }
  metrics.least_radius = least_radius_of(curves, paths.width / 2);
  if (paths.widths.empty()) return;
  const auto [least, most] = std::minmax_element(paths.widths.begin(), paths.widths.end());
  metrics.least_width = static_cast<double>(*least);
  metrics.most_width = static_cast<double>(*most);
  metrics.mean_width = std::accumulate(paths.widths.begin(), paths.widths.end(), 0.0) /
                       static_cast<double>(paths.widths.size());
}

}  // namespace

ToolPaths tool_paths(const Mesh& mesh, const Polylines& curves, const ToolPathOptions& options,
                     const Progress& progress) {
  check_options(curves, options);
  JobStages stages(progress, {{"order of paths", 3}, {"joins", 2}, {"widths", 3}});
  const Progress ordering = stages.begin("order of paths");
  ToolPaths paths;
  paths.width = options.width;
  const Polylines kept = kept_curves(curves, options, paths.metrics);
  paths.metrics.curves = kept.count();
  if (kept.count() > 0) {
    const std::vector<PlacedLine> order = order_of(kept, options, paths.metrics, ordering);
    const Progress joining = stages.begin("joins");
    PathBuilder builder(mesh, kept, connect_of(options), paths);
    reported_for(
        order.size(), joining, [&](std::size_t i) { builder.add(order[i]); }, 256);
    builder.end_path();
  }
  if (options.cut_length > 0) mark_cuts(options.cut_length, paths);
  paths.cut.resize(paths.lines.points.size());
  set_directions(paths);
  set_widths(paths, stages.begin("widths"));
  measure(kept, paths);
  stages.finish();
  return paths;
}

std::vector<Eigen::Vector4f> path_poses(const ToolPaths& paths) {
  std::vector<Eigen::Vector4f> poses;
  for (std::size_t i = 0; i < paths.directions.size(); ++i) {
    Eigen::Matrix3f frame;
    const Vec3& z = paths.lines.normals[i];
    frame << paths.directions[i], z.cross(paths.directions[i]), z;
    const Eigen::Quaternionf q(frame);
    const float sign = q.w() < 0 ? -1.0f : 1.0f;
    poses.emplace_back(sign * Eigen::Vector4f(q.w(), q.x(), q.y(), q.z()).normalized());
  }
  return poses;
}

}  // namespace brindle
