#include "session/live_pattern.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/threads.h"
#include "formatted.h"
#include "progress_reports.h"

namespace brindle::tool {
namespace {

SessionDocument torus() {
  SessionDocument document;
  document.mesh = "shape:torus,resolution=24";
  document.size = {160, 120};
  document.options["stripes"] = {"20"};
  return document;
}

SessionDocument with(SessionDocument document, const std::string& name, const std::string& value) {
  document.options[name] = {value};
  return document;
}

std::set<std::string> stages(const LivePattern& pattern) {
  std::set<std::string> names;
  for (const auto& [name, time] : pattern.state()->figures.milliseconds) names.insert(name);
  return names;
}

const std::vector<Complex>& z_of(const LivePattern& pattern) {
  return pattern.state()->job->result.stripes().solution.z;
}

TEST(LivePattern, CurvesAndSamplesAreOfTheStripesThatWereShown) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const std::vector<Complex> z = z_of(pattern);
  SessionDocument document = torus();
  document.shown = Shown::curves;
  document.curves = {{"lines", {"both"}}};
  pattern.update(document, Follow::last);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"curves"});
  EXPECT_EQ(z_of(pattern), z);
  ASSERT_NE(pattern.state()->curves, nullptr);
  EXPECT_EQ(pattern.state()->curves->families.size(), 2);
  EXPECT_EQ(pattern.state()->samples, nullptr);
  EXPECT_EQ(pattern.state()->figures.shown.front().first, "curves of u");

  const std::uint64_t drawn = pattern.state()->pattern;
  document.camera.azimuth_deg = 77;
  pattern.update(document, Follow::last);
  EXPECT_TRUE(stages(pattern).empty()) << "a camera moves no curves";
  EXPECT_EQ(pattern.state()->pattern, drawn);

  const auto v = pattern.state()->curves->families[1].pattern.solution.z;
  document.curves["join"] = {};
  pattern.update(document, Follow::last);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"curves"});
  EXPECT_NE(pattern.state()->pattern, drawn);
  EXPECT_EQ(pattern.state()->curves->families[1].pattern.solution.z, v);

  document.shown = Shown::samples;
  pattern.update(document, Follow::last);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"samples"});
  EXPECT_EQ(pattern.state()->curves, nullptr);
  EXPECT_FALSE(pattern.state()->samples->taken.samples.empty());
  EXPECT_EQ(z_of(pattern), z);

  pattern.update(torus(), Follow::last);
  EXPECT_TRUE(stages(pattern).empty());
  EXPECT_EQ(pattern.state()->samples, nullptr);
}

TEST(LivePattern, TilesFollowInDraftsAlone) {
  for (const char* kind : {"texture", "cross"}) {
    SessionDocument document = torus();
    document.options["field"] = {"curvature"};
    if (kind == std::string("cross")) {
      document.options["cross"] = {};
    } else {
      document.options["texture"] = {"bricks"};
    }
    LivePattern pattern;
    pattern.update(document, Follow::afresh);
    SessionDocument moved = document;
    std::vector<double> steps;
    for (int step = 1; step <= 12; ++step) {
      moved.options["stripes"] = {formatted("%.2f", 20 + 0.1 * step)};
      pattern.update(moved, Follow::loosely);
      steps.push_back(pattern.state()->figures.phase_step);
    }
    std::ranges::sort(steps);
    EXPECT_LT(steps[steps.size() / 2], 0.1) << kind << ": tiles glide, but where rows come and go";
    const LiveFigures& followed = pattern.state()->figures;
    EXPECT_GT(followed.phase_step, 0) << kind;
    EXPECT_GT(followed.energy, 0) << kind;
    EXPECT_EQ(pattern.state()->phases, nullptr) << "no document can keep them";
    const std::size_t singularities = followed.singularities;
    const std::size_t triangles = pattern.state()->job->surface->mesh.triangle_count();

    pattern.update(moved, Follow::last);
    EXPECT_EQ(pattern.state()->figures.phase_step, 0) << "made of the document alone";
    EXPECT_EQ(pattern.state()->figures.singularities, singularities);
    EXPECT_EQ(pattern.state()->job->surface->mesh.triangle_count(), triangles);
    LivePattern afresh;
    afresh.update(moved, Follow::afresh);
    const auto& waves = [](const LivePattern& of) -> const TextureWaves& {
      return of.state()->job->result.texture()->pattern.waves;
    };
    ASSERT_EQ(waves(pattern).u.size(), waves(afresh).u.size());
    EXPECT_EQ(pattern.state()->figures.energy, afresh.state()->figures.energy);
    EXPECT_EQ(waves(pattern).u[7][0].z, waves(afresh).u[7][0].z);
  }
}

