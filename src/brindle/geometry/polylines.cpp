#include "brindle/polylines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brindle/base/memory.h"
#include "brindle/base/number_text.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

/// Points are numbered by Index.
constexpr double kMostPoints = 0xfffffff0;

std::string shortest_text(float number) {
  char text[32];
  return {text, write_number(text, text + sizeof text, number).ptr};
}

/// Marks the points to keep between `first` and `last` (Douglas-Peucker). `last` may be the number
/// of points, for the first point of a closed line.
void keep_farthest(std::span<const Vec3> points, std::size_t first, std::size_t last,
                   float tolerance, std::vector<std::uint8_t>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    float farthest = tolerance;
    std::size_t at = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const float d = distance_to_segment(points[i], points[from], points[to % points.size()]);
      if (d > farthest) farthest = d, at = i;
    }
    if (at == 0) continue;
    keep[at] = 1;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
}

std::size_t farthest_from_first(std::span<const Vec3> points) {
  const auto farther = [&](const Vec3& a, const Vec3& b) {
    return (a - points[0]).squaredNorm() < (b - points[0]).squaredNorm();
  };
  return static_cast<std::size_t>(std::max_element(points.begin(), points.end(), farther) -
                                  points.begin());
}

/// Number of steps along a line: at least one, on closed lines three.
double steps_along(double length, double spacing, bool closed) {
  return std::max(std::round(length / spacing), closed ? 3.0 : 1.0);
}

/// The number of points at a spacing.
double points_at(const Polylines& lines, std::span<const double> lengths, double spacing) {
  double points = 0;
  for (std::size_t line = 0; line < lengths.size(); ++line) {
    const bool closed = lines.closed[line];
    points += steps_along(lengths[line], spacing, closed) + (closed ? 0 : 1);
  }
  return points;
}

/// The smallest spacing, to two digits, at which lines have at most `most` points.
std::string smallest_spacing(const Polylines& lines, std::span<const double> lengths, double most) {
  double length = 0;
  for (const double l : lengths) length += l;
  double spacing = length / most;
  // Every line has a minimum number of points, and steps are whole.
  while (spacing < length && points_at(lines, lengths, spacing) > most) spacing *= 1.05;
  if (points_at(lines, lengths, spacing) > most) return "no spacing would do for so many lines";
  return "the smallest spacing that would do is " + rounded_up(spacing);
}

/// The lengths of all lines. Throws TooLarge if memory cannot hold their points at this spacing.
std::vector<double> checked_lengths(const Polylines& lines, float spacing) {
  if (!(spacing > 0)) throw Error("the spacing of points along curves must be above zero");
  std::vector<double> lengths(lines.count());
  for (std::size_t line = 0; line < lengths.size(); ++line) lengths[line] = length_of(lines, line);
  // Includes the memory for writing files.
  constexpr double kBytes = 2 * (sizeof(Vec3) + sizeof(Vec3) + sizeof(TrianglePoint));
  const double points = points_at(lines, lengths, spacing);
  const auto remedy = [&](double most) {
    return smallest_spacing(lines, lengths, std::min(most, kMostPoints));
  };
  const std::string what = "curves with points every " + shortest_text(spacing);
  check_fits(points, kBytes, what, "points", remedy);
  if (points > kMostPoints) {
    throw TooLarge(what + " would be more points than brindle can number; " + remedy(kMostPoints),
                   kMostPoints / points);
  }
  return lengths;
}

}  // namespace

void Polylines::add(const Polylines& lines, std::size_t first, std::size_t end) {
  const auto append = [&](const auto& from, auto& to) {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
    if (!from.empty()) to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(end - first));
  };
  append(lines.points, points);
  append(lines.normals, normals);
  append(lines.places, places);
  append(lines.arrivals, arrivals);
}

TrianglePoint Polylines::place_on(std::size_t point, double share) const {
  TrianglePoint place = places[point];
  for (std::size_t m = 0; m < 3; ++m) {
    place.barycentric[m] += share * (arrivals[point][m] - place.barycentric[m]);
  }
  return place;
}

float distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const float square = along.squaredNorm();
  const float t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0f, 1.0f) : 0.0f;
  return (p - a - t * along).norm();
}

double length_of(const Polylines& lines, std::size_t line) {
  const auto points = lines.points_of(line);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  if (lines.closed[line] && !points.empty()) length += (points.front() - points.back()).norm();
  return length;
}

Polylines simplified(const Polylines& lines, float tolerance, const Progress& progress) {
  JobStages stages(progress, {{"simplify", 1}});
  Reporter reporter(stages.begin("simplify"), lines.points.size());
  Polylines result;
  result.origin = lines.origin;
  std::vector<std::uint8_t> keep;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    reporter.done(points.size());
    keep.assign(points.size(), 0);
    keep.front() = 1;
    if (lines.closed[line]) {
      const std::size_t far = farthest_from_first(points);
      keep[far] = 1;
      keep_farthest(points, 0, far, tolerance, keep);
      keep_farthest(points, far, points.size(), tolerance, keep);
    } else {
      keep.back() = 1;
      keep_farthest(points, 0, points.size() - 1, tolerance, keep);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!keep[i]) continue;
      result.add(points[i], lines.normals_of(line)[i]);
      if (!lines.places.empty()) result.places.push_back(lines.places[lines.offsets[line] + i]);
    }
    result.end_line(lines.closed[line]);
  }
  stages.finish();
  return result;
}

Polylines resampled(const Polylines& lines, float spacing, const Progress& progress) {
  const std::vector<double> lengths = checked_lengths(lines, spacing);
  JobStages stages(progress, {{"resample", 1}});
  Reporter reporter(stages.begin("resample"),
                    static_cast<std::size_t>(points_at(lines, lengths, spacing)));
  Polylines result;
  result.origin = lines.origin;
  const bool placed = !lines.arrivals.empty();
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    const auto normals = lines.normals_of(line);
    const double length = lengths[line];
    const bool closed = lines.closed[line];
    const auto steps = static_cast<std::size_t>(steps_along(length, spacing, closed));
    std::size_t segment = 0;
    double passed = 0;  // length up to the segment's start
    for (std::size_t step = 0; step < steps; ++step) {
      reporter.done(1);
      const double goal = length * static_cast<double>(step) / static_cast<double>(steps);
      const auto end = [&] { return (segment + 1) % points.size(); };
      double size = (points[end()] - points[segment]).norm();
      while (passed + size < goal && segment + 2 < points.size() + closed) {
        passed += size;
        ++segment;
        size = (points[end()] - points[segment]).norm();
      }
      const float t = size > 0 ? static_cast<float>(std::min((goal - passed) / size, 1.0)) : 0.0f;
      const Vec3 normal = (1 - t) * normals[segment] + t * normals[end()];
      result.add(points[segment] + t * (points[end()] - points[segment]),
                 normal.stableNormalized());
      if (placed) result.places.push_back(lines.place_on(lines.offsets[line] + segment, t));
    }
    if (!closed) {
      result.add(points.back(), normals.back());
      if (placed) result.places.push_back(lines.places[lines.offsets[line + 1] - 1]);
    }
    result.end_line(closed);
  }
  stages.finish();
  return result;
}

}  // namespace brindle
