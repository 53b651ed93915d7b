#include "brindle/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/nearest.h"
#include "brindle/relief/relief_bodies.h"
#include "brindle/renderer.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/texture_pattern.h"
#include "brindle/threads.h"
#include "relief/closed_meshes.h"

namespace brindle {
namespace {

/// A surface with a texture, ready for reliefs.
struct Ready {
  Surface surface;
  TexturedMesh coordinates;
  TextureTile tile;
  BrokenTiles broken;
  float spacing = 0;

  ReliefTexture texture() const {
    return {coordinates, [this](float u, float v) { return tile_height(tile, u, v); }, &broken,
            tile_detail(tile)};
  }
  Relief relief(const ReliefOptions& options) const {
    return make_relief(surface, texture(), options);
  }
  float area() const {
    double sum = 0;
    for (const Triangle& t : surface.mesh.triangles) sum += triangle_area_of(surface.mesh, t);
    return static_cast<float>(sum);
  }
};

/// With an error that leaves a fourth of the triangles that the usual one needs.
ReliefOptions coarse(float height) { return {.height = height, .tolerance = 0.25f * height}; }

Ready ready(Mesh mesh, float share, BuiltInTile tile) {
  const float spacing = share * bounding_box(mesh).diagonal();
  const Creases creases = split_at_creases(mesh);
  Ready made{make_surface(std::move(mesh), creases), {}, tile, {}, spacing};
  const TexturePattern pattern =
      texture_pattern(made.surface, smooth_direction_field(made.surface), 1 / spacing);
  made.coordinates = texture_coordinates(made.surface, pattern);
  made.broken = broken_tiles(made.surface.mesh.triangles, pattern.waves, tile_motifs(tile));
  return made;
}

const std::map<std::string, float>& shapes_for_reliefs() {
  static const std::map<std::string, float> shapes = {{"sphere,resolution=12", 0.2f},
                                                      {"torus,resolution=40", 0.15f},
                                                      {"trefoil,resolution=10", 0.09f},
                                                      {"bracket", 0.15f},
                                                      {"gear", 0.1f}};
  return shapes;
}

TEST(Relief, IsClosedAndHasTheTopologyOfItsSurface) {
  for (const auto& [shape, share] : shapes_for_reliefs()) {
    for (const BuiltInTile tile : {BuiltInTile::knurl, BuiltInTile::bricks}) {
      SCOPED_TRACE(shape);
      const Ready on = ready(make_shape(shape), share, tile);
      const Relief relief = on.relief(coarse(0.2f * on.spacing));
      EXPECT_TRUE(relief.metrics.closed);
      expect_closed(relief.mesh);
      EXPECT_EQ(euler_number(relief.mesh),
                euler_number(joined_mesh(on.surface.mesh, on.surface.creases)));
      EXPECT_EQ(relief.metrics.bodies, 1u);
      EXPECT_EQ(relief.metrics.intersecting_triangles, 0u);
      EXPECT_GT(relief.metrics.greatest_height, 0.18f * on.spacing);
    }
  }
}

TEST(Relief, AddsTheVolumeBelowTheTexture) {
  for (const auto& [shape, share] : shapes_for_reliefs()) {
    SCOPED_TRACE(shape);
    Ready on = ready(make_shape(shape), share, BuiltInTile::knurl);
    on.broken = {};
    const float height = 0.1f * on.spacing;
    const ReliefMetrics metrics = on.relief({.height = height}).metrics;
    EXPECT_NEAR(metrics.volume_before, volume_of(on.surface.mesh), 1e-3 * metrics.volume_before);
    // A pyramid has a third of the volume of its box. Edges and branches differ.
    const double added = on.area() * height / 3;
    EXPECT_NEAR(metrics.volume - metrics.volume_before, added, 0.15 * added);
    EXPECT_NEAR(metrics.area, on.area(), 1e-3 * on.area());
  }
}

/// The same texture on a moved surface.
Ready moved(const Ready& on, const Eigen::Affine3f& motion, bool flipped) {
  Ready result = on;
  Mesh mesh = on.surface.mesh;
  for (Mesh* moved : {&mesh, &result.coordinates.mesh}) {
    for (Vec3& p : moved->positions) p = motion * p;
    for (Triangle& t : moved->triangles) {
      if (flipped) std::swap(t[1], t[2]);
    }
  }
  result.surface = make_surface(std::move(mesh), on.surface.creases);
  result.spacing *= std::cbrt(motion.linear().determinant());
  return result;
}

TEST(Relief, DependsNeitherOnPlaceNorScaleNorWinding) {
  Ready on = ready(make_shape("bracket"), 0.12f, BuiltInTile::bricks);
  on.broken = {};
  const Eigen::Affine3f turn(Eigen::Translation3f(1, -2, 0.5f) *
                             Eigen::AngleAxisf(0.7f, Vec3(1, 2, 3).normalized()));
  const Eigen::Affine3f larger(Eigen::Scaling(4.0f));
  const ReliefMetrics first = on.relief(coarse(0.2f * on.spacing)).metrics;
  for (const auto& [motion, flipped] : {std::pair(turn, false), {larger, false}, {turn, true}}) {
    const Ready other = moved(on, motion, flipped);
    const ReliefMetrics metrics = other.relief(coarse(0.2f * other.spacing)).metrics;
    const double scale = motion.linear().determinant();
    EXPECT_NEAR(metrics.volume, scale * first.volume, 1e-3 * scale * first.volume);
    const auto triangles = static_cast<double>(first.refined_triangles);
    EXPECT_NEAR(static_cast<double>(metrics.refined_triangles), triangles, 0.05 * triangles);
    EXPECT_EQ(metrics.intersecting_triangles, 0u);
  }
}

TEST(Relief, IsTheSameForAnyNumberOfThreads) {
  const Ready on = ready(make_shape("bracket"), 0.12f, BuiltInTile::bricks);
  std::optional<Relief> first;
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    Relief relief = on.relief(coarse(0.2f * on.spacing));
    if (first) {
      EXPECT_EQ(relief.mesh.positions, first->mesh.positions);
      EXPECT_EQ(relief.mesh.triangles, first->mesh.triangles);
    }
    first = std::move(relief);
  }
}

TEST(Relief, ReachesTheHeightWithinTheTolerance) {
  for (const BuiltInTile tile :
       {BuiltInTile::knurl, BuiltInTile::bricks, BuiltInTile::weave, BuiltInTile::scales}) {
    Ready on = ready(make_shape("plane,resolution=8"), 0.25f, tile);
    on.broken = {};
    const float height = 0.2f * on.spacing, tolerance = 0.1f * height;
    const Relief relief = on.relief({.height = height, .tolerance = tolerance});
    const NearestOnMesh nearest(relief.mesh);
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> number(0.05f, 0.9f);
    for (std::size_t t = 0; t < on.coordinates.mesh.triangle_count(); ++t) {
      const Triangle& c = on.coordinates.mesh.triangles[t];
      const float a = number(engine), b = (1 - a) * number(engine);
      const auto mixed = [&](const auto& of) {
        return (a * of[c[0]] + b * of[c[1]] + (1 - a - b) * of[c[2]]).eval();
      };
      const Eigen::Vector2f uv = mixed(on.coordinates.coordinates);
      const Vec3 place = mixed(on.coordinates.mesh.positions) +
                         Vec3(0, 0, height * tile_height(tile, uv.x(), uv.y()));
      const double distance = nearest.nearest(place.cast<double>())->distance;
      ASSERT_LE(distance, tolerance) << static_cast<int>(tile) << ' ' << uv.transpose();
    }
  }
}

TEST(Relief, KeepsFlatFacesAsTheyAre) {
  const Ready on = ready(make_shape("bracket"), 0.12f, BuiltInTile::weave);
  ReliefOptions options{.height = 0.2f * on.spacing, .only = flat_faces(on.surface, on.spacing)};
  const auto flat = options.only;
  EXPECT_GT(std::count(flat.begin(), flat.end(), 1), 10);
  EXPECT_GT(std::count(flat.begin(), flat.end(), 0), 10);  // the holes and the fillet
  for (std::uint8_t& face : options.only) face = face != 0 ? 0 : 1;
  const Relief relief = on.relief(options);
  expect_closed(relief.mesh);
  std::set<std::array<std::array<float, 3>, 3>> triangles;
  const auto key = [](const Mesh& mesh, const Triangle& t) {
    std::array<std::array<float, 3>, 3> corners;
    for (int m = 0; m < 3; ++m) {
      const Vec3& p = mesh.positions[t[m]];
      corners[m] = {p.x(), p.y(), p.z()};
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (const Triangle& t : relief.mesh.triangles) triangles.insert(key(relief.mesh, t));
  for (std::size_t t = 0; t < flat.size(); ++t) {
    if (flat[t] == 0) continue;
    EXPECT_TRUE(triangles.contains(key(on.surface.mesh, on.surface.mesh.triangles[t]))) << t;
  }
  EXPECT_GT(relief.metrics.volume, relief.metrics.volume_before);
}

TEST(Relief, MovesCreasesToWhereTheFacesMeet) {
  // All of a box rises by the same height: it is a larger box.
  Ready on = ready(make_shape("bracket,fillet=0.01,hole=0.05"), 0.1f, BuiltInTile::knurl);
  ReliefTexture texture = on.texture();
  texture.height = [](float, float) { return 1.0f; };
  texture.broken = nullptr;
  const Relief relief = make_relief(on.surface, texture, {.height = 0.02f});
  const BoundingBox before = bounding_box(on.surface.mesh), after = bounding_box(relief.mesh);
  EXPECT_TRUE(after.upper.isApprox(before.upper + Vec3::Constant(0.02f), 1e-3f));
  EXPECT_TRUE(after.lower.isApprox(before.lower - Vec3::Constant(0.02f), 1e-3f));
}

TEST(Relief, IsLowerWhereItWouldMeetItself) {
  Ready on = ready(make_shape("gear"), 0.12f, BuiltInTile::checker);
  on.broken = {};                                  // tiles in all gaps
  const Relief relief = on.relief(coarse(0.12f));  // gaps between teeth are as wide
  expect_closed(relief.mesh);
  EXPECT_EQ(relief.metrics.intersecting_triangles, 0u);
  EXPECT_GT(relief.metrics.limited_area, 0.02 * relief.metrics.area);
  EXPECT_LT(relief.metrics.limited_area, 0.9 * relief.metrics.area);
  EXPECT_EQ(on.relief(coarse(0.02f)).metrics.intersecting_triangles, 0u);
}

TEST(Relief, OfAnOpenSurfaceKeepsItsBoundary) {
  const Ready on = ready(make_shape("hemisphere,resolution=20"), 0.1f, BuiltInTile::dots);
  const Relief relief = on.relief({.height = 0.2f * on.spacing});
  EXPECT_FALSE(relief.metrics.closed);
  EXPECT_EQ(boundary_edges(relief.mesh) > 0, true);
}

/// A sphere without some of its triangles.
Mesh sphere_with_holes() {
  Mesh mesh = make_shape("sphere,resolution=12");
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const auto is_in = [&](Index v) {
      const Vec3& p = mesh.positions[v];
      return p.z() < -0.8f || (p - Vec3::UnitX()).norm() < 0.2f;
    };
    return std::all_of(t.begin(), t.end(), is_in);
  });
  drop_unreferenced_vertices(mesh);
  return mesh;
}

TEST(Relief, FillsHolesUpToAPerimeter) {
  const Ready on = ready(sphere_with_holes(), 0.12f, BuiltInTile::bricks);
  const auto make = [&](float largest) {
    return on.relief({.height = 0.1f * on.spacing, .fill_holes = largest});
  };
  const ReliefMetrics none = make(0).metrics, small = make(2).metrics;
  EXPECT_EQ(none.filled_holes, 0u);
  EXPECT_FALSE(none.closed);
  EXPECT_EQ(small.filled_holes, 1u);
  EXPECT_FALSE(small.closed);
  const Relief both = make(10);
  EXPECT_EQ(both.metrics.filled_holes, 2u);
  expect_closed(both.mesh);
  EXPECT_EQ(both.metrics.intersecting_triangles, 0u);
  EXPECT_NEAR(both.metrics.area, on.area(), 1e-3 * on.area());
  // A cap of height h has the volume pi h^2 (1 - h / 3).
  const double cap = std::numbers::pi * 0.2 * 0.2 * (1 - 0.2 / 3);
  EXPECT_NEAR(both.metrics.volume_before, 4 * std::numbers::pi / 3 - cap, 0.1);
}

TEST(Relief, InlaysAreClosedBodies) {
  const Ready on = ready(make_shape("sphere,resolution=12"), 0.12f, BuiltInTile::dots);
  const float height = 0.05f, depth = 0.1f;
  const Relief relief = on.relief({.kind = ReliefKind::inlay, .height = height, .depth = depth});
  expect_closed(relief.mesh);
  EXPECT_EQ(relief.metrics.intersecting_triangles, 0u);
  EXPECT_GT(relief.metrics.bodies, 20u);
  EXPECT_EQ(euler_number(relief.mesh), 2 * static_cast<int>(relief.metrics.bodies));
  // Height 1/2 is half a flank inside the outline of a dot.
  const double share = std::numbers::pi * 0.27 * 0.27;
  EXPECT_NEAR(relief.metrics.volume, share * on.area() * (height + depth),
              0.25 * share * on.area() * (height + depth));
}

TEST(Relief, CutShellsHaveSlots) {
  const Ready on = ready(make_shape("tube,resolution=40"), 0.1f, BuiltInTile::dots);
  const Relief relief = on.relief({.kind = ReliefKind::cut, .height = 0.02f});
  expect_closed(relief.mesh);
  EXPECT_EQ(relief.metrics.bodies, 1u);
  EXPECT_LT(euler_number(relief.mesh), -40);  // a handle for each slot
  EXPECT_LT(relief.metrics.volume, 0.85 * 0.02 * on.area());
}

TEST(Relief, ChoosesFaces) {
  const Surface surface = make_surface(make_shape("sphere,resolution=12"));
  const auto count = [&](const ReliefFaces& faces) {
    const auto chosen = chosen_faces(surface, faces);
    return static_cast<double>(std::count(chosen.begin(), chosen.end(), 1)) /
           static_cast<double>(chosen.size());
  };
  EXPECT_EQ(count({}), 1);
  EXPECT_NEAR(count({.towards = {0, 0, 3}, .degrees = 60}), 0.25, 0.03);
  std::vector<float> weights;
  for (const Vec3& p : surface.mesh.positions) weights.push_back(p.x() > 0 ? 0.6f : 0.4f);
  EXPECT_NEAR(count({.weights = weights}), 0.5, 0.1);
  EXPECT_NEAR(count({.towards = {0, 0, 1}, .degrees = 90, .weights = weights}), 0.25, 0.05);
  EXPECT_THROW(count({.towards = {0, 0, 1}, .degrees = 0}), Error);
  EXPECT_THROW(count({.towards = {0, 0, 1}, .degrees = 200}), Error);
}

TEST(Relief, RefusesWhatHasNoInside) {
  const auto why = [](const std::string& shape, ReliefOptions options, bool other = false) {
    const Ready on = ready(make_shape(shape), 0.2f, BuiltInTile::dots);
    ReliefTexture texture = on.texture();
    const Ready second = ready(make_shape("torus,resolution=30"), 0.2f, BuiltInTile::dots);
    if (other) options.only.assign(3, 1);
    try {
      make_relief(on.surface, texture, options);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string sphere = "sphere,resolution=4";
  EXPECT_EQ(why(sphere, {.height = 0.01f}), "");
  EXPECT_NE(why(sphere, {.height = 0}).find("height"), std::string::npos);
  EXPECT_NE(why(sphere, {.height = std::nanf("")}).find("height"), std::string::npos);
  EXPECT_NE(why(sphere, {.height = 1, .depth = 1}).find("depth"), std::string::npos);
  EXPECT_NE(why(sphere, {.height = 1, .tolerance = -1}).find("tolerance"), std::string::npos);
  EXPECT_NE(why(sphere, {.kind = ReliefKind::cut, .height = 1, .fill_holes = 1}).find("holes"),
            std::string::npos);
  EXPECT_NE(why(sphere, {.height = 1}, true).find("another surface"), std::string::npos);
  EXPECT_NE(why("sheets,resolution=4", {.height = 0.1f}).find("edges of one or two"),
            std::string::npos);
  EXPECT_NE(why("mobius,resolution=4", {.height = 0.1f}).find("wound alike"), std::string::npos);
}

TEST(Relief, IsCancelled) {
  const Ready on = ready(make_shape("sphere,resolution=12"), 0.12f, BuiltInTile::bricks);
  for (const double at : {0.1, 0.5, 0.9}) {
    const Progress progress([&](std::string_view, double fraction) { return fraction < at; });
    EXPECT_THROW(make_relief(on.surface, on.texture(), {.height = 0.02f}, progress), Cancelled);
  }
}

}  // namespace
}  // namespace brindle
