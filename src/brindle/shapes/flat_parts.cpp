#include "brindle/shapes/flat_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// Corners of a face or a hole, counter-clockwise as seen from outside the part.
using Loop = std::vector<Vec3>;

Loop reversed(Loop loop) {
  ranges::reverse(loop);
  return loop;
}

/// The loop in another plane perpendicular to an axis, without rounding.
Loop moved_to(Loop loop, int axis, float place) {
  for (Vec3& corner : loop) corner[axis] = place;
  return loop;
}

/// An arc from a to b, perpendicular vectors as long as the radius.
Loop circle(const Vec3& center, const Vec3& a, const Vec3& b, int corners) {
  Loop loop;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    loop.push_back(center + static_cast<float>(elementary::cos(angle)) * a +
                   static_cast<float>(elementary::sin(angle)) * b);
  }
  return loop;
}

/// Collects the faces of a part. Corners at one position become one vertex.
class FlatPart {
 public:
  /// A face that is star-shaped from its first corner.
  void add_fan(const Loop& rim) {
    for (std::size_t k = 2; k < rim.size(); ++k) add(rim[0], rim[k - 1], rim[k]);
  }

  /// A wall between two loops of equal size, outside a lower one that is counter-clockwise from the
  /// upper one.
  void add_wall(const Loop& lower, const Loop& upper) {
    for (std::size_t k = 0; k < lower.size(); ++k) {
      const std::size_t next = (k + 1) % lower.size();
      add_fan({lower[k], lower[next], upper[next], upper[k]});
    }
  }

  /// A face with a hole whose middle sees all edges. Edges of both loops, merged by direction, each
  /// make a triangle with the current corner of the other loop.
  void add_ring(const Loop& rim, const Loop& hole) {
    std::vector<RingEdge> edges;
    add_edges(rim, hole, 0, edges);
    add_edges(hole, hole, 1, edges);
    ranges::sort(edges.begin(), edges.end(), [](const RingEdge& a, const RingEdge& b) {
      return std::pair(a.direction, a.loop) < std::pair(b.direction, b.loop);
    });
    std::array<Vec3, 2> reached;
    for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) reached[edge->loop] = edge->from;
    for (const RingEdge& edge : edges) {
      const Vec3& other = reached[1 - edge.loop];
      edge.loop == 0 ? add(edge.from, edge.to, other) : add(edge.to, edge.from, other);
      reached[edge.loop] = edge.to;
    }
  }

  Mesh mesh() {
    join_vertices(mesh_);
    drop_unreferenced_vertices(mesh_);
    return std::move(mesh_);
  }

 private:
  struct RingEdge {
    double direction;  ///< of its midpoint from the hole's centre
    std::size_t loop;  ///< 0: the rim, 1: the hole
    Vec3 from, to;
  };

  static void add_edges(const Loop& loop, const Loop& hole, std::size_t number,
                        std::vector<RingEdge>& edges) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (const Vec3& corner : hole)
      center += corner.cast<double>() / static_cast<double>(hole.size());
    const Eigen::Vector3d a = hole[0].cast<double>() - center;
    const Eigen::Vector3d b = a.cross(hole[1].cast<double>() - center).cross(a);
    const auto direction_of = [&](const Vec3& corner) {
      const Eigen::Vector3d way = corner.cast<double>() - center;
      return elementary::atan2(way.dot(b) / b.norm(), way.dot(a) / a.norm());
    };
    constexpr double kTurn = 2 * std::numbers::pi;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec3 &from = loop[k], &to = loop[(k + 1) % loop.size()];
      const double begin = direction_of(from), end = direction_of(to);
      const double middle = (begin + (end < begin ? end + kTurn : end)) / 2;
      edges.push_back({middle < kTurn / 2 ? middle : middle - kTurn, number, from, to});
    }
  }

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const auto first = static_cast<Index>(mesh_.vertex_count());
    mesh_.positions.insert(mesh_.positions.end(), {a, b, c});
    mesh_.triangles.push_back({first, first + 1, first + 2});
  }

  Mesh mesh_;
};

