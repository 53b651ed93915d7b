#include "brindle/stripe_outlines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/broken_tiles.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/texture_waves.h"
#include "brindle/threads.h"
#include "progress_reports.h"
#include "render/test_drawings.h"

namespace brindle {
namespace {

using namespace test;
using Eigen::Vector2d;

constexpr int kWidth = 240, kHeight = 200;
constexpr CameraView kAhead{
    .azimuth_deg = 0, .elevation_deg = 0, .projection = Projection::orthographic};

StyledSurface styled(const StripedSurface& s, float width = 0.5f) {
  return {.mesh = s.mesh, .strokes = {{.waves = &s.waves, .z = s.z, .width = width}}};
}

Camera camera_of(std::span<const StyledSurface> surfaces, const CameraView& view = kAhead) {
  return framed_camera(framed_points(surfaces), view, kWidth, kHeight);
}

std::vector<Pen> outlines_of(const std::vector<StyledSurface>& surfaces,
                             const CameraView& view = kAhead,
                             std::optional<LightDirection> light = {}) {
  return stripe_outlines(surfaces, camera_of(surfaces, view), {view.up, light}, kWidth, kHeight);
}

/// A path as many short straight lines.
std::vector<Vector2d> flattened(const Stroke& path) {
  constexpr int kPieces = 8;
  std::vector<Vector2d> points;
  for (std::size_t i = 0; i + 3 < path.size(); i += 3) {
    for (int k = 0; k < kPieces; ++k) {
      const double t = static_cast<double>(k) / kPieces, s = 1 - t;
      points.push_back(
          s * s * s * path[i].cast<double>() + 3 * s * s * t * path[i + 1].cast<double>() +
          3 * s * t * t * path[i + 2].cast<double>() + t * t * t * path[i + 3].cast<double>());
    }
  }
  return points;
}

/// Holes count less than nothing.
double area_of(const Pen& pen) {
  double sum = 0;
  for (const Stroke& path : pen.strokes) {
    const std::vector<Vector2d> points = flattened(path);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector2d& a = points[i];
      const Vector2d& b = points[(i + 1) % points.size()];
      sum += a.y() * b.x() - a.x() * b.y();
    }
  }
  return sum / 2;
}

constexpr int kSide = 4;  // samples along the side of a pixel

/// Of each pixel, how many of its samples paths cover, by the rule that they are filled by.
std::vector<int> covered_samples(const Pen& pen) {
  std::vector<std::vector<double>> crossings(std::size_t{kSide} * kHeight);
  for (const Stroke& path : pen.strokes) {
    const std::vector<Vector2d> points = flattened(path);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector2d& a = points[i];
      const Vector2d& b = points[(i + 1) % points.size()];
      const auto row = [](double y) { return static_cast<int>(std::ceil(kSide * y - 0.5)); };
      const auto [first, last] = std::minmax({row(a.y()), row(b.y())});
      for (int r = std::max(first, 0); r < std::min(last, kSide * kHeight); ++r) {
        const double y = (r + 0.5) / kSide;
        crossings[static_cast<std::size_t>(r)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) *
                                                                     (b.x() - a.x()));
      }
    }
  }
  std::vector<int> covered(std::size_t{kWidth} * kHeight);
  for (int r = 0; r < kSide * kHeight; ++r) {
    std::vector<double>& xs = crossings[static_cast<std::size_t>(r)];
    std::sort(xs.begin(), xs.end());
    for (int c = 0; c < kSide * kWidth; ++c) {
      const auto before = std::lower_bound(xs.begin(), xs.end(), (c + 0.5) / kSide) - xs.begin();
      covered[static_cast<std::size_t>(r / kSide * kWidth + c / kSide)] += before % 2 == 1;
    }
  }
  return covered;
}

