// Whatever takes long tells how far it is and stops where it is asked to.
#include <algorithm>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/branch_pairs.h"
#include "brindle/carried_phases.h"
#include "brindle/cross_animator.h"
#include "brindle/cross_texture.h"
#include "brindle/direction_field.h"
#include "brindle/mesh_data.h"
#include "brindle/normals.h"
#include "brindle/points.h"
#include "brindle/points/point_tree.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"
#include "brindle/strokes.h"
#include "brindle/texture_pattern.h"
#include "brindle/windings.h"
#include "progress_reports.h"

namespace brindle {
namespace {

using Job = std::function<void(const Progress&)>;

// More vertices than are looked at between two reports.
const Surface& torus() {
  static const Surface surface = make_surface(make_shape("torus,resolution=240"));
  return surface;
}

const DirectionField& field() {
  static const DirectionField directions = smooth_direction_field(torus());
  return directions;
}

const StripePattern& pattern() {
  static const StripePattern stripes = stripe_pattern(torus(), field(), 8);
  return stripes;
}

const StripePattern& crossing() {
  static const StripePattern stripes =
      stripe_pattern(torus(), rotated(field(), torus().normals, std::numbers::pi_v<float> / 2), 8);
  return stripes;
}

const StripeCurves& curves() {
  static const StripeCurves traced = stripe_curves(torus(), pattern());
  return traced;
}

const TexturePattern& texture() {
  static const TexturePattern made = texture_pattern(torus(), field(), 6);
  return made;
}

StripeOptions solved_by(Solver solver) {
  StripeOptions options;
  options.solver.solver = solver;
  options.solver.max_iterations = 20;
  options.solver.global_iterations = 3;
  return options;
}

// Functions of the library that take long on large surfaces.
std::vector<std::pair<std::string, Job>> jobs() {
  std::vector<std::pair<std::string, Job>> all;
  const auto add = [&](const char* name, Job job) { all.emplace_back(name, std::move(job)); };
  add("make_mesh", [](const Progress& progress) {
    const Mesh& mesh = torus().mesh;
    make_mesh(mesh.positions, {mesh.triangles.data()->data(), mesh.triangle_count(), 3},
              BadTriangles::refused, progress);
  });
  add("subdivide", [](const Progress& progress) { subdivide(torus().mesh, 2, progress); });
  add("subdivide_data", [](const Progress& progress) {
    Mesh mesh = torus().mesh;
    DataArrays arrays;
    arrays.points.push_back(make_data_array("x", 1, std::vector<float>(mesh.vertex_count(), 1)));
    const DataArrays before = arrays;
    try {
      subdivide(mesh, arrays, 1, progress);
    } catch (const Cancelled&) {
      EXPECT_EQ(mesh.positions.size(), torus().mesh.positions.size());
      EXPECT_EQ(arrays, before);
      throw;
    }
  });
  // Shapes with a formula, without one, and with noise, each of some slices.
  add("make_shape_sphere",
      [](const Progress& progress) { make_shape("sphere,resolution=60", progress); });
  add("make_shape_box",
      [](const Progress& progress) { make_shape("box,resolution=40", progress); });
  add("make_shape_with_noise",
      [](const Progress& progress) { make_shape("torus,resolution=240,noise=0.3", progress); });
  add("feature_strokes",
      [](const Progress& progress) { feature_strokes(torus(), 1, 0.1, 1, progress); });
  add("make_surface", [](const Progress& progress) { make_surface(torus().mesh, progress); });
  add("principal_curvatures", [](const Progress& progress) {
    principal_curvatures(torus().mesh.positions, torus().normals, *torus().neighborhood, progress);
  });
  add("nearby_rows",
      [](const Progress& progress) { nearby_rows(torus().mesh, torus().mesh, 1, progress); });
  add("smooth_direction_field", [](const Progress& progress) {
    SmoothFieldOptions options;
    options.curvature_anchor = 1;
    options.feature_anchor = 1;
    smooth_direction_field(torus(), options, progress);
  });
  add("stroke_anchors", [](const Progress& progress) {
    const auto at = [](Index v) { return torus().mesh.positions[v].cast<double>().eval(); };
    const std::vector<FieldStroke> strokes = {{{at(0), at(1)}, 0.2, 1}, {{at(7), at(8)}, 0.1, 1}};
    stroke_anchors(torus(), strokes, progress);
  });
  for (const Solver solver : {Solver::multilevel, Solver::relaxation, Solver::averaged}) {
    add(("stripe_pattern_" + std::string(name_of(solver))).c_str(),
        [solver](const Progress& progress) {
          stripe_pattern(torus(), field(), 8, solved_by(solver), progress);
        });
  }
  add("stripe_pattern_with_slack", [](const Progress& progress) {
    StripeOptions options;
    options.slack = 0.2f;
    stripe_pattern(torus(), field(), 8, options, progress);
  });
  add("relaxed_frequencies", [](const Progress& progress) {
    const std::vector<float> wanted(torus().mesh.vertex_count(), 8);
    relaxed_frequencies(torus(), {torus().mesh.positions, field(), wanted}, 0.2f, progress);
  });
  add("texture_pattern",
      [](const Progress& progress) { texture_pattern(torus(), field(), 6, {}, progress); });
  add("texture_coordinates",
      [](const Progress& progress) { texture_coordinates(torus(), texture(), progress); });
  add("texture_coordinates_of_stripes", [](const Progress& progress) {
    texture_coordinates(torus(), pattern(), PhaseShiftKind::aligned, false, progress);
  });
  add("cross_pattern", [](const Progress& progress) {
    cross_pattern(torus(), {torus().mesh.positions, field(), pattern().waves.frequencies}, {},
                  progress);
  });
  add("cross_pattern_with_slack", [](const Progress& progress) {
    StripeOptions options;
    options.slack = 0.2f;
    cross_pattern(torus(), {torus().mesh.positions, field(), pattern().waves.frequencies}, options,
                  progress);
  });
  add("cross_texture", [](const Progress& progress) {
    static const CrossPattern crosses =
        cross_pattern(torus(), {torus().mesh.positions, field(), pattern().waves.frequencies});
    cross_texture(torus(), crosses, PhaseShiftKind::aligned, progress);
  });
  add("CrossAnimator", [](const Progress& progress) {
    CrossAnimator animator(torus());
    try {
      animator.frame({{torus().mesh.positions, field(), pattern().waves.frequencies}}, progress);
    } catch (const Cancelled&) {
      EXPECT_THROW(animator.energy(), Error);  // there is no frame yet
      throw;
    }
  });
  add("stripe_curves_faired", [](const Progress& progress) {
    stripe_curves(torus(), pattern(), {.fair = 0.25f}, progress);
  });
  add("stripe_curves_trimmed",
      [](const Progress& progress) { stripe_curves(torus(), pattern(), {}, progress); });
  add("stripe_curves", [](const Progress& progress) {
    stripe_curves(torus(), pattern(), {.join = true}, progress);
  });
  add("measure_curves", [](const Progress& progress) {
    measure_curves(torus(), pattern(), curves(), 0.01, progress);
  });
  add("simplified", [](const Progress& progress) { simplified(curves().lines, 1e-3f, progress); });
  add("resampled", [](const Progress& progress) { resampled(curves().lines, 1e-3f, progress); });
  add("tubes", [](const Progress& progress) { tubes(curves().lines, {}, progress); });
  add("carried_phases", [](const Progress& progress) {
    const StripePattern& last = pattern();
    carried_phases({torus().mesh, last.waves, last.solution.z}, torus().mesh, last.waves, 1,
                   progress);
  });
  add("cancel_branches", [](const Progress& progress) {
    // A small surface: every pair of branches takes as long as all vertices around it.
    static const Surface small = make_surface(make_shape("torus,resolution=80"));
    static const StripePattern before =
        stripe_pattern(small, projected_direction_field({1, 0.3f, 0.2f}, small.normals), 8);
    StripePattern merged = before;
    try {
      cancel_branches(small, merged, {0.1}, {}, progress);
    } catch (const Cancelled&) {
      EXPECT_EQ(merged.solution.z, before.solution.z);
      throw;
    }
  });
  if (has_point_trees()) {
    add("make_point_surface", [](const Progress& progress) {
      make_point_surface(make_point_cloud(torus().mesh.positions).cloud, 8, progress);
    });
    add("stripe_pattern_of_points_with_slack", [](const Progress& progress) {
      static const Surface points =
          make_point_surface(make_point_cloud(torus().mesh.positions).cloud, 8);
      StripeOptions options;
      options.slack = 0.2f;
      stripe_pattern(points, projected_direction_field({1, 0.3f, 0.2f}, points.normals), 8, options,
                     progress);
    });
    add("make_point_cloud",
        [](const Progress& progress) { make_point_cloud(torus().mesh.positions, {}, progress); });
    add("stripe_samples",
        [](const Progress& progress) { stripe_samples(torus(), pattern(), crossing(), progress); });
    add("drop_doubles", [](const Progress& progress) {
      static const std::vector<Sample> samples = stripe_samples(torus(), pattern(), crossing());
      std::vector<Sample> left = samples;
      try {
        drop_doubles(left, 0.5f, progress);
      } catch (const Cancelled&) {
        EXPECT_EQ(left.size(), samples.size());
        throw;
      }
      measure_sample_spacing(samples);
    });
  }
  return all;
}

struct Cancelling : testing::TestWithParam<std::size_t> {
  std::string name = jobs()[GetParam()].first;
  Job job = jobs()[GetParam()].second;
};

TEST_P(Cancelling, FractionsRiseFromZeroToOneOverStagesKnownFromTheFirst) {
  std::vector<double> fractions;
  std::vector<std::string> first, last;
  job(Progress([&](const ProgressReport& report) {
    fractions.push_back(report.fraction);
    last.clear();
    for (const JobStage& stage : report.stages) last.push_back(stage.name);
    if (fractions.size() == 1) first = last;
    EXPECT_LT(report.stage, last.size());
    EXPECT_GE(report.step_fraction, 0) << report.step;
    EXPECT_LE(report.step_fraction, 1) << report.step;
    EXPECT_FALSE(report.step.empty());
    return true;
  }));
  ASSERT_GE(fractions.size(), 2u) << name;
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end())) << name;
  EXPECT_EQ(fractions.front(), 0) << name;
  EXPECT_EQ(fractions.back(), 1) << name;
  EXPECT_EQ(first, last) << name;
  EXPECT_FALSE(first.empty()) << name;
}

