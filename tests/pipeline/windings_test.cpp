#include "brindle/windings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/boundary_phases.h"
#include "brindle/branch_pairs.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/threads.h"
#include "phase_graphs.h"
#include "test_numbers.h"

namespace brindle {
namespace {

using testing_support::kDegree;

const char* const kBentTube = "tube,radius=0.2,bend=30,resolution=48";

/// Along a tube, turned by some degrees.
DirectionField slanted(const Surface& surface, float degrees, CurvatureDirection direction) {
  const auto curvatures =
      principal_curvatures(surface.mesh.positions, surface.normals, *surface.neighborhood);
  DirectionField field = curvature_direction_field(curvatures, direction);
  return rotated(field, surface.normals, degrees * kDegree);
}

struct Tube {
  Surface surface = make_surface(make_shape(kBentTube));
  std::vector<SurfaceLoop> loops = surface_loops(surface);

  StripePattern pattern(float degrees) const {
    return stripe_pattern(surface, slanted(surface, degrees, CurvatureDirection::minimum), 11);
  }
  WoundPattern wound(float degrees, int periods, const StripeOptions& options = {}) const {
    return wind(surface, pattern(degrees), std::vector<WantedWinding>{{"", periods}}, options);
  }
};

/// Curves from one rim of the tube to the other. Where the first ring lies is the solver's choice,
/// so that a rim may cut off pieces, which begin and end at it.
std::size_t from_end_to_end(const StripeCurves& curves) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < curves.lines.count(); ++i) {
    const auto points = curves.lines.points_of(i);
    const bool both =
        curves.ends[i][0] == CurveEnd::boundary && curves.ends[i][1] == CurveEnd::boundary;
    count += both && std::abs(points.back().z() - points.front().z()) > 1;
  }
  return count;
}

/// Nothing but rings and what a rim cuts off.
void expect_rings(const StripeCurves& curves) {
  std::size_t rings = 0;
  for (std::size_t i = 0; i < curves.lines.count(); ++i) {
    rings += curves.lines.closed[i];
    if (curves.lines.closed[i]) continue;
    EXPECT_EQ(curves.ends[i][0], CurveEnd::boundary);
    EXPECT_EQ(curves.ends[i][1], CurveEnd::boundary);
  }
  EXPECT_EQ(from_end_to_end(curves), 0u);
  EXPECT_GT(rings, 15u);
  EXPECT_LE(curves.lines.count() - rings, 4u);
}

TEST(Windings, OfASlantedFieldAreWhatItsAngleSays) {
  const Tube tube;
  const double around = 2 * std::numbers::pi * 0.2 * 11;
  for (const float degrees : {-14.0f, -4.0f, 0.0f, 4.0f, 8.0f, 20.0f}) {
    const auto numbers = windings(tube.surface, tube.loops, tube.pattern(degrees));
    ASSERT_EQ(numbers.size(), 2u);
    const double expected = around * std::sin(degrees * static_cast<double>(kDegree));
    for (const Winding& number : numbers) {
      ASSERT_TRUE(number.has_value());
      EXPECT_NEAR(*number, expected, 0.75) << degrees;
    }
  }
}

TEST(Windings, ZeroClosesEveryCurve) {
  const Tube tube;
  const WoundPattern wound = tube.wound(8, 0);
  EXPECT_EQ(wound.before, (std::vector<Winding>{2, 2}));
  EXPECT_EQ(wound.after, (std::vector<Winding>{0, 0}));
  expect_rings(stripe_curves(tube.surface, wound.pattern));
}

TEST(Windings, OneRoundASleeveThatIsBentIsASingleSpiralWithoutBranches) {
  const Surface sleeve = make_surface(make_shape("tube,radius=0.2,bend=90,resolution=64"));
  const DirectionField along = slanted(sleeve, 0, CurvatureDirection::minimum);
  WoundPattern wound =
      wind(sleeve, stripe_pattern(sleeve, along, 11), std::vector<WantedWinding>{{"", 1}}, {});
  // Inside and outside of the bend differ by so much that the solver leaves stripes out.
  EXPECT_GT(wound.pattern.quality.branches, 4u);
  cancel_branches(sleeve, wound.pattern, {0.2, 25});
  EXPECT_EQ(wound.pattern.quality.branches, 0u);
  const StripeCurves curves = stripe_curves(sleeve, wound.pattern);
  EXPECT_EQ(from_end_to_end(curves), 1u);
  for (const auto& ends : curves.ends) {
    for (const CurveEnd end : ends)
      EXPECT_TRUE(end == CurveEnd::boundary || end == CurveEnd::closed);
  }
  EXPECT_LE(curves.lines.count(), 3u);  // rims may cut off pieces
}

