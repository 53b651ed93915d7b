#include "brindle/shapes/implicit_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/shapes/isosurface.h"
#include "brindle/shapes/random.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

/// A segment whose radius changes linearly from end to end; a sphere if the ends coincide.
struct Capsule {
  Point a, b;
  double radius_a, radius_b;
};

/// The signed distance from a capsule, or a little less, so that it is nowhere steeper than 1.
class CapsuleDistance {
 public:
  explicit CapsuleDistance(const Capsule& c)
      : from_(c.a), axis_(c.b - c.a), radius_(c.radius_a), widening_(c.radius_b - c.radius_a) {
    const double length2 = axis_.squaredNorm();
    if (length2 == 0) return;
    over_length2_ = 1 / length2;
    // Along the axis the slope of the radius comes on top of that of the distance.
    scale_ = 1 / std::sqrt(1 + widening_ * widening_ / length2);
  }

  double operator()(const Point& p) const {
    const Point offset = p - from_;
    const double t = std::clamp(offset.dot(axis_) * over_length2_, 0.0, 1.0);
    return ((offset - t * axis_).norm() - radius_ - t * widening_) * scale_;
  }

 private:
  Point from_, axis_;
  double radius_, widening_;
  double over_length2_ = 0, scale_ = 1;
};

/// The smooth minimum of the distances to all capsules, with blends of about radius `blend`.
class Union {
 public:
  Union(const std::vector<Capsule>& parts, double blend)
      : parts_(parts.begin(), parts.end()), blend_(blend) {}

  double operator()(const Point& p) const {
    constexpr double kNegligible = 20;  // exp(-20) is below the accuracy of a float position
    double nearest = 1e30, sum = 0;
    for (const CapsuleDistance& part : parts_) {
      const double d = part(p);
      if (d > nearest + kNegligible * blend_) continue;
      if (d < nearest) {
        sum = sum * std::exp((d - nearest) / blend_) + 1;
        nearest = d;
      } else {
        sum += std::exp((nearest - d) / blend_);
      }
    }
    return nearest - blend_ * std::log(sum);
  }

 private:
  std::vector<CapsuleDistance> parts_;
  double blend_;
};

BoundingBox box_around(const std::vector<Capsule>& parts) {
  Point lower = Point::Constant(1e30), upper = -lower;
  for (const Capsule& part : parts) {
    lower = lower.cwiseMin((part.a.array() - part.radius_a).matrix());
    lower = lower.cwiseMin((part.b.array() - part.radius_b).matrix());
    upper = upper.cwiseMax((part.a.array() + part.radius_a).matrix());
    upper = upper.cwiseMax((part.b.array() + part.radius_b).matrix());
  }
  return {lower.cast<float>(), upper.cast<float>()};
}

/// Moves the middle of the box to the origin and scales its longest side to 2.
void center(std::vector<Capsule>& parts) {
  const BoundingBox box = box_around(parts);
  const double scale = 2.0 / (box.upper - box.lower).maxCoeff();
  const Point middle = box.center().cast<double>();
  for (Capsule& part : parts) {
    part.a = scale * (part.a - middle);
    part.b = scale * (part.b - middle);
    part.radius_a *= scale;
    part.radius_b *= scale;
  }
}

Mesh polygonize(const std::vector<Capsule>& parts, double blend, int resolution) {
  BoundingBox box = box_around(parts);
  // The smooth minimum lies below the minimum, by less the fewer parts are equally near.
  const auto margin = static_cast<float>(blend * std::log(static_cast<double>(parts.size()) + 1));
  box.lower.array() -= margin;
  box.upper.array() += margin;
  return isosurface(Union(parts, blend), box, 1.0f / static_cast<float>(resolution));
}

/// Grows vessels from parent to children.
struct VesselGrowth {
  const VesselsShape& shape;
  std::vector<Capsule> vessels;
  std::uint64_t drawn = 0;

  double random(double lower, double upper) {
    return lower + (upper - lower) * random_number(shape.seed, drawn++);
  }