TEST_P(Cancelling, StopsAtEveryReport) {
  testing_support::Reports all;
  job(all.progress());
  for (const int report : testing_support::reports_to_cancel(all.count())) {
    testing_support::Reports reports(report);
    EXPECT_THROW(job(reports.progress()), Cancelled) << name << " at report " << report;
    EXPECT_EQ(reports.count(), report + 1) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Cancelling, testing::Range(std::size_t{0}, jobs().size()),
                         [](const auto& of) { return jobs()[of.param].first; });

// Jobs that were silent for most of their time. How much of a job lies between two reports is the
// same on every machine; how long that takes bench/longest_gaps measures.
TEST(Cancelling, ReportsAreNeverFarApart) {
  const std::map<std::string, double> farthest = {
      {"make_shape_sphere", 0.4},
      {"make_shape_box", 0.1},
      {"make_shape_with_noise", 0.4},
      {"feature_strokes", 0.1},
      {"relaxed_frequencies", 0.5},
      {"stripe_pattern_averaged", 0.3},
      {"stripe_pattern_with_slack", 0.25},
      {"cancel_branches", 0.25},
      {"cross_pattern_with_slack", 0.2},
      {"cross_texture", 0.1},
      {"CrossAnimator", 0.2},
      {"make_point_surface", 0.2},
      {"make_point_cloud", 0.3},
      {"stripe_pattern_of_points_with_slack", 0.2},
  };
  std::size_t found = 0;
  for (const auto& [name, job] : jobs()) {
    if (!farthest.contains(name)) continue;
    ++found;
    double last = 0, most = 0;
    int reports = 0;
    job(Progress([&](const ProgressReport& report) {
      most = std::max(most, report.fraction - last);
      last = report.fraction;
      ++reports;
      return true;
    }));
    EXPECT_LE(most, farthest.at(name)) << name;
    EXPECT_GE(reports, 8) << name;
  }
  if (has_point_trees()) {
    EXPECT_EQ(found, farthest.size());
  }
}

TEST(Cancelling, ListeningChangesNoBits) {
  const Progress progress([](std::string_view, double) { return true; });
  const DirectionField heard = smooth_direction_field(torus(), {}, progress);
  EXPECT_EQ(heard, field());
  const StripePattern stripes = stripe_pattern(torus(), heard, 8, {}, progress);
  EXPECT_EQ(stripes.solution.z, pattern().solution.z);
  EXPECT_EQ(stripes.quality.angle_error_mean_deg, pattern().quality.angle_error_mean_deg);
  const StripeCurves traced = stripe_curves(torus(), stripes, {}, progress);
  EXPECT_EQ(traced.lines.points, curves().lines.points);
  const CurveMeasures a = measure_curves(torus(), pattern(), curves(), 0.01);
  const CurveMeasures b = measure_curves(torus(), stripes, traced, 0.01, progress);
  EXPECT_EQ(a.coverage, b.coverage);
  if (!a.gaps) return;
  EXPECT_EQ(a.gaps->mean, b.gaps->mean);
  EXPECT_EQ(a.gaps->mean_ratio, b.gaps->mean_ratio);
}

}  // namespace
}  // namespace brindle