TEST(LivePattern, WhatCrossesFollowsInDraftsAlone) {
  SessionDocument hatched = torus(), curves = torus(), samples = torus();
  hatched.options["width-by"] = {"light"};
  hatched.options["cross-hatch"] = {"0.6"};
  curves.shown = Shown::curves;
  curves.curves["lines"] = {"both"};
  samples.shown = Shown::samples;
  const auto crossing_of = [](const LivePattern& pattern) -> std::vector<Vec3> {
    const LiveState& state = *pattern.state();
    if (state.curves) return state.curves->families[1].curves.lines.points;
    std::vector<Vec3> points;
    if (state.samples) {
      for (const Sample& sample : state.samples->taken.samples) points.push_back(sample.position);
      return points;
    }
    for (const Complex& z : state.style->patterns.crossing->solution.z) {
      points.emplace_back(z.real(), z.imag(), 0);
    }
    return points;
  };
  for (const SessionDocument& document : {hatched, curves, samples}) {
    LivePattern pattern, afresh;
    pattern.update(document, Follow::afresh);
    SessionDocument moved = with(document, "stripes", "20.7");
    pattern.update(moved, Follow::loosely);
    const std::vector<Vec3> followed = crossing_of(pattern);
    moved.camera.azimuth_deg = 50;
    pattern.update(moved, Follow::loosely);
    EXPECT_EQ(crossing_of(pattern), followed) << "a camera changes no stripes";
    pattern.update(moved, Follow::last);
    ASSERT_NE(pattern.state()->phases, nullptr);
    moved.phases = pattern.state()->phases;
    afresh.update(moved, Follow::afresh);
    EXPECT_EQ(crossing_of(pattern), crossing_of(afresh)) << "at rest, made of the document alone";
    EXPECT_NE(crossing_of(pattern), followed);
  }
}

TEST(LivePattern, CancelledCurvesLeaveWhatWasShown) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const auto before = pattern.state();
  SessionDocument document = torus();
  document.shown = Shown::curves;
  document.curves = {{"lines", {"both"}}};
  EXPECT_THROW(pattern.update(document, Follow::last, Progress([](std::string_view stage, double) {
                                return stage != "curves";
                              })),
               Cancelled);
  EXPECT_EQ(pattern.state(), before);
  pattern.update(document, Follow::last);
  EXPECT_NE(pattern.state()->curves, nullptr);
}

TEST(LivePattern, KeepsTheStagesWhoseInputsStay) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  EXPECT_TRUE(stages(pattern).contains("load"));
  const auto surface = pattern.state()->job->surface.get();
  const std::uint64_t drawn = pattern.state()->pattern;

  SessionDocument moved = torus();
  moved.camera.azimuth_deg = 77;
  pattern.update(moved, Follow::last);
  EXPECT_TRUE(stages(pattern).empty());
  EXPECT_EQ(pattern.state()->pattern, drawn);

  pattern.update(with(moved, "stripe-width", "0.3"), Follow::last);
  EXPECT_TRUE(stages(pattern).empty());
  EXPECT_NE(pattern.state()->pattern, drawn);

  pattern.update(with(moved, "sweeps", "3"), Follow::afresh);
  EXPECT_FALSE(stages(pattern).contains("field"));
  EXPECT_TRUE(stages(pattern).contains("solve"));

  pattern.update(with(moved, "stripes", "22"), Follow::last);
  EXPECT_FALSE(stages(pattern).contains("field"));
  EXPECT_TRUE(stages(pattern).contains("waves"));

  pattern.update(with(moved, "curvature-anchor", "0.5"), Follow::last);
  EXPECT_TRUE(stages(pattern).contains("field"));
  EXPECT_FALSE(stages(pattern).contains("load"));
  EXPECT_NE(surface, nullptr);
}