TEST(StripeOutlines, OfAPlateAreStraightAndInTheirPlaces) {
  // Peaks at a quarter, and so on: stripes of half a period, all within the plate.
  constexpr int kStripes = 6;
  const StripedSurface s = plane_wave(square(3), Vec3::UnitX(), kStripes);
  const std::vector<Pen> pens = outlines_of({styled(s)});
  ASSERT_EQ(pens.size(), 2u);
  EXPECT_EQ(pens[0].name, "surface");
  EXPECT_EQ(pens[1].name, "stripes");
  ASSERT_EQ(pens[0].strokes.size(), 1u);
  ASSERT_EQ(pens[1].strokes.size(), std::size_t{kStripes});
  const auto range = [](const Stroke& path, int axis) {
    std::pair<double, double> result{1e9, -1e9};
    for (const Vector2d& p : flattened(path)) {
      result = {std::min(result.first, p[axis]), std::max(result.second, p[axis])};
    }
    return result;
  };
  constexpr double kPromised = 0.05;
  const auto [left, right] = range(pens[0].strokes[0], 0);
  const auto [top, bottom] = range(pens[0].strokes[0], 1);
  const double side = right - left;
  EXPECT_NEAR(side, 190, 2 * kPromised) << "the square fills the picture but for a margin";
  EXPECT_NEAR(bottom - top, side, 2 * kPromised);
  for (const Stroke& path : pens[1].strokes) {
    const auto [first, last] = range(path, 0);
    EXPECT_NEAR(last - first, 0.5 * side / kStripes, 2 * kPromised);
    EXPECT_NEAR(range(path, 1).first, top, kPromised);
    EXPECT_NEAR(range(path, 1).second, bottom, kPromised);
    // Away from the corners sides are straight, where the wave is a quarter of a period off a peak.
    for (const Eigen::Vector2f& p : path) {
      if (p.y() < top + 1 || p.y() > bottom - 1) continue;
      const double places = 2 * (p.x() - 25.0) / 190 * kStripes;  // in half periods
      EXPECT_NEAR(places, std::round(places), 0.002) << p.transpose();
    }
  }
}

TEST(StripeOutlines, CoverTheirShareOfAPlate) {
  const StripedSurface s = plane_wave(square(5), Vec3(0.6f, 0.8f, 0), 15);
  for (const float width : {0.15f, 0.5f, 0.8f}) {
    const std::vector<Pen> pens = outlines_of({styled(s, width)});
    EXPECT_NEAR(area_of(pens[1]) / area_of(pens[0]), width, 0.01) << width;
  }
}

TEST(StripeOutlines, TurnWithSurfaceAndCamera) {
  const StripedSurface s = random_waves(saddle(6), 8);
  const Eigen::Quaternionf turn =
      Eigen::Quaternionf(Eigen::AngleAxisf(1.1f, Vec3(1, 2, 3).normalized()));
  StripedSurface turned = s;
  for (Vec3& p : turned.mesh.positions) p = turn * p + Vec3(2, -1, 3);
  turned.waves.positions = turned.mesh.positions;
  for (Vec3& d : turned.waves.directions) d = turn * d;
  CameraView view{.azimuth_deg = 40, .elevation_deg = 50};
  const Eigen::Quaternionf rotation = rotation_of(view);
  view.rotation = rotation;
  const std::vector<Pen> pens = outlines_of({styled(s)}, view);
  view.rotation = rotation * turn.conjugate();
  const std::vector<Pen> others = outlines_of({styled(turned)}, view);
  ASSERT_EQ(pens.size(), others.size());
  for (std::size_t i = 0; i < pens.size(); ++i) {
    EXPECT_NEAR(area_of(pens[i]) / area_of(others[i]), 1, 1e-3);
  }
}

TEST(StripeOutlines, EndWhereSomethingIsInFront) {
  const StripedSurface back = plane_wave(square(4), Vec3::UnitX(), 8);
  Mesh small = square(1);
  for (Vec3& p : small.positions) p = Vec3(0.25f + 0.5f * p.x(), 0.25f + 0.5f * p.y(), 0.1f);
  const std::vector<StyledSurface> alone = {styled(back)};
  const std::vector<StyledSurface> both = {styled(back), {.mesh = small}};
  const Camera camera = camera_of(alone);
  const auto pens = [&](const std::vector<StyledSurface>& surfaces) {
    return stripe_outlines(surfaces, camera, {UpAxis::y}, kWidth, kHeight);
  };
  const std::vector<Pen> all = pens(alone), clipped = pens(both);
  ASSERT_EQ(clipped.size(), 3u);
  EXPECT_EQ(clipped[0].name, "surface_1");
  EXPECT_NEAR(area_of(clipped[0]) / area_of(all[0]), 0.25, 2e-3);
  EXPECT_NEAR(area_of(clipped[1]) / area_of(all[0]), 0.75, 2e-3);
  EXPECT_NEAR(area_of(clipped[2]) / area_of(all[1]), 0.75, 2e-3);
}