TEST(Windings, OneIsASingleSpiralFromEndToEnd) {
  const Tube tube;
  for (const int periods : {1, -1}) {
    WoundPattern wound = tube.wound(8, periods);
    // Whether the solver leaves a pair of branches, which cuts the spiral, is a matter of rounding.
    cancel_branches(tube.surface, wound.pattern, {0});
    const StripeCurves curves = stripe_curves(tube.surface, wound.pattern);
    EXPECT_LE(curves.lines.count(), 3u);
    ASSERT_EQ(from_end_to_end(curves), 1u);
    // Right-handed screws climb where they turn counter-clockwise.
    std::size_t longest = 0;
    for (std::size_t i = 1; i < curves.lines.count(); ++i) {
      if (curves.lines.points_of(i).size() > curves.lines.points_of(longest).size()) longest = i;
    }
    const auto points = curves.lines.points_of(longest);
    double turned = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      turned += std::remainder(std::atan2(points[i].y(), points[i].x() + 0.05) -
                                   std::atan2(points[i - 1].y(), points[i - 1].x() + 0.05),
                               2 * std::numbers::pi);
    }
    const double climbed = points.back().z() - points.front().z();
    EXPECT_GT(turned * climbed * periods, 0);
  }
  EXPECT_EQ(from_end_to_end(stripe_curves(tube.surface, tube.wound(0, 2).pattern)), 2u);
}

TEST(Windings, TurnTheFieldByWhatTheLoopAsksFor) {
  const Tube tube;
  const WoundPattern wound = tube.wound(8, 0);
  // Two periods round a ring of length L turn the field by about 2 / (f L).
  const double expected = 2 / (11 * 2 * std::numbers::pi * 0.2) / static_cast<double>(kDegree);
  EXPECT_NEAR(wound.mean_turn_deg, expected, 0.3);
  EXPECT_LT(wound.largest_turn_deg, 1.3 * expected);
  EXPECT_LT(wound.largest_frequency_change, 0.03);
  EXPECT_LT(wound.pattern.solution.energy, 1.2 * wound.energy_before);
}

TEST(Windings, ThatAreThereLeaveThePatternAsItIs) {
  const Tube tube;
  const WoundPattern wound = tube.wound(8, 2);
  EXPECT_EQ(wound.largest_turn_deg, 0);
  EXPECT_EQ(wound.pattern.solution.z, tube.pattern(8).solution.z);
}

TEST(Windings, KeepFrequenciesThatHaveYielded) {
  const Tube tube;
  StripeOptions options;
  options.slack = 0.25f;
  const StripePattern pattern = stripe_pattern(
      tube.surface, slanted(tube.surface, 8, CurvatureDirection::minimum), 11, options);
  const WoundPattern wound =
      wind(tube.surface, pattern, std::vector<WantedWinding>{{"", 1}}, options);
  EXPECT_EQ(wound.after[0], 1);
  EXPECT_EQ(wound.pattern.frequencies_wanted, pattern.frequencies_wanted);
  for (std::size_t v = 0; v < pattern.waves.frequencies.size(); ++v) {
    EXPECT_NEAR(wound.pattern.waves.frequencies[v] / pattern.waves.frequencies[v], 1, 0.03);
  }
  EXPECT_GT(wound.pattern.quality.spacing_error_wanted_mean, 0);
}

TEST(Windings, DoNotDependOnHowDirectionsAreSigned) {
  const Tube tube;
  StripePattern pattern = tube.pattern(8);
  const auto flipped = testing_support::flip_half(pattern.waves, 3);
  for (std::size_t v = 0; v < flipped.size(); ++v) {
    if (flipped[v]) pattern.solution.z[v] = -std::conj(pattern.solution.z[v]);
  }
  EXPECT_EQ(windings(tube.surface, tube.loops, pattern), (std::vector<Winding>{2, 2}));
  const WoundPattern wound = wind(tube.surface, pattern, std::vector<WantedWinding>{{"", 1}});
  EXPECT_EQ(wound.after, (std::vector<Winding>{1, 1}));
  EXPECT_NEAR(wound.mean_turn_deg, tube.wound(8, 1).mean_turn_deg, 1e-3);
}