TEST(LivePattern, ReadsAndSolvesForAStyleOnce) {
  SessionDocument document = with(torus(), "color-by", "height");
  document.options["with"] = {"shape:box,resolution=6@striped"};
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  EXPECT_TRUE(stages(pattern).contains("style"));
  const std::uint64_t drawn = pattern.state()->pattern;
  pattern.update(with(document, "color-range", "0,1"), Follow::last);
  EXPECT_TRUE(stages(pattern).empty()) << "looks alone are another";
  EXPECT_NE(pattern.state()->pattern, drawn);
  pattern.update(with(document, "rotate", "20"), Follow::last);
  EXPECT_TRUE(stages(pattern).contains("style"));
  pattern.update(torus(), Follow::last);
  EXPECT_EQ(pattern.state()->style, nullptr);
}

TEST(LivePattern, ReadsValuesAloneWhenTheCameraMoves) {
  SessionDocument document = with(torus(), "color-by", "distance:camera");
  document.options["with"] = {"shape:box,resolution=6@striped"};
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  const auto style = pattern.state()->style;
  SessionDocument moved = document;
  moved.camera.azimuth_deg = 77;
  pattern.update(moved, Follow::last);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"style"});
  EXPECT_EQ(pattern.state()->style->patterns.others, style->patterns.others);
  EXPECT_NE(pattern.state()->style->input.values.color->values, style->input.values.color->values);

  SessionDocument hatched = with(torus(), "width-by", "light");
  hatched.options["cross-hatch"] = {"0.5"};
  pattern.update(hatched, Follow::afresh);
  const std::uint64_t drawn = pattern.state()->pattern;
  hatched.camera.azimuth_deg = 77;
  pattern.update(hatched, Follow::last);
  EXPECT_TRUE(stages(pattern).empty());
  EXPECT_EQ(pattern.state()->pattern, drawn);
}

TEST(LivePattern, KeepsOtherSurfacesWhenValuesOfAPlaceChange) {
  SessionDocument document = with(torus(), "width-by", "distance:1,0,0");
  document.options["with"] = {"shape:box,resolution=6@#ffffff"};
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  const auto others = pattern.state()->style->patterns.others;
  pattern.update(with(document, "width-by", "distance:0,1,0"), Follow::last);
  EXPECT_EQ(pattern.state()->style->patterns.others, others);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"style"});
  document.options["with"] = {"shape:box,resolution=6@#ffffff@0,0,1"};
  pattern.update(document, Follow::last);
  ASSERT_NE(pattern.state()->style->patterns.others, others);
  const Mesh &before = (*others)[0].surface.mesh,
             &after = (*pattern.state()->style->patterns.others)[0].surface.mesh;
  for (std::size_t v = 0; v < before.vertex_count(); ++v) {
    EXPECT_EQ(after.positions[v], before.positions[v] + Vec3(0, 0, 1));
  }
}

TEST(LivePattern, FollowsCalmlyAndIsThenGivenByItsAngles) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  EXPECT_EQ(pattern.state()->phases, nullptr);
  SessionDocument next = torus();
  next.strokes = {{{{-0.2, 0.9, 0.3}, {0.2, 0.9, 0.3}}, 0.5, 1}};
  LivePattern afresh;
  afresh.update(next, Follow::afresh);
  pattern.update(next, Follow::last);
  ASSERT_NE(pattern.state()->phases, nullptr);
  EXPECT_TRUE(pattern.state()->figures.followed);

  SessionDocument kept = next;
  kept.phases = pattern.state()->phases;
  LivePattern loaded;
  loaded.update(kept, Follow::afresh);
  EXPECT_EQ(z_of(loaded), z_of(pattern)) << "bit for bit";
  EXPECT_EQ(loaded.state()->figures.branches, pattern.state()->figures.branches);
  EXPECT_NEAR(loaded.state()->figures.energy, pattern.state()->figures.energy,
              1e-5 * std::abs(pattern.state()->figures.energy) + 1e-7);
  // Asked for of the document alone, it is that of the document alone.
  pattern.update(next, Follow::afresh);
  EXPECT_EQ(z_of(pattern), z_of(afresh));
}