/// The share of pixels of the surface that paths and the renderer show in another colour. Marks are
/// white.
double differing_share(StyledSurface surface, const CameraView& view,
                       std::optional<LightDirection> light_from = {}) {
  Studio& studio = Studio::shared();
  static StyledRenderer renderer;
  surface.shading = false;
  surface.color = {0, 0, 0};
  StyledOptions options;
  options.render = plain_options(kWidth, kHeight);
  options.render.camera = view;
  options.render.light_from = light_from;
  renderer.upload({&surface, 1});
  const Image image = renderer.draw(options);
  studio.context.check_errors("drawing the test picture");
  const std::vector<Pen> pens = outlines_of({surface}, view, light_from);
  std::vector<int> covered = covered_samples(pens[1]);
  for (std::size_t pen = 2; pen < pens.size(); ++pen) {
    const std::vector<int> more = covered_samples(pens[pen]);
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] += more[i];
  }
  int differing = 0, stripes = 0;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const double share = covered[i] / static_cast<double>(kSide * kSide);
    const Pixel& pixel = image.pixels[i];
    const double light = linear_light({static_cast<float>(pixel.red) / 255, 0, 0})[0];
    stripes += share > 0.5;
    differing += std::abs(share - light * pixel.alpha / 255) > 0.5;
  }
  EXPECT_GT(stripes, kWidth * kHeight / 40);
  return static_cast<double>(differing) / (kWidth * kHeight);
}

double differing_share(const StripedSurface& s, const CameraView& view,
                       const std::function<void(Strokes&)>& change,
                       std::optional<LightDirection> light = {}) {
  StyledSurface surface = styled(s);
  surface.strokes[0].color = {1, 1, 1};
  change(surface.strokes[0]);
  return differing_share(surface, view, light);
}

/// Tiles along two waves on one mesh, white.
struct TiledSurface {
  Mesh mesh;
  TextureWaves waves;

  TiledSurface(const StripedSurface& u, const StripedSurface& v)
      : mesh(u.mesh), waves(texture_waves(mesh.triangles, u.waves, u.z, v.waves, v.z)) {
    orient_corners(waves);
  }

  StyledSurface styled(std::vector<RegionTile> tiles) const {
    for (RegionTile& tile : tiles) tile.color = {1, 1, 1};
    StyledSurface surface{.mesh = mesh};
    surface.texture = RegionTexture{.waves = &waves, .tiles = std::move(tiles)};
    return surface;
  }
};

TEST(StripeOutlines, OfTilesHaveTheirShareOfAPlate) {
  const Mesh plate = square(3);
  const TiledSurface tiled(plane_wave(plate, Vec3::UnitX(), 6),
                           plane_wave(plate, Vec3::UnitY(), 6));
  const auto share = [&](BuiltInTile tile) {
    const std::vector<Pen> pens = outlines_of({tiled.styled({{.tile = tile}})});
    EXPECT_EQ(pens.size(), 2u);
    EXPECT_EQ(pens[1].name, "tiles");
    EXPECT_EQ(pens[1].color.red, 1);
    return area_of(pens[1]) / area_of(pens[0]);
  };
  EXPECT_NEAR(share(BuiltInTile::dots), std::numbers::pi * 0.29 * 0.29, 2e-3);
  EXPECT_NEAR(share(BuiltInTile::minus), 4 * 0.25 * 0.07, 2e-3);
  EXPECT_NEAR(share(BuiltInTile::checker), 0.5, 5e-3);
}

TEST(StripeOutlines, OfTilesOfRegionsHaveAPenEach) {
  const Mesh plate = square(8);
  const TiledSurface tiled(plane_wave(plate, Vec3::UnitX(), 8),
                           plane_wave(plate, Vec3::UnitY(), 8));
  std::vector<float> values;
  for (const Vec3& p : plate.positions) values.push_back(p.x());
  StyledSurface surface =
      tiled.styled({{.tile = BuiltInTile::dots}, {.tile = BuiltInTile::minus, .from = 0.5f}});
  surface.texture->values = values;
  const std::vector<Pen> pens = outlines_of({surface});
  ASSERT_EQ(pens.size(), 3u);
  EXPECT_EQ(pens[2].name, "tiles2");
  EXPECT_NEAR(area_of(pens[1]) / area_of(pens[0]), 0.5 * std::numbers::pi * 0.29 * 0.29, 0.02);
  EXPECT_NEAR(area_of(pens[2]) / area_of(pens[0]), 0.5 * 4 * 0.25 * 0.07, 0.006);
}

