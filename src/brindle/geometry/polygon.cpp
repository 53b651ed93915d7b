#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/standard.h"
#include "brindle/geometry/box_tree.h"
#include "brindle/mesh.h"

namespace brindle {
namespace {

constexpr std::size_t kMostClippedPlainly = 1000;
/// Number of corners from which a tree finds those inside an ear.
constexpr std::size_t kLeastInTree = 64;
/// Bounds the cubic time of polygons that cross themselves everywhere.
constexpr std::ptrdiff_t kMostLooksPerCorner = 10000;

using Point = Eigen::Vector3d;

/// A polygon's corners, projected along its mean normal (Newell's method).
struct Outline {
  std::vector<Point> points;
  Point normal = Point::Zero();
  double length = 0;  ///< of the normal: twice the enclosed area
  double noise = 0;   ///< largest shift of a corner by rounding to floats
  double border = 0;  ///< length of all edges

  Outline(std::span<const Vec3> positions, std::span<const Index> corners) {
    for (const Index corner : corners) points.push_back(positions[corner].cast<double>());
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& next = points[(i + 1) % points.size()];
      normal += (points[i] - points[0]).cross(next - points[0]);
      border += (next - points[i]).norm();
      largest = std::max(largest, points[i].cwiseAbs().maxCoeff());
    }
    length = normal.norm();
    noise = 2 * std::numeric_limits<float>::epsilon() * largest;
  }

  /// Twice the signed area of a triangle, times the normal's length.
  double area(const Point& a, const Point& b, const Point& c) const {
    return (b - a).cross(c - a).dot(normal);
  }
  double area(std::size_t a, std::size_t b, std::size_t c) const {
    return area(points[a], points[b], points[c]);
  }

  /// Whether the triangles are complete and do not overlap. Compares absolute areas, since signed
  /// ones add up in any case.
  bool is_covered_by(std::span<const Triangle> triangles) const {
    double covered = 0;
    for (const auto& [a, b, c] : triangles) {
      const Point twice = (points[b] - points[a]).cross(points[c] - points[a]);
      covered += length > 0 ? std::abs(twice.dot(normal)) / length : twice.norm();
    }
    constexpr double kRounding = 1e-6;
    return triangles.size() + 2 == points.size() &&
           !(covered > (1 + kRounding) * length + noise * border);
  }
};

/// Points at which other parts of the polygon may touch an ear.
enum class Contact { none, corners, anywhere };

struct EarRules {
  std::span<const Contact> contacts;  ///< later ones apply if there are no ears otherwise
  double tolerance = 0;               ///< corners within this distance of an edge lie on it
  bool only_flat = true;              ///< without ears, cut only triangles without area
};

/// Ear clipping for polygons that may touch themselves: a polygon with a hole often traverses a
/// bridge to it twice.
///
/// An ear is a convex corner whose triangle lies inside the polygon and is not entered by an edge.
/// Cutting it keeps the winding number of the rest everywhere else. So triangles never overlap
/// while there are ears.
class EarClipper {
 public:
  /// `outline` must outlive this object.
  EarClipper(const Outline& outline, EarRules rules)
      : outline_(outline),
        rules_(rules),
        left_(outline.points.size()),
        looks_(kMostLooksPerCorner * static_cast<std::ptrdiff_t>(left_)),
        next_(left_),
        previous_(left_),
        is_left_(left_, 1),
        is_ear_(left_, 0) {
    for (std::size_t i = 0; i < left_; ++i) {
      next_[i] = static_cast<Index>((i + 1) % left_);
      previous_[next_[i]] = static_cast<Index>(i);
    }
    if (left_ >= kLeastInTree) plant_tree();
  }

