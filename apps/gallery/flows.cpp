#include "gallery/flows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/mesh.h"
#include "brindle/normals.h"
#include "brindle/shapes/parametric_shapes.h"
#include "gallery/hare.h"
#include "gallery/implicit.h"
#include "gallery/items.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

constexpr double kCalm = 0.16;  // within this radius a vortex rotates rigidly
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

ImplicitFunction pebble_function() {
  return blended({ellipsoid({-0.25, 0, 0}, {0.95, 0.8, 0.62}, turned(0, 6, 0)),
                  ellipsoid({0.65, 0.1, 0.12}, {0.62, 0.6, 0.5}),
                  ellipsoid({-0.1, 0.1, 0.35}, {0.5, 0.5, 0.42})},
                 0.07);
}

/// Rotation about an axis, decaying outside the core.
Point whirl(const Point& core, const Point& at, const Point& normal) {
  const Point arm = at - core;
  return normal.cross(arm) / (arm.squaredNorm() + kCalm * kCalm);
}

struct Flow {
  std::vector<Vec3> velocity;
  std::vector<float> speed;

  void add(const Vec3& v) {
    velocity.push_back(v);
    speed.push_back(v.norm());
  }
};

}  // namespace

std::array<Point, 2> vortex_cores(int number) {
  const double turn = 2 * std::numbers::pi * number / kVortexSteps;
  const ImplicitFunction surface = pebble_function();
  const auto on_surface = [&](Point p) {
    for (int k = 0; k < 40; ++k) p -= surface(p) * level_curvature(surface, p, 1e-3).normal;
    return p;
  };
  // Each on its own circle, so that they approach and part.
  return {
      on_surface({1.4, -0.45 + 0.3 * elementary::cos(turn), 0.35 + 0.28 * elementary::sin(turn)}),
      on_surface({0.35 + 0.2 * elementary::sin(turn), -1.3, 0.15 - 0.25 * elementary::cos(turn)})};
}

Mesh vortex_pebble(double detail, const Progress& progress) {
  return isosurface(pebble_function(), {Vec3::Constant(-1.6f), Vec3::Constant(1.6f)},
                    static_cast<float>(0.035 / detail), progress);
}

GalleryFile vortex_step(int number, const Mesh& pebble) {
  GalleryFile file{"", pebble, {}, {}};
  file.name = std::to_string(1000 + number);
  file.name = "step_" + file.name.substr(1) + ".vtp";
  const std::array<Point, 2> cores = vortex_cores(number);
  const std::vector<Vec3> normals = vertex_normals(file.mesh);
  Flow flow;
  std::vector<float> near, core;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Point p = file.mesh.positions[v].cast<double>(), n = normals[v].cast<double>();
    flow.add((whirl(cores[0], p, n) - whirl(cores[1], p, n)).cast<float>());
    near.push_back(static_cast<float>(std::min((p - cores[0]).norm(), (p - cores[1]).norm())));
    core.push_back(kNone);
  }
  for (std::size_t k = 0; k < cores.size(); ++k) {
    Mesh ball = mesh_of(sphere_strips({.radius = 0.07f, .resolution = 8}));
    translate(ball, cores[k].cast<float>());
    for (std::size_t v = 0; v < ball.vertex_count(); ++v) {
      flow.add(Vec3::Zero());
      near.push_back(kNone);
      core.push_back(static_cast<float>(k));
    }
    append(ball, file.mesh);
  }
  file.arrays.points = {make_data_array("velocity", flow.velocity),
                        make_data_array("speed", 1, flow.speed), make_data_array("near", 1, near),
                        make_data_array("core", 1, core)};
  return file;
}

GalleryFile hare_flow(double detail, const Progress& progress) {
  GalleryFile file{"flow.vtp", hare_mesh(static_cast<float>(0.022 / detail), progress), {}, {}};
  const std::vector<Vec3> normals = vertex_normals(file.mesh);
  Flow flow;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 p = 2.1f * file.mesh.positions[v];
    const Vec3 abc(elementary::sin(p.z()) + elementary::cos(p.y()),
                   elementary::sin(p.x()) + elementary::cos(p.z()),
                   elementary::sin(p.y()) + elementary::cos(p.x()));
    flow.add(abc - abc.dot(normals[v]) * normals[v]);
  }
  file.arrays.points = {make_data_array("velocity", flow.velocity),
                        make_data_array("speed", 1, flow.speed)};
  return file;
}

namespace {

std::vector<GalleryFile> make_vortices(double detail, const Progress& progress) {
  const Mesh pebble = vortex_pebble(detail, progress.part(0, 0.5));
  const Progress steps_made = progress.part(0.5, 1);
  std::vector<GalleryFile> steps;
  for (int number = 0; number < kVortexSteps; ++number) {
    steps_made.report(static_cast<double>(number) / kVortexSteps);
    steps.push_back(vortex_step(number, pebble));
  }
  return steps;
}

std::string style_of_vortices(bool moving) {
  return "--field {field=array:velocity} --oriented --stripes 44 "
         "--frequency-by {values=array:speed}@0.7..1.6,inverse "
         "--texture arrows" +
         std::string(moving ? ",flow=1" : "") +
         " --texture-by {values=array:near},regions=0.62,dots@#8fa3b3 "
         "--color-by {own=array:core} --colormap {own=coolwarm} "
         "--legend {own=none} "
         "--colors #243b55,#f2efe8,#ffffff --up z --camera 50,22,0.95";
}

}  // namespace

GalleryItem vortices_item() {
  return {"vortices",
          "arrows around two vortices that move, dots where little happens",
          make_vortices,
          {{"still",
            "one step: arrows near the cores, larger where the flow is faster",
            "stripe {surface=step_000.vtp} " + style_of_vortices(false),
            "760x560",
            {"stripes", "frequency-range", "regions", "texture-shift"}},
           {"flow", "all steps: the cores travel, tiles flow along the field",
            "animate --series {file=step_%03d.vtp} " + style_of_vortices(true), "560x420"}}};
}

}  // namespace brindle