/// A plate of the bracket: its inner face, and the position of its outer face along an axis.
void add_plate(FlatPart& part, const Loop& inner, const Loop& outer, int axis,
               const BracketShape& shape) {
  const Vec3 center = (inner[0] + inner[2]) / 2;
  const Vec3 a = shape.hole * (inner[1] - inner[0]).normalized();
  const Vec3 b = shape.hole * (inner[3] - inner[0]).normalized();
  const Loop hole = circle(center, a, b, 4 * shape.resolution);
  const Loop end = reversed(moved_to(hole, axis, outer[0][axis]));
  part.add_ring(inner, hole);
  part.add_ring(outer, end);
  part.add_wall(hole, reversed(end));
}

}  // namespace

float room_for_hole(const BracketShape& shape) {
  const float side = std::min(shape.length, shape.height) - shape.thickness - shape.fillet;
  return std::min(shape.depth, side) / 2;
}

Mesh make_bracket(const BracketShape& shape) {
  const float left = -shape.length / 2, right = shape.length / 2;
  const float bottom = -shape.height / 2, top = shape.height / 2, back = shape.depth / 2;
  const float x = left + shape.thickness, z = bottom + shape.thickness;
  // From the outer edge on, seen from the front, where y is smallest.
  const Vec3 middle(x + shape.fillet, -back, z + shape.fillet);
  Loop profile = {{left, -back, bottom}, {right, -back, bottom}, {right, -back, z}};
  Loop fillet = {{middle.x(), -back, z}};
  for (int k = 1; k < shape.resolution; ++k) {
    const double angle = std::numbers::pi / 2 * k / shape.resolution;
    fillet.push_back(middle - shape.fillet * Vec3(static_cast<float>(elementary::sin(angle)), 0,
                                                  static_cast<float>(elementary::cos(angle))));
  }
  fillet.push_back({x, -back, middle.z()});
  profile.insert(profile.end(), fillet.begin(), fillet.end());
  profile.insert(profile.end(), {{x, -back, top}, {left, -back, top}});
  const Loop far = moved_to(profile, 1, back);
  const auto side = [&](std::size_t k) -> Loop {
    const std::size_t next = (k + 1) % profile.size();
    return {far[k], far[next], profile[next], profile[k]};
  };
  FlatPart part;
  part.add_fan(profile);
  Loop far_seen = reversed(far);
  std::rotate(far_seen.begin(), far_seen.end() - 1, far_seen.end());
  part.add_fan(far_seen);
  const std::size_t upright = 2 + fillet.size(), last = profile.size() - 1;
  add_plate(part, side(2), side(0), 2, shape);
  add_plate(part, side(upright), side(last), 0, shape);
  for (std::size_t k = 1; k < last; ++k) {
    if (k != 2 && k != upright) part.add_fan(side(k));
  }
  return part.mesh();
}

Mesh make_gear(const GearShape& shape) {
  const float top = shape.width / 2, root = shape.radius - shape.tooth;
  constexpr std::array<double, 4> kOfPitch = {-0.3, -0.15, 0.15, 0.3};
  Loop rim;
  for (int k = 0; k < 4 * shape.teeth; ++k) {
    const double pitches = k / 4 + kOfPitch[k % 4];
    const double angle = 2 * std::numbers::pi * pitches / shape.teeth;
    const float radius = k % 4 == 1 || k % 4 == 2 ? shape.radius : root;
    rim.push_back({radius * static_cast<float>(elementary::cos(angle)),
                   radius * static_cast<float>(elementary::sin(angle)), top});
  }
  const Loop bore =
      circle({0, 0, top}, {shape.bore, 0, 0}, {0, shape.bore, 0}, shape.resolution * shape.teeth);
  const Loop lower_rim = moved_to(rim, 2, -top), lower_bore = moved_to(bore, 2, -top);
  FlatPart part;
  part.add_ring(rim, bore);
  part.add_ring(reversed(lower_rim), reversed(lower_bore));
  part.add_wall(lower_rim, rim);
  part.add_wall(bore, lower_bore);
  return part.mesh();
}

}  // namespace brindle