  /// Returns all triangles; none if the polygon is found to cross itself, or if no ear is left and
  /// `only_flat` forbids all other cuts.
  std::vector<Triangle> clip() {
    std::vector<Triangle> cut;
    Index at = 1;
    while (left_ > 3) {
      if (ears_ == 0 && looks_ > 0) find_ears();
      if (cut.empty() && rules_.only_flat && crosses_itself()) return {};
      const bool proper = ears_ > 0 && contact_ == rules_.contacts.front();
      const std::optional<Index> corner = ears_ > 0 ? next_ear(at) : forced_cut(at);
      if (!corner) return {};
      const Index before = previous_[*corner], after = next_[*corner];
      cut.push_back({before, *corner, after});
      remove(*corner);
      // A proper cut only affects whether its two neighbours are ears.
      proper ? update_ears({before, after}) : forget_ears();
      // Skips the neighbour, since cutting it next would make a fan of slivers.
      at = next_[after];
    }
    const auto first = static_cast<Index>(ranges::find(is_left_, 1) - is_left_.begin());
    cut.push_back({first, next_[first], previous_[first]});
    return cut;
  }

 private:
  using Ear = std::array<Index, 3>;

  void plant_tree() {
    const Point normal = outline_.normal / outline_.length;
    axes_ = {normal.unitOrthogonal(), normal.cross(normal.unitOrthogonal())};
    tree_.emplace(left_, [&](Index corner) {
      const Vec3 place = flat(corner).cast<float>();
      return BoundingBox{place, place};
    });
  }

  Point flat(Index corner) const {
    const Point& point = outline_.points[corner];
    return {point.dot(axes_[0]), point.dot(axes_[1]), 0};
  }

  void remove(Index corner) {
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
    is_left_[corner] = 0;
    --left_;
    set_ear(corner, false);
  }

  // ----------------------------------------------------------------------------------------------

  void set_ear(Index corner, bool ear) {
    ears_ -= static_cast<std::size_t>(is_ear_[corner]);
    is_ear_[corner] = ear ? 1 : 0;
    ears_ += static_cast<std::size_t>(is_ear_[corner]);
  }

  void update_ears(std::array<Index, 2> corners) {
    for (const Index corner : corners) set_ear(corner, is_ear(corner));
  }

  void forget_ears() {
    std::fill(is_ear_.begin(), is_ear_.end(), char{0});
    ears_ = 0;
  }

  void find_ears() {
    for (const Contact contact : rules_.contacts) {
      contact_ = contact;
      for (Index i = 0; i < next_.size(); ++i) set_ear(i, is_left_[i] != 0 && is_ear(i));
      if (ears_ > 0) return;
    }
  }

  /// Detects most polygons that cross themselves everywhere, which are slow, from a sample of ears.
  bool crosses_itself() {
    constexpr std::size_t kSamples = 64;
    std::size_t count = 0;
    for (Index i = 0; i < next_.size(); ++i) {
      if (is_ear_[i] == 0 || count++ % (1 + ears_ / kSamples) != 0) continue;
      if (turns_round({previous_[i], i, next_[i]}) != 1) return true;
    }
    return false;
  }

  Index next_ear(Index at) const {
    while (is_ear_[at] == 0) at = next_[at];
    return at;
  }

  /// The corner to cut if there are no ears.
  std::optional<Index> forced_cut(Index at) {
    if (!rules_.only_flat) return at;
    if (looks_ <= 0) return std::nullopt;
    looks_ -= static_cast<std::ptrdiff_t>(left_);
    double least = outline_.noise * outline_.border * outline_.length;
    std::optional<Index> best;
    for (std::size_t i = 0; i < left_; ++i, at = next_[at]) {
      const Index before = previous_[at], after = next_[at];
      // Prefers the tip of a spike to a collinear corner, which neighbouring polygons may share.
      const double harm =
          at_one_place(before, after) ? -1 : std::abs(outline_.area(before, at, after));
      if (harm > least || (best && harm == least)) continue;
      least = harm;
      best = at;
    }
    return best;
  }

  // ----------------------------------------------------------------------------------------------

  bool at_one_place(Index a, Index b) const { return outline_.points[a] == outline_.points[b]; }

