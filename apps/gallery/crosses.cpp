#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/mesh.h"
#include "gallery/implicit.h"
#include "gallery/items.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

/// A disc about z between two heights, with rims rounded by `fillet`.
ImplicitFunction rounded_disc(double radius, double lower, double upper, double fillet) {
  const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  return [=](const Point& p) {
    const double across = p.head<2>().norm() - radius + fillet;
    const double along = std::abs(p.z() - middle) - half + fillet;
    const Eigen::Vector2d beyond(std::max(across, 0.0), std::max(along, 0.0));
    return beyond.norm() + std::min(std::max(across, along), 0.0) - fillet;
  };
}

ImplicitFunction endless_bar(const Point& through, const Point& along, double radius) {
  return [=](const Point& p) { return (p - through).cross(along).norm() - radius; };
}

/// A radial wall whose top slants from `high` at radius `from` to 0 at `to`.
ImplicitFunction rib(double angle, double half_width, double from, double to, double high) {
  const Point along(elementary::cos(angle), elementary::sin(angle), 0),
      side(-elementary::sin(angle), elementary::cos(angle), 0);
  const Point slope = Point(high, 0, to - from).normalized();
  return [=](const Point& p) {
    const double out = p.dot(along);
    const double top = (out - to) * slope.x() + p.z() * slope.z();
    return std::max({std::abs(p.dot(side)) - half_width, top, -out, -p.z()});
  };
}

/// A flange with a hub: eight bolt holes in a disc of radius 1, a bore through the hub, four ribs.
Mesh flange_mesh(float edge_length, const Progress& progress) {
  constexpr double kFillet = 0.035, kBlend = 0.022;
  std::vector<ImplicitFunction> bodies = {rounded_disc(1, -0.12, 0.12, kFillet),
                                          rounded_disc(0.42, -0.1, 0.82, kFillet)};
  for (int k = 0; k < 4; ++k) {
    bodies.push_back(rib((k + 0.5) * std::numbers::pi / 2, 0.06, 0.4, 0.86, 0.62));
  }
  ImplicitFunction part = blended(std::move(bodies), kBlend);
  part = without(part, endless_bar(Point::Zero(), Point::UnitZ(), 0.26), 0.015);
  for (int k = 0; k < 4; ++k) {
    const double angle = k * std::numbers::pi / 2;
    for (const double turn : {-0.3, 0.3}) {
      const Point place(0.78 * elementary::cos(angle + turn), 0.78 * elementary::sin(angle + turn),
                        0);
      part = without(part, endless_bar(place, Point::UnitZ(), 0.1), 0.015);
    }
  }
  return isosurface(part, {{-1.05f, -1.05f, -0.2f}, {1.05f, 1.05f, 0.9f}}, edge_length, progress);
}

/// A hollow ball of radius 0.9 with a round window towards each axis.
Mesh windowed_ball_mesh(float edge_length, const Progress& progress) {
  const ImplicitFunction ball = [](const Point& p) { return p.norm() - 0.9; };
  const ImplicitFunction inside = [](const Point& p) { return p.norm() - 0.68; };
  ImplicitFunction part = without(ball, inside, 0.01);
  for (int axis = 0; axis < 3; ++axis) {
    part = without(part, endless_bar(Point::Zero(), Point::Unit(axis), 0.46), 0.02);
  }
  return isosurface(part, {Vec3::Constant(-1.0f), Vec3::Constant(1.0f)}, edge_length, progress);
}

std::vector<GalleryFile> make_parts(double detail, const Progress& progress) {
  const auto edge = static_cast<float>(0.021 / detail);
  GalleryFile file{"parts.vtp", flange_mesh(edge, progress.part(0, 0.6)), {}, {}};
  Mesh ball = windowed_ball_mesh(edge, progress.part(0.6, 1));
  translate(ball, {2.1f, 0.15f, 0.45f});
  append(ball, file.mesh);
  return {std::move(file)};
}

}  // namespace

GalleryItem crosses_item() {
  return {"crosses",
          "a mechanical part and a ball in tiles that look the same turned by 90 degrees",
          make_parts,
          {{"tiles",
            "tiles along a cross field that follows edges and curvature",
            "stripe {surface=parts.vtp} --cross --field {field=curvature} "
            "--feature-anchor 1 --texture checker --stripes 54 "
            "--colors #2f5d73,#f3ede0,#ffffff --up z --camera 0,38,0.98",
            "720x420",
            {"stripes", "texture", "curvature-anchor", "feature-anchor"}}}};
}

}  // namespace brindle