TEST(Windings, ChangeTheirSignInAMirror) {
  Tube tube;
  const int before = *windings(tube.surface, tube.loops, tube.pattern(8))[0];
  Mesh mesh = tube.surface.mesh;
  for (Vec3& p : mesh.positions) p.y() = -p.y();
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  tube.surface = make_surface(mesh);
  const auto numbers = windings(tube.surface, surface_loops(tube.surface), tube.pattern(-8));
  EXPECT_EQ(numbers[0], -before);
  EXPECT_EQ(numbers[1], -before);
}

TEST(Windings, StayWithRigidMotion) {
  Tube tube;
  const WoundPattern before = tube.wound(8, 1);
  const Eigen::AngleAxisf turn(1.1f, Vec3(1, -2, 0.5f).normalized());
  for (Vec3& p : tube.surface.mesh.positions) p = turn * p + Vec3(2, 1, -3);
  tube.surface = make_surface(tube.surface.mesh);
  const WoundPattern after = tube.wound(8, 1);
  EXPECT_EQ(after.after, before.after);
  EXPECT_NEAR(after.largest_turn_deg, before.largest_turn_deg, 0.02);
}

TEST(Windings, AreTheSameForEveryNumberOfThreads) {
  const Tube tube;
  const ThreadLimit one(1);
  const auto alone = tube.wound(8, 1).pattern.solution.z;
  const ThreadLimit two(2);
  EXPECT_EQ(tube.wound(8, 1).pattern.solution.z, alone);
}

TEST(Windings, OfATorusAreChosenRoundBothWays) {
  const Surface torus = make_surface(make_shape("torus,resolution=60"));
  const auto loops = surface_loops(torus);
  const StripePattern pattern =
      stripe_pattern(torus, slanted(torus, 12, CurvatureDirection::maximum), 7);
  const auto before = windings(torus, loops, pattern);
  ASSERT_TRUE(before[0] && before[1]);
  const std::vector<WantedWinding> wanted = {{"loop-1", *before[0] + 1},
                                             {"loop-2", *before[1] - 1}};
  const WoundPattern wound = wind(torus, pattern, wanted);
  EXPECT_EQ(wound.after[0], *before[0] + 1);
  EXPECT_EQ(wound.after[1], *before[1] - 1);
  EXPECT_LT(wound.largest_turn_deg, 15);
  // One alone leaves the other.
  const WoundPattern first = wind(torus, pattern, std::span(wanted).first(1));
  EXPECT_EQ(first.after[0], *before[0] + 1);
  EXPECT_EQ(first.after[1], before[1]);
}