TEST(LivePattern, StaysNearToTheLastPattern) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const std::vector<Complex> before = z_of(pattern);
  pattern.update(with(torus(), "stripes", "20.05"), Follow::last);
  const std::vector<Complex>& after = z_of(pattern);
  double near = 0;
  for (std::size_t v = 0; v < after.size(); ++v) {
    near += static_cast<double>(std::abs(std::arg(after[v] * std::conj(before[v])))) /
            static_cast<double>(after.size());
  }
  EXPECT_LT(near, 0.3);
  EXPECT_GT(near, 0);
}

TEST(LivePattern, FollowsWithSlackOnlyWhileSomethingMoves) {
  const SessionDocument first = with(torus(), "slack", "0.3");
  const SessionDocument next = with(first, "stripes", "20.5");
  LivePattern afresh, pattern;
  afresh.update(next, Follow::afresh);
  pattern.update(first, Follow::afresh);
  pattern.update(next, Follow::loosely);
  const StripePattern& draft = pattern.state()->job->result.stripes();
  EXPECT_TRUE(pattern.state()->figures.followed);
  EXPECT_TRUE(stages(pattern).contains("spacing"));
  ASSERT_TRUE(draft.frequency_change);
  for (std::size_t v = 0; v < draft.waves.frequencies.size(); ++v) {
    const float ratio = draft.waves.frequencies[v] / draft.frequencies_wanted[v];
    EXPECT_TRUE(ratio > 1 / 1.3001f && ratio < 1.3001f);
  }
  // At rest it is what the document alone says.
  pattern.update(next, Follow::last);
  EXPECT_EQ(pattern.state()->phases, nullptr);
  EXPECT_EQ(z_of(pattern), z_of(afresh));
}

TEST(LivePattern, FollowsWhileSlackIsMoved) {
  LivePattern pattern;
  pattern.update(with(torus(), "slack", "0.3"), Follow::afresh);
  for (const char* slack : {"0.28", "0.1"}) {
    pattern.update(with(torus(), "slack", slack), Follow::loosely);
    const StripePattern& draft = pattern.state()->job->result.stripes();
    EXPECT_TRUE(pattern.state()->figures.followed);
    const float most = 1 + std::stof(slack);
    float greatest = 0;
    for (std::size_t v = 0; v < draft.waves.frequencies.size(); ++v) {
      const float ratio = draft.waves.frequencies[v] / draft.frequencies_wanted[v];
      EXPECT_TRUE(ratio > 1 / (most + 1e-4f) && ratio < most + 1e-4f);
      greatest = std::max({greatest, ratio, 1 / ratio});
    }
    EXPECT_GT(greatest, 1.01f);
  }
  // Without any, what follows is another animator's.
  pattern.update(torus(), Follow::loosely);
  EXPECT_TRUE(pattern.state()->figures.followed);
  EXPECT_FALSE(pattern.state()->job->result.stripes().frequency_change);
}

TEST(LivePattern, DoesNotDependOnTheNumberOfThreads) {
  const auto solved = [](int threads) {
    const ThreadLimit limit(threads);
    LivePattern pattern;
    pattern.update(torus(), Follow::afresh);
    pattern.update(with(torus(), "stripes", "25"), Follow::last);
    pattern.update(with(torus(), "rotate", "10"), Follow::last);
    return z_of(pattern);
  };
  EXPECT_EQ(solved(1), solved(3));
}