  /// Side of the edge on which the corner lies: 1 left, -1 right, 0 on its line.
  int side(Index from, Index to, Index corner) const {
    const double area = outline_.area(from, to, corner);
    if (rules_.tolerance > 0) {
      const double width = (outline_.points[to] - outline_.points[from]).norm();
      if (std::abs(area) <= rules_.tolerance * width * outline_.length) return 0;
    }
    return area > 0 ? 1 : area < 0 ? -1 : 0;
  }

  std::array<int, 3> sides(const Ear& ear, Index corner) const {
    return {side(ear[0], ear[1], corner), side(ear[1], ear[2], corner),
            side(ear[2], ear[0], corner)};
  }

  bool is_ear(Index corner) {
    if (--looks_ < 0) return false;
    const Ear ear = {previous_[corner], corner, next_[corner]};
    if (!(outline_.area(ear[0], ear[1], ear[2]) > 0)) return false;
    bool blocked = false, is_doubled = false;
    const auto look = [&](Index other) {
      blocked = --looks_ < 0 || blocks(ear, other);
      is_doubled = is_doubled || runs_back(ear, other);
      return !blocked;
    };
    if (tree_) {
      look_in_tree(ear, look);
    } else {
      for (Index i = next_[ear[2]]; i != ear[0] && look(i);) i = next_[i];
    }
    if (blocked) return false;
    return (contact_ != Contact::anywhere && !is_doubled) || turns_round(ear) == 1;
  }

  /// Whether another corner, or an edge at it, enters the ear's triangle.
  bool blocks(const Ear& ear, Index other) const {
    const std::array<int, 3> here = sides(ear, other);
    if (ranges::find(here, -1) != here.end()) return false;
    const bool at_corner =
        ranges::any_of(ear, [&](Index corner) { return at_one_place(corner, other); });
    if (contact_ == Contact::none || (contact_ == Contact::corners && !at_corner)) return true;
    for (const Index beside : {previous_[other], next_[other]}) {
      const std::array<int, 3> there = sides(ear, beside);
      bool enters = true;
      for (std::size_t i = 0; i < 3; ++i) enters = enters && (here[i] > 0 || there[i] > 0);
      if (enters) return true;
    }
    return false;
  }

  /// Whether the polygon returns along both edges of the ear, which then do not determine the
  /// inside.
  bool runs_back(const Ear& ear, Index other) const {
    return at_one_place(ear[1], other) && at_one_place(ear[0], next_[other]) &&
           at_one_place(ear[2], previous_[other]);
  }

  /// Winding number of the remaining polygon around the ear's centroid, counter-clockwise.
  int turns_round(const Ear& ear) {
    looks_ -= static_cast<std::ptrdiff_t>(left_);
    const std::vector<Point>& points = outline_.points;
    const Point &a = points[ear[0]], &b = points[ear[1]], &c = points[ear[2]];
    const Point middle = (a + b + c) / 3;
    const auto is_above = [&](Index corner) {
      return outline_.area(a, b, points[corner]) > outline_.area(a, b, middle);
    };
    int turns = 0;
    Index from = ear[0];
    do {
      const Index to = next_[from];
      const bool rises = is_above(to);
      const double area = outline_.area(points[from], points[to], middle);
      if (rises != is_above(from) && (rises ? area > 0 : area < 0)) turns += rises ? 1 : -1;
      from = to;
    } while (from != ear[0]);
    return turns;
  }