TEST(StripeOutlines, OfTilesAreThoseOfPictures) {
  const CameraView view{.azimuth_deg = 30, .elevation_deg = 35};
  const TiledSurface plain(plane_wave(saddle(12), Vec3(0.6f, 0.8f, 0), 9),
                           plane_wave(saddle(12), Vec3(-0.8f, 0.6f, 0), 9));
  // Branches and singularities all over.
  const TiledSurface torn(random_waves(saddle(5), 6), random_waves(saddle(5), 7));
  for (const BuiltInTile tile : {BuiltInTile::stripes, BuiltInTile::checker, BuiltInTile::dots,
                                 BuiltInTile::arrows, BuiltInTile::bricks, BuiltInTile::hatch,
                                 BuiltInTile::plus, BuiltInTile::minus, BuiltInTile::plus_minus}) {
    EXPECT_LT(differing_share(plain.styled({{.tile = tile}}), view), 0.004);
    EXPECT_LT(differing_share(torn.styled({{.tile = tile}}), view), 0.02);
  }
  std::vector<float> rising;
  for (const Vec3& p : plain.mesh.positions) rising.push_back(0.2f + 0.8f * p.x());
  StyledSurface regions =
      plain.styled({{.tile = BuiltInTile::dots}, {.tile = BuiltInTile::arrows, .from = 0.6f}});
  regions.texture->values = rising;
  regions.texture->shift = {0.3f, 0.1f};
  EXPECT_LT(differing_share(regions, view), 0.004);
  StyledSurface decals = plain.styled({{.tile = BuiltInTile::checker}});
  decals.texture->sizes = rising;
  EXPECT_LT(differing_share(decals, view), 0.004);
}

TEST(StripeOutlines, LeaveOutBrokenTilesAsPicturesDo) {
  const CameraView view{.azimuth_deg = 30, .elevation_deg = 35};
  // A branch of U in the middle.
  StripedSurface u = plane_wave(saddle(16), Vec3::UnitX(), 8);
  for (std::size_t i = 0; i < u.z.size(); ++i) {
    const Vec3& p = u.mesh.positions[i];
    const Complex away(p.x() - 0.51f, p.y() - 0.47f);
    u.z[i] *= away / std::abs(away);
  }
  const TiledSurface tiled(u, plane_wave(saddle(16), Vec3::UnitY(), 8));
  const BrokenTileFinder finder(tiled.mesh.triangles);
  for (const BuiltInTile tile : {BuiltInTile::dots, BuiltInTile::bricks, BuiltInTile::arrows}) {
    const BrokenTiles broken = finder.find(tiled.waves, tile_motifs(tile));
    const StyledSurface cut = tiled.styled({{.tile = tile}});
    const StyledSurface whole = tiled.styled({{.tile = tile, .broken = &broken}});
    EXPECT_LT(area_of(outlines_of({whole}, view)[1]), area_of(outlines_of({cut}, view)[1]));
    EXPECT_LT(differing_share(whole, view), 0.004);
  }
}

TEST(StripeOutlines, AreThoseOfPictures) {
  const CameraView view{.azimuth_deg = 30, .elevation_deg = 35};
  const auto nothing = [](Strokes&) {};
  const StripedSurface plane = plane_wave(saddle(12), Vec3(0.6f, 0.8f, 0), 12);
  const StripedSurface torus = plane_wave(make_shape("torus,resolution=24"), Vec3::UnitY(), 6);
  EXPECT_LT(differing_share(plane, view, nothing), 0.002);
  EXPECT_LT(differing_share(torus, view, nothing), 0.002);
  // Branches and singularities all over.
  EXPECT_LT(differing_share(random_waves(saddle(5), 6), view, nothing), 0.01);
  std::vector<float> widths;
  for (const Vec3& p : plane.mesh.positions) widths.push_back(0.1f + 0.8f * p.x());
  EXPECT_LT(differing_share(plane, view, [&](Strokes& s) { s.widths = widths; }), 0.002);
  const auto pixels = [](Strokes& s) {
    s.unit = WidthUnit::pixels;
    s.width = 3;
  };
  EXPECT_LT(differing_share(plane, view, pixels), 0.002);
  EXPECT_LT(differing_share(plane_wave(saddle(12), Vec3::UnitX(), 3), view,
                            [](Strokes& s) { s.spacing = 8; }),
            0.002);
  const auto by_light = [](Strokes& s) { s.tone = ToneRange{1, 0.3f, 0.1f}; };
  EXPECT_LT(differing_share(torus, view, by_light), 0.002);
  EXPECT_LT(differing_share(torus, view, by_light, LightDirection{70, -10}), 0.002);
  CameraView sliced = view;
  sliced.slice = Slice{{0.1, 0, 0}, {1, 0.3, 0.2}, false};
  EXPECT_LT(differing_share(torus, sliced, nothing), 0.002);
}