TEST(LivePattern, CancelledAnywhereItStaysAsItWas) {
  SessionDocument other = torus();
  other.mesh = "shape:box,resolution=6";
  other.options["color-by"] = {"height"};
  other.options["with"] = {"shape:torus,resolution=12@striped"};
  testing_support::Reports all;
  LivePattern reference;
  reference.update(other, Follow::afresh, all.progress());
  ASSERT_GT(all.count(), 5);
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const auto state = pattern.state();
  for (int at = 0; at < all.count(); ++at) {
    testing_support::Reports reports(at);
    EXPECT_THROW(pattern.update(other, Follow::last, reports.progress()), Cancelled);
    EXPECT_EQ(pattern.state(), state);
  }
  pattern.update(other, Follow::last);
  EXPECT_EQ(z_of(pattern), z_of(reference));
}

TEST(LivePattern, CancelledWhileFollowingItStaysAsItWas) {
  const SessionDocument next = with(torus(), "stripes", "23");
  LivePattern reference;
  reference.update(torus(), Follow::afresh);
  testing_support::Reports all;
  reference.update(next, Follow::last, all.progress());
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const auto state = pattern.state();
  for (int at = 0; at < all.count(); ++at) {
    testing_support::Reports reports(at);
    EXPECT_THROW(pattern.update(next, Follow::last, reports.progress()), Cancelled);
    EXPECT_EQ(pattern.state(), state);
  }
  pattern.update(next, Follow::last);
  EXPECT_EQ(z_of(pattern), z_of(reference));
}

TEST(LivePattern, FailingItStaysAsItWasAndSaysWhy) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const auto state = pattern.state();
  SessionDocument missing = torus();
  missing.mesh = "nowhere.ply";
  SessionDocument wrong_phases = torus();
  wrong_phases.phases = std::make_shared<const std::vector<float>>(3, 0.0f);
  SessionDocument far_stroke = torus();
  far_stroke.strokes = {{{{100, 0, 0}, {101, 0, 0}}, 0.1, 1}};
  const std::pair<SessionDocument, const char*> failing[] = {
      {missing, "nowhere.ply"},
      {wrong_phases, "leave 'phases' out"},
      {far_stroke, "strokes[0]"},
      {with(torus(), "color-by", "nothing.csv"), "nothing.csv"},
      {with(torus(), "texture", "nothing.png"), "nothing.png"}};
  for (const auto& [document, why] : failing) {
    try {
      pattern.update(document, Follow::last);
      ADD_FAILURE() << why;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
    EXPECT_EQ(pattern.state(), state);
  }
}

TEST(LivePattern, ZoomMakesStripesDenserByItsShare) {
  const auto frequency = [](float zoom, float share) {
    SessionDocument document = torus();
    document.camera.zoom = zoom;
    document.frequency_by_zoom = share;
    LivePattern pattern;
    pattern.update(document, Follow::afresh);
    return pattern.state()->job->result.stripes().waves.frequencies.front();
  };
  EXPECT_FLOAT_EQ(frequency(4, 0), frequency(1, 0));
  EXPECT_FLOAT_EQ(frequency(4, 1), 4 * frequency(1, 0));
  EXPECT_FLOAT_EQ(frequency(4, 0.5f), 2 * frequency(1, 0));
}

TEST(LivePattern, StrokesOfTheDocumentAndOfAFileCountAlike) {
  SessionDocument drawn = torus();
  drawn.strokes = {{{{-0.2, 0.9, 0.3}, {0.2, 0.9, 0.3}}, 0.5, 3}};
  const auto path = std::filesystem::path(testing::TempDir()) / "brindle_live_strokes.json";
  write_strokes(path, drawn.strokes);
  const SessionDocument read = with(torus(), "strokes", path.string());
  LivePattern a, b, none;
  a.update(drawn, Follow::afresh);
  b.update(read, Follow::afresh);
  none.update(torus(), Follow::afresh);
  std::filesystem::remove(path);
  EXPECT_EQ(z_of(a), z_of(b));
  EXPECT_NE(z_of(a), z_of(none));
}

}  // namespace
}  // namespace brindle::tool