  /// Calls `look` for corners near the ear until it returns false.
  template <class Look>
  void look_in_tree(const Ear& ear, const Look& look) {
    const std::array<Point, 3> corners = {flat(ear[0]), flat(ear[1]), flat(ear[2])};
    // Boxes are rounded to floats.
    const Point slack = Point::Constant(outline_.noise + rules_.tolerance);
    bool goes_on = true;
    const auto may_meet = [&](const BoundingBox& box, double /*square*/) {
      --looks_;
      const Point lower = box.lower.cast<double>() - slack,
                  upper = box.upper.cast<double>() + slack;
      const Point reach = (upper - lower) / 2;
      for (std::size_t i = 0; i < 3 && goes_on; ++i) {
        const Point edge = corners[(i + 1) % 3] - corners[i];
        const Point from = (lower + upper) / 2 - corners[i];
        const double farthest = std::abs(edge[0]) * reach[1] + std::abs(edge[1]) * reach[0];
        if (edge[0] * from[1] - edge[1] * from[0] + farthest < 0) return false;
      }
      return goes_on;
    };
    tree_->visit((corners[0] + corners[1] + corners[2]) / 3, may_meet, [&](Index other) {
      const bool counts = is_left_[other] != 0 && ranges::find(ear, other) == ear.end();
      goes_on = goes_on && (!counts || look(other));
    });
  }

  const Outline& outline_;
  EarRules rules_;
  std::size_t left_;      ///< corners not yet cut
  std::ptrdiff_t looks_;  ///< remaining budget
  std::vector<Index> next_, previous_;
  std::vector<char> is_left_, is_ear_;
  std::size_t ears_ = 0;  ///< known ears
  Contact contact_ = Contact::none;
  std::optional<BoxTree> tree_;
  std::array<Point, 2> axes_;
};

std::vector<Triangle> cut_quadrangle(const Outline& outline) {
  const auto inner = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return outline.area(a, b, c) > 0 && outline.area(a, c, d) > 0;
  };
  const double first = (outline.points[2] - outline.points[0]).squaredNorm();
  const double second = (outline.points[3] - outline.points[1]).squaredNorm();
  const bool take_second =
      inner(0, 1, 2, 3) ? inner(1, 2, 3, 0) && second < first : inner(1, 2, 3, 0);
  if (take_second) return {{0, 1, 3}, {1, 2, 3}};
  return {{0, 1, 2}, {0, 2, 3}};
}

std::vector<Triangle> cut_fan(std::size_t corners) {
  std::vector<Triangle> fan;
  for (Index i = 2; i < corners; ++i) fan.push_back({0, i - 1, i});
  return fan;
}

/// Fast triangulation that suits most polygons.
std::vector<Triangle> plain_cut(const Outline& outline) {
  const std::size_t corners = outline.points.size();
  if (corners == 4) return cut_quadrangle(outline);
  if (corners > kMostClippedPlainly || !(outline.length > 0)) return cut_fan(corners);
  constexpr std::array kContacts = {Contact::none};
  return EarClipper(outline, {kContacts, 0, false}).clip();
}

/// Triangulation of polygons that touch themselves, and of large ones.
std::vector<Triangle> careful_cut(const Outline& outline, double tolerance) {
  constexpr std::array kContacts = {Contact::corners, Contact::anywhere};
  return EarClipper(outline, {kContacts, tolerance}).clip();
}

}  // namespace

bool triangulate_polygon(std::span<const Vec3> positions, std::span<const Index> corners,
                         std::vector<Triangle>& triangles) {
  if (corners.size() < 3) return true;
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return true;
  }
  const Outline outline(positions, corners);
  std::vector<Triangle> cut = plain_cut(outline);
  bool covered = outline.is_covered_by(cut);
  for (const double tolerance : {0.0, outline.noise}) {
    if (covered || !(outline.length > 0)) break;
    std::vector<Triangle> other = careful_cut(outline, tolerance);
    covered = outline.is_covered_by(other);
    if (covered) cut = std::move(other);
  }
  for (const auto& [a, b, c] : cut) triangles.push_back({corners[a], corners[b], corners[c]});
  return covered;
}

std::string describe(const CrossedPolygons& polygons) {
  if (polygons.count == 0) return "";
  return std::to_string(polygons.count) +
         " polygons cross themselves: their triangles cover more area than they enclose; the first "
         "is number " +
         std::to_string(polygons.first) + ", counted from 0\n";
}

}  // namespace brindle