std::string refusal(const std::string& shape, const std::vector<WantedWinding>& wanted) {
  const Surface surface = make_surface(make_shape(shape));
  try {
    wind(surface, stripe_pattern(surface, smooth_direction_field(surface), 5), wanted);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Windings, ThatCannotBeAreRefused) {
  const auto expect = [](const std::string& part, const std::string& shape,
                         const std::vector<WantedWinding>& wanted) {
    const std::string text = refusal(shape, wanted);
    EXPECT_NE(text.find(part), std::string::npos) << shape << ": " << text;
  };
  expect("no way round", "sphere,resolution=8", {{"", 1}});
  expect("no way round", "plane,resolution=8", {{"boundary-1", 1}});
  expect("loop-1, loop-2", "trefoil,resolution=16", {{"", 1}});
  expect("no 'boundary-3'", kBentTube, {{"boundary-3", 1}});
  expect("million", kBentTube, {{"", 2'000'000}});
  expect("twice", kBentTube, {{"boundary-1", 1}, {"", 0}});
  expect("boundary-2 has 20", kBentTube, {{"boundary-1", 20}, {"boundary-2", 0}});
  const Tube tube;
  EXPECT_THROW(tube.wound(0, 10'000), Error);  // more than the mesh can hold
}

/// A square with two round holes, and waves that wind so often round each.
struct Pants {
  Surface surface = make_surface(mesh());
  std::vector<SurfaceLoop> loops = surface_loops(surface);

  static Vec3 hole(int number) { return Vec3(number == 0 ? -0.5f : 0.5f, 0.013f, 0); }
  static Mesh mesh() {
    Mesh plane = make_shape("plane,resolution=60");
    std::erase_if(plane.triangles, [&](const Triangle& t) {
      return std::ranges::any_of(t, [&](Index v) {
        const Vec3& p = plane.positions[v];
        return (p - hole(0)).norm() < 0.25f || (p - hole(1)).norm() < 0.25f;
      });
    });
    drop_unreferenced_vertices(plane);
    return plane;
  }
  StripePattern pattern(int first, int second) const {
    DirectionField directions;
    FrequencyField frequencies;
    for (const Vec3& p : surface.mesh.positions) {
      Vec3 change = Vec3::Zero();
      for (int h = 0; h < 2; ++h) {
        const Vec3 way = p - hole(h);
        const auto periods = static_cast<float>(h == 0 ? first : second);
        change += periods * Vec3(-way.y(), way.x(), 0) / way.squaredNorm();
      }
      directions.push_back(change.normalized());
      // Between the holes is a saddle, where a change must find a wave to turn.
      frequencies.push_back(std::max(1.0f, change.norm() / (2 * std::numbers::pi_v<float>)));
    }
    return stripe_pattern(surface, directions, frequencies);
  }
};

TEST(Windings, OfThreeBoundariesAddUp) {
  const Pants pants;
  ASSERT_EQ(pants.loops.size(), 3u);
  const StripePattern pattern = pants.pattern(6, 9);
  const auto numbers = windings(pants.surface, pants.loops, pattern);
  EXPECT_EQ(numbers, (std::vector<Winding>{15, 6, 9}));
  const auto sums = winding_sums(pants.surface, pants.loops, pattern);
  ASSERT_EQ(sums.size(), 1u);
  EXPECT_EQ(sums[0].boundaries, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(sums[0].periods, 0);

  // Boundaries are told apart by their centres.
  EXPECT_LT(pants.loops[0].center.norm(), 1e-5);
  for (const int h : {0, 1}) {
    EXPECT_LT((pants.loops[h + 1].center - Pants::hole(h).cast<double>()).norm(), 0.02);
  }

  // All three may be asked for where that adds up, whatever the order.
  const std::vector<WantedWinding> all = {{"boundary-2", 7}, {"boundary-1", 15}, {"boundary-3", 8}};
  const WoundPattern wound = wind(pants.surface, pattern, all);
  EXPECT_EQ(wound.after, (std::vector<Winding>{15, 7, 8}));
  EXPECT_EQ(winding_sums(pants.surface, pants.loops, wound.pattern)[0].periods, 0);
  try {
    const std::vector<WantedWinding> off = {
        {"boundary-1", 15}, {"boundary-2", 7}, {"boundary-3", 9}};
    wind(pants.surface, pattern, off);
    ADD_FAILURE() << "7 and 9 were made of 15";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("boundary-3 has 8"), std::string::npos)
        << error.what();
  }
}

TEST(Windings, OfATubeAddUpWhereNothingBranches) {
  const Tube tube;
  for (const WoundPattern& wound : {tube.wound(8, 2), tube.wound(0, -1)}) {
    const auto sums = winding_sums(tube.surface, tube.loops, wound.pattern);
    ASSERT_EQ(sums.size(), 1u);
    EXPECT_EQ(sums[0].periods, 0);
  }
  const std::vector<WantedWinding> both = {{"boundary-1", 1}, {"boundary-2", 1}};
  EXPECT_EQ(wind(tube.surface, tube.pattern(8), both).after, (std::vector<Winding>{1, 1}));
}

TEST(Windings, AreChosenForTubesWithSliversAtTheRim) {
  // Triangles a thousandth of their length high beyond every edge of one rim.
  Mesh mesh = make_shape(kBentTube);
  const auto rim = surface_loops(make_surface(mesh))[0].vertices;
  const Vec3 out = (mesh.positions[rim[0]] - mesh.positions[rim[0] + 48]).normalized();
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Index a = rim[i], b = rim[(i + 1) % rim.size()];
    const float length = (mesh.positions[a] - mesh.positions[b]).norm();
    // At unequal shares, so that the rim zigzags.
    const float share = i % 2 == 0 ? 0.5f : 0.3f;
    mesh.positions.push_back((1 - share) * mesh.positions[a] + share * mesh.positions[b] +
                             1e-3f * length * out);
    mesh.triangles.push_back({b, a, static_cast<Index>(mesh.positions.size() - 1)});
  }
  const Surface surface = make_surface(std::move(mesh));
  ASSERT_EQ(surface_loops(surface).size(), 2u);
  const DirectionField along = projected_direction_field({0, 0, 1}, surface.normals);
  const StripePattern pattern =
      stripe_pattern(surface, rotated(along, surface.normals, 8 * kDegree), 11);
  const int before = windings(surface, surface_loops(surface), pattern)[0].value();
  for (const int more : {-2, -1, 1}) {
    const std::vector<WantedWinding> wanted = {{"boundary-2", before + more}};
    const WoundPattern wound = wind(surface, pattern, wanted);
    EXPECT_EQ(wound.after[0], before + more);
    EXPECT_EQ(wound.after[1], before + more);
  }
}

TEST(WavesRound, AreChosenRoundOneOfThreeBoundaries) {
  const Pants pants;
  const DirectionField round = pants.pattern(6, 9).waves.directions;
  const StripePattern pattern =
      stripe_pattern(pants.surface, waves_round(pants.surface, round, {"boundary-2", 12}));
  EXPECT_EQ(windings(pants.surface, pants.loops, pattern)[1], 12);
  EXPECT_EQ(winding_sums(pants.surface, pants.loops, pattern)[0].periods, 0);
}

TEST(WavesRound, AreExactlySoManyWhereverTheSleeveIsWide) {
  const Surface vase = make_surface(make_shape("tube,bend=20,bulge=0.4,resolution=60"));
  const DirectionField round = slanted(vase, 0, CurvatureDirection::maximum);
  for (const int wales : {1, 17, 40}) {
    const StripePattern pattern = stripe_pattern(vase, waves_round(vase, round, {"", wales}));
    EXPECT_EQ(pattern.quality.branches, 0u);
    EXPECT_EQ(windings(vase, surface_loops(vase), pattern), (std::vector<Winding>{wales, wales}));
    const StripeCurves curves = stripe_curves(vase, pattern);
    EXPECT_EQ(curves.lines.count(), static_cast<std::size_t>(wales));
    EXPECT_EQ(from_end_to_end(curves), static_cast<std::size_t>(wales));
  }
  EXPECT_THROW(waves_round(vase, round, {"", 0}), Error);
}

TEST(FixedPhases, LayARingAlongEveryRim) {
  const Tube tube;
  const DirectionField field = slanted(tube.surface, 0, CurvatureDirection::minimum);
  const WaveSet waves{tube.surface.mesh.positions, field,
                      constant_frequency_field(11, tube.surface.mesh.vertex_count())};
  StripeOptions options;
  options.fixed_phases = boundary_phases(tube.surface, waves, 0);
  const StripePattern pattern = stripe_pattern(tube.surface, waves, options);
  const StripeCurves curves = stripe_curves(tube.surface, pattern);
  EXPECT_EQ(pattern.quality.branches, 0u);
  std::size_t on_rim = 0;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    EXPECT_EQ(curves.lines.closed[line], 1);
    const Vec3 point = curves.lines.points_of(line)[0];
    for (const SurfaceLoop& loop : tube.loops) {
      float least = 1;
      for (const Index v : loop.vertices) {
        least = std::min(least, (point - tube.surface.mesh.positions[v]).norm());
      }
      on_rim += least < 0.02f;
    }
  }
  EXPECT_EQ(on_rim, 2u);
  for (std::size_t v = 0; v < options.fixed_phases.size(); ++v) {
    if (options.fixed_phases[v] != Complex(0)) {
      EXPECT_EQ(pattern.solution.z[v], options.fixed_phases[v]);
    }
  }
  options.solver.solver = Solver::relaxation;
  EXPECT_THROW(stripe_pattern(tube.surface, waves, options), Error);
}

}  // namespace
}  // namespace brindle
