#include "brindle/paths/segments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

BoundingBox box_around(const Vec3& a, const Vec3& b, float margin) {
  const Vec3 more = Vec3::Constant(margin);
  return {a.cwiseMin(b) - more, a.cwiseMax(b) + more};
}

}  // namespace

SegmentSearch::SegmentSearch(const Polylines& lines)
    : lines_(lines),
      segments_([&] {
        std::vector<Segment> segments;
        for (std::size_t l = 0; l < lines.count(); ++l) {
          const auto line = static_cast<Index>(l);
          const Index first = lines.offsets[l], end = lines.offsets[l + 1];
          for (Index i = first; i + 1 < end; ++i) segments.push_back({i, i + 1, line});
          if (lines.closed[l] != 0) segments.push_back({end - 1, first, line});
        }
        return segments;
      }()),
      tree_(tree_of(lines, segments_)) {}

BoxTree SegmentSearch::tree_of(const Polylines& lines, std::span<const Segment> segments) {
  return {segments.size(), [&](Index i) {
            return box_around(lines.points[segments[i].from], lines.points[segments[i].to], 0);
          }};
}

template <class Take>
void SegmentSearch::visit(const BoundingBox& box, const Take& take) const {
  tree_.visit(
      box.center().cast<double>(),
      [&](const BoundingBox& node, double) { return overlap(node, box); },
      [&](Index i) { take(segments_[i]); });
}

/// The plane at right angles to the direction cuts segments at points beside.
SegmentSearch::BothSides SegmentSearch::beside(const PathPoint& at, const Vec3& direction,
                                               float reach) const {
  // Nearer ones are the line itself.
  constexpr float kSelf = 1e-3f;
  const Vec3 side = at.normal.cross(direction);
  BothSides found;
  const auto take = [&](const Segment& segment) {
    const Vec3 from = lines_.points[segment.from] - at.position,
               to = lines_.points[segment.to] - at.position;
    const float along_from = from.dot(direction), along_to = to.dot(direction);
    if ((along_from > 0) == (along_to > 0)) return;
    const Vec3 way = from + along_from / (along_from - along_to) * (to - from);
    const float gap = way.norm(), sideways = way.dot(side);
    if (gap > reach || gap < kSelf * reach || std::abs(sideways) < std::abs(way.dot(at.normal))) {
      return;
    }
    if (lines_.normals[segment.from].dot(at.normal) <= 0) return;
    std::optional<Beside>& nearest = found[sideways > 0 ? 0 : 1];
    if (!nearest || gap < nearest->gap) nearest = Beside{gap, segment.line};
  };
  visit(box_around(at.position - reach * side, at.position + reach * side, reach / 4), take);
  return found;
}

std::array<std::optional<float>, 2> SegmentSearch::gaps(const PathPoint& at, const Vec3& direction,
                                                        float reach) const {
  std::array<std::optional<float>, 2> gaps;
  const BothSides found = beside(at, direction, reach);
  for (std::size_t side = 0; side < 2; ++side) {
    if (found[side]) gaps[side] = found[side]->gap;
  }
  return gaps;
}

LinesBeside SegmentSearch::lines_beside(float reach, const Progress& progress) const {
  constexpr std::size_t kSamples = 32;
  LinesBeside beside_of(lines_.count());
  reported_for(
      lines_.count(), progress,
      [&](std::size_t line) {
        const std::size_t begin = lines_.offsets[line], size = lines_.points_of(line).size();
        const std::size_t step = (size + kSamples - 1) / kSamples;
        for (std::size_t i = begin; i + 1 < begin + size; i += step) {
          const Vec3 direction = (lines_.points[i + 1] - lines_.points[i]).stableNormalized();
          // The middle of a segment: lines beside the very ends would be missed.
          const Vec3 middle = 0.5f * (lines_.points[i + 1] + lines_.points[i]);
          for (const auto& found : beside({middle, lines_.normals[i]}, direction, reach)) {
            if (!found || found->line == line) continue;
            beside_of[line].push_back(found->line);
            beside_of[found->line].push_back(static_cast<Index>(line));
          }
        }
      },
      256);
  for (std::vector<Index>& lines : beside_of) {
    ranges::sort(lines);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  }
  return beside_of;
}

bool SegmentSearch::crossed(const Vec3& a, const Vec3& b, const Vec3& normal, float reach,
                            bool free_begin, bool free_end) const {
  constexpr float kTouch = 1e-4f;
  const Vec3 way = b - a;
  bool found = false;
  visit(box_around(a, b, reach), [&](const Segment& segment) {
    const Vec3 begin = lines_.points[segment.from] - a;
    const Vec3 along = lines_.points[segment.to] - lines_.points[segment.from];
    const float area = way.cross(along).dot(normal);
    if (std::abs(area) <= 1e-6f * way.norm() * along.norm()) return;
    const float on_way = begin.cross(along).dot(normal) / area;
    const float on_line = begin.cross(way).dot(normal) / area;
    if (on_way < (free_begin ? kTouch : -kTouch) || on_way > (free_end ? 1 - kTouch : 1 + kTouch) ||
        on_line < -kTouch || on_line > 1 + kTouch) {
      return;
    }
    found = found || std::abs((begin + on_line * along).dot(normal)) <= reach;
  });
  return found;
}

std::optional<std::vector<PathPoint>> JoinSearch::way(const PathPoint& from, const PathPoint& to,
                                                      float reach) const {
  constexpr int kSteps = 8;
  constexpr float kAside = 0.1f;  // of the length: where a way would pass over a hole
  const Vec3 chord = to.position - from.position;
  const float length = chord.norm();
  std::vector<PathPoint> points;
  if (!(length > 0)) return points;
  for (int step = 1; step < kSteps; ++step) {
    const float share = static_cast<float>(step) / kSteps;
    const Vec3 place = from.position + share * chord;
    const Vec3 normal = (from.normal + share * (to.normal - from.normal)).stableNormalized();
    const auto found = nearest_.nearest(place.cast<double>(), static_cast<double>(length));
    if (!found) return std::nullopt;
    const Vec3 moved = found->position.cast<float>() - place;
    const Vec3 aside = moved - moved.dot(normal) * normal;
    if (aside.norm() > kAside * length) return std::nullopt;
    points.push_back({found->position.cast<float>(), normal});
  }
  PathPoint last = from;
  points.push_back(to);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 normal = (last.normal + points[i].normal).stableNormalized();
    if (segments_.crossed(last.position, points[i].position, normal, reach / 2, i == 0,
                          i + 1 == points.size())) {
      return std::nullopt;
    }
    last = points[i];
  }
  points.pop_back();
  return points;
}

}  // namespace brindle