  /// `side` is the normal of the plane in which the last split happened.
  void grow(const Point& from, const Point& direction, const Point& side, double radius,
            double length, int generation) {
    // Murray's law: radius^3 = left^3 + right^3.
    const double share = random(0.4, 0.6);
    const double left = radius * std::cbrt(share), right = radius * std::cbrt(1 - share);
    const Point to = from + length * direction;
    vessels.push_back({from, to, radius, std::max(left, right)});
    if (generation == 0) return;
    // Successive splits are nearly at right angles to each other, so the tree fills space.
    const Point split = Eigen::AngleAxisd(random(1.2, 1.9), direction) * side;
    for (const auto& [child, sign] : {std::pair(left, 1.0), std::pair(right, -1.0)}) {
      // The thinner vessel turns further away.
      const double angle = sign * shape.spread * random(0.85, 1.15) * radius * 0.8 / child;
      const Eigen::AngleAxisd turn(angle, split);
      grow(to, (turn * direction).normalized(), split, child, length * random(0.72, 0.88),
           generation - 1);
    }
  }
};

/// Rounds the edge between two half-spaces: the maximum of two distances, with radius `fillet`.
double rounded_maximum(double a, double b, double fillet) {
  const Eigen::Vector2d outside(std::max(a + fillet, 0.0), std::max(b + fillet, 0.0));
  return std::min(std::max(a + fillet, b + fillet), 0.0) + outside.norm() - fillet;
}

}  // namespace

Mesh make_vessels(const VesselsShape& shape) {
  VesselGrowth growth{shape, {}};
  growth.grow(Point::Zero(), Point::UnitZ(), Point::UnitX(), shape.radius, 0.85, shape.generations);
  center(growth.vessels);
  return polygonize(growth.vessels, 0.12 * shape.radius, shape.resolution);
}

Mesh make_molecule(const MoleculeShape& shape) {
  constexpr std::array<double, 3> kRadii = {0.34, 0.30, 0.24};
  std::vector<Capsule> atoms;
  std::uint64_t drawn = 0;
  const auto random = [&] { return random_number(shape.seed, drawn++); };
  // Prefers places near the middle, too.
  const auto clearance = [&](const Point& p) {
    double nearest = 1e30;
    for (const Capsule& atom : atoms) nearest = std::min(nearest, (atom.a - p).norm());
    return nearest - 0.25 * p.norm();
  };
  for (int i = 0; i < shape.atoms; ++i) {
    const double radius = kRadii[static_cast<std::size_t>(random() * 3)];
    Point best = Point::Zero();
    // Of some places beside any of the atoms, the one with the most room that is not far out.
    for (int attempt = 0; attempt < 8 && i > 0; ++attempt) {
      const Point& anchor = atoms[static_cast<std::size_t>(random() * i)].a;
      const double z = 2 * random() - 1, turn = 2 * std::numbers::pi * random();
      const double across = std::sqrt(1 - z * z);
      const Point place =
          anchor + 0.42 * Point(across * std::cos(turn), across * std::sin(turn), z);
      if (attempt == 0 || clearance(place) > clearance(best)) best = place;
    }
    atoms.push_back({best, best, radius, radius});
  }
  center(atoms);
  return polygonize(atoms, 0.5 * shape.blend, shape.resolution);
}

Mesh make_box(const BoxShape& shape) {
  const Point half = 0.5 * Point(shape.width, shape.depth, shape.height);
  const double fillet = shape.fillet, hole = shape.hole;
  const auto function = [=](const Point& p) {
    const Point beyond = p.cwiseAbs() - half + Point::Constant(fillet);
    const double block = beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - fillet;
    return hole > 0 ? rounded_maximum(block, hole - p.head<2>().norm(), fillet) : block;
  };
  return isosurface(function, {-half.cast<float>(), half.cast<float>()},
                    1.0f / static_cast<float>(shape.resolution));
}

}  // namespace brindle
