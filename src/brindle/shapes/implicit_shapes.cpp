#include "brindle/shapes/implicit_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/random.h"
#include "brindle/shapes/capsules.h"
#include "brindle/shapes/isosurface.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

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

Mesh polygonize(const std::vector<Capsule>& parts, double blend, int resolution,
                const Progress& progress) {
  return capsule_surface(parts, blend, 1.0f / static_cast<float>(resolution), progress);
}

/// Grows vessels from parent to children.
struct VesselGrowth {
  const VesselsShape& shape;
  std::vector<Capsule> vessels;
  std::uint64_t drawn = 0;

  double random(double lower, double upper) {
    return lower + (upper - lower) * random_number(shape.seed, drawn++);
  }

  /// `side` is the normal of the plane of the last split.
  void grow(const Point& from, const Point& direction, const Point& side, double radius,
            double length, int generation) {
    // Murray's law: radius^3 = left^3 + right^3.
    const double share = random(0.4, 0.6);
    const double left = radius * elementary::cbrt(share),
                 right = radius * elementary::cbrt(1 - share);
    const Point to = from + length * direction;
    vessels.push_back({from, to, radius, std::max(left, right)});
    if (generation == 0) return;
    // Successive splits are nearly perpendicular, so that the tree fills space.
    const Point split = Eigen::AngleAxisd(random(1.2, 1.9), direction) * side;
    for (const auto& [child, sign] : {std::pair(left, 1.0), std::pair(right, -1.0)}) {
      // The thinner vessel deviates more.
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

Mesh make_vessels(const VesselsShape& shape, const Progress& progress) {
  VesselGrowth growth{shape, {}};
  growth.grow(Point::Zero(), Point::UnitZ(), Point::UnitX(), shape.radius, 0.85, shape.generations);
  center(growth.vessels);
  return polygonize(growth.vessels, 0.12 * shape.radius, shape.resolution, progress);
}

std::vector<Capsule> molecule_atoms(const MoleculeShape& shape) {
  constexpr std::array<double, 3> kRadii = {0.34, 0.30, 0.24};
  std::vector<Capsule> atoms;
  std::uint64_t drawn = 0;
  const auto random = [&] { return random_number(shape.seed, drawn++); };
  // Prefers positions near the middle.
  const auto clearance = [&](const Point& p) {
    double nearest = 1e30;
    for (const Capsule& atom : atoms) nearest = std::min(nearest, (atom.a - p).norm());
    return nearest - 0.25 * p.norm();
  };
  for (int i = 0; i < shape.atoms; ++i) {
    const double radius = kRadii[static_cast<std::size_t>(random() * 3)];
    Point best = Point::Zero();
    // Of several positions beside random atoms, the one with the most space that is not far out.
    for (int attempt = 0; attempt < 8 && i > 0; ++attempt) {
      const Point& anchor = atoms[static_cast<std::size_t>(random() * i)].a;
      const double z = 2 * random() - 1, turn = 2 * std::numbers::pi * random();
      const double across = std::sqrt(1 - z * z);
      const Point place =
          anchor + 0.42 * Point(across * elementary::cos(turn), across * elementary::sin(turn), z);
      if (attempt == 0 || clearance(place) > clearance(best)) best = place;
    }
    atoms.push_back({best, best, radius, radius});
  }
  center(atoms);
  return atoms;
}

Mesh make_molecule(const MoleculeShape& shape, const Progress& progress) {
  return polygonize(molecule_atoms(shape), 0.5 * shape.blend, shape.resolution, progress);
}

Mesh make_box(const BoxShape& shape, const Progress& progress) {
  const Point half = 0.5 * Point(shape.width, shape.depth, shape.height);
  const double fillet = shape.fillet, hole = shape.hole;
  const auto function = [=](const Point& p) {
    const Point beyond = p.cwiseAbs() - half + Point::Constant(fillet);
    const double block = beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - fillet;
    return hole > 0 ? rounded_maximum(block, hole - p.head<2>().norm(), fillet) : block;
  };
  return isosurface(function, {-half.cast<float>(), half.cast<float>()},
                    1.0f / static_cast<float>(shape.resolution), progress);
}

}  // namespace brindle