TEST(StripeOutlines, LeaveOutWhatIsSmall) {
  const StripedSurface s = random_waves(saddle(20), 12);
  const std::vector<StyledSurface> surfaces = {styled(s)};
  const auto paths = [&](float least) {
    return stripe_outlines(surfaces, camera_of(surfaces), {UpAxis::y}, kWidth, kHeight, least)[1]
        .strokes.size();
  };
  EXPECT_GT(paths(0), paths(30));
  EXPECT_GT(paths(30), 0u);
  EXPECT_EQ(paths(1e6f), 0u);
}

TEST(StripeOutlines, AreTheSameForAnyNumberOfThreads) {
  const StripedSurface s = random_waves(saddle(8), 10);
  const std::vector<Pen> pens = outlines_of({styled(s)});
  const ThreadLimit one(1);
  const std::vector<Pen> again = outlines_of({styled(s)});
  ASSERT_EQ(pens.size(), again.size());
  for (std::size_t i = 0; i < pens.size(); ++i) EXPECT_EQ(pens[i].strokes, again[i].strokes);
}

TEST(StripeOutlines, RefuseWhatDoesNotFit) {
  StripedSurface s = plane_wave(square(2), Vec3::UnitX(), 3);
  const std::vector<StyledSurface> surfaces = {styled(s)};
  const Camera camera = camera_of(surfaces);
  const auto draw = [&](std::span<const StyledSurface> drawn, int width, float least = 0.1f) {
    return stripe_outlines(drawn, camera, {UpAxis::y}, width, kHeight, least);
  };
  EXPECT_NO_THROW(draw(surfaces, kWidth));
  EXPECT_THROW(draw(surfaces, 0), Error);
  EXPECT_THROW(draw(surfaces, 9000), Error);
  EXPECT_THROW(draw(surfaces, kWidth, -1), Error);
  EXPECT_THROW(draw({}, kWidth), Error);
  const TiledSurface tiled(s, s);
  EXPECT_NO_THROW(draw(std::vector{tiled.styled({{.tile = BuiltInTile::dots}})}, kWidth));
  EXPECT_THROW(draw(std::vector{tiled.styled({{.tile = Image(2, 2)}})}, kWidth), Error);
  EXPECT_THROW(draw(std::vector{tiled.styled({})}, kWidth), Error);
  const std::vector<float> one(1, 0.5f);
  StyledSurface few_values = tiled.styled({{.tile = BuiltInTile::dots}});
  few_values.texture->values = one;
  EXPECT_THROW(draw(std::vector{few_values}, kWidth), Error);
  std::vector<StyledSurface> few = surfaces;
  few[0].strokes[0].z = few[0].strokes[0].z.subspan(1);
  EXPECT_THROW(draw(few, kWidth), Error);
}

TEST(StripeOutlines, CanBeCancelledAtEveryReport) {
  const StripedSurface s = plane_wave(make_shape("torus,resolution=24"), Vec3::UnitY(), 6);
  const std::vector<StyledSurface> surfaces = {styled(s)};
  const Camera camera = camera_of(surfaces);
  const auto draw = [&](const Progress& progress) {
    stripe_outlines(surfaces, camera, {UpAxis::y}, kWidth, kHeight, 0.1f, progress);
  };
  testing_support::Reports all;
  draw(all.progress());
  EXPECT_GE(all.count(), 6);
  for (const int report : testing_support::reports_to_cancel(all.count())) {
    testing_support::Reports reports(report);
    EXPECT_THROW(draw(reports.progress()), Cancelled) << report;
  }
}

}  // namespace
}  // namespace brindle
