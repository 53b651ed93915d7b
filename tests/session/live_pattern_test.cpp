#include "session/live_pattern.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/shapes.h"
#include "brindle/threads.h"
#include "progress_reports.h"
#include "session/session.h"

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
  for (const auto& [name, time] : pattern.state()->metrics.milliseconds) names.insert(name);
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
  EXPECT_EQ(pattern.state()->metrics.shown.front().first, "curves of u");

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
      moved.options["stripes"] = {formatted("%.2f", 20 + 0.08 * step)};
      pattern.update(moved, Follow::loosely);
      steps.push_back(pattern.state()->metrics.phase_step);
    }
    std::ranges::sort(steps);
    EXPECT_LT(steps[steps.size() / 2], 0.1) << kind << ": tiles glide, but where rows come and go";
    EXPECT_GT(pattern.state()->metrics.phase_step, 0) << kind;
    const Report& followed = pattern.state()->report();
    EXPECT_GT(followed.energy, 0) << kind;
    EXPECT_EQ(pattern.state()->phases, nullptr) << "no document can keep them";
    const std::size_t singularities = followed.quality.field_singularities;
    const std::size_t triangles = pattern.state()->job->surface->mesh.triangle_count();

    pattern.update(moved, Follow::last);
    EXPECT_EQ(pattern.state()->metrics.phase_step, 0) << "made of the document alone";
    EXPECT_EQ(pattern.state()->report().quality.field_singularities, singularities);
    EXPECT_EQ(pattern.state()->job->surface->mesh.triangle_count(), triangles);
    LivePattern afresh;
    afresh.update(moved, Follow::afresh);
    const auto& waves = [](const LivePattern& of) -> const TextureWaves& {
      return of.state()->job->result.texture()->pattern.waves;
    };
    ASSERT_EQ(waves(pattern).u.size(), waves(afresh).u.size());
    EXPECT_EQ(pattern.state()->report().energy, afresh.state()->report().energy);
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

TEST(LivePattern, MeasuresCurvesWhileNothingMoves) {
  SessionDocument document = torus();
  document.shown = Shown::curves;
  document.curves = {{"lines", {"both"}}, {"join", {}}};
  LivePattern few, all(CurveMetrics::all);
  const auto metrics = [](const LivePattern& pattern) {
    std::map<std::string, double> named;
    for (const auto& [name, value] : pattern.state()->metrics.shown) {
      EXPECT_TRUE(named.emplace(name, value).second) << name << " is there twice";
    }
    return named;
  };
  few.update(document, Follow::afresh);
  all.update(document, Follow::afresh);
  const auto quick = metrics(few), whole = metrics(all);
  for (const auto& [name, value] : quick) EXPECT_EQ(whole.at(name), value) << name;
  for (const char* family : {" of u", " of v"}) {
    for (const std::string name : {"gaps", "spacing"}) {
      EXPECT_FALSE(quick.contains(name + family));
      EXPECT_GT(whole.at(name + family), 0);
    }
  }
  EXPECT_TRUE(whole.contains("winding loop-1 (u)"));
  // A draft has what was measured of the same curves, and measures no others.
  document.camera.azimuth_deg = 77;
  all.update(document, Follow::loosely);
  EXPECT_EQ(metrics(all), whole);
  EXPECT_TRUE(stages(all).empty());
  document.curves["min-length"] = {"5%"};
  all.update(document, Follow::loosely);
  EXPECT_FALSE(metrics(all).contains("gaps of u"));
  all.update(document, Follow::last);
  EXPECT_TRUE(metrics(all).contains("gaps of u"));
  EXPECT_EQ(stages(all), std::set<std::string>{"curves"});
}

TEST(LivePattern, MeasuresNoMoreCurvesThanOneWaitsFor) {
  SessionDocument document = torus();
  document.shown = Shown::curves;
  LivePattern brief(CurveMetrics::brief);
  const auto has_gaps = [&] {
    return std::ranges::any_of(brief.state()->metrics.shown,
                               [](const auto& metric) { return metric.first == "gaps of u"; });
  };
  const auto says_so = [&] {
    return std::ranges::any_of(brief.state()->notes, [](const std::string& note) {
      return note.find("take long to measure") != note.npos;
    });
  };
  brief.update(document, Follow::afresh);
  EXPECT_TRUE(has_gaps());
  EXPECT_FALSE(says_so());
  document.options["stripes"] = {"300"};
  brief.update(document, Follow::afresh);
  EXPECT_FALSE(has_gaps());
  EXPECT_TRUE(says_so());
}

TEST(LivePattern, WarnsOfMotifsThatAreLeftOut) {
  SessionDocument document = with(torus(), "texture", "arrows");
  LivePattern pattern(CurveMetrics::brief);
  const auto warns = [&] {
    return std::ranges::any_of(pattern.state()->notes, [](const std::string& note) {
      return note.find("the others are left out") != note.npos;
    });
  };
  pattern.update(document, Follow::afresh);
  EXPECT_FALSE(warns());
  document.mesh = "shape:sphere,noise=1,resolution=32";
  document.options["field"] = {"raw-curvature"};
  document.options["stripes"] = {"60"};
  pattern.update(document, Follow::afresh);
  EXPECT_TRUE(warns());
}

TEST(LivePattern, ReadsAndSolvesForAStyleOnce) {
  SessionDocument document = with(torus(), "color-by", "height");
  document.options["with"] = {"shape:box,resolution=6@striped"};
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  EXPECT_TRUE(stages(pattern).contains("style"));
  const std::uint64_t drawn = pattern.state()->pattern;
  pattern.update(with(document, "color-range", "0..1"), Follow::last);
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

TEST(LivePattern, ReadsValuesOfOtherSurfacesAlone) {
  SessionDocument document = with(torus(), "with", "shape:box,resolution=6@striped@#ffffff");
  LivePattern pattern;
  pattern.update(document, Follow::afresh);
  const auto others = pattern.state()->style->patterns.others;
  const auto values = [&] { return pattern.state()->style->input.values.others.at(0); };
  EXPECT_FALSE(values());
  pattern.update(with(document, "with", "shape:box,resolution=6@striped@color-by=height@#ffffff"),
                 Follow::last);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"style"});
  EXPECT_EQ(pattern.state()->style->patterns.others, others);
  ASSERT_TRUE(values());
  EXPECT_EQ(values()->values.size(), (*others)[0].surface.mesh.vertex_count());
  // They are those of the place to which the surface is moved.
  const auto before = values()->values;
  pattern.update(with(document, "with", "shape:box,resolution=6@striped@color-by=height@0,0,2"),
                 Follow::last);
  ASSERT_TRUE(values());
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_FLOAT_EQ(values()->values[v], before[v] + 2);
  }
  pattern.update(with(document, "with", "shape:box,resolution=6@texture=dots@color-by=curvature"),
                 Follow::last);
  EXPECT_NE(pattern.state()->style->patterns.others, others);
  EXPECT_NE((*pattern.state()->style->patterns.others)[0].result->texture(), nullptr);
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
  EXPECT_TRUE(pattern.state()->phases != nullptr);

  SessionDocument kept = next;
  kept.phases = pattern.state()->phases;
  LivePattern loaded;
  loaded.update(kept, Follow::afresh);
  EXPECT_EQ(z_of(loaded), z_of(pattern)) << "bit for bit";
  EXPECT_EQ(loaded.state()->report().quality.branches, pattern.state()->report().quality.branches);
  EXPECT_NEAR(loaded.state()->report().energy, pattern.state()->report().energy,
              1e-5 * std::abs(pattern.state()->report().energy) + 1e-7);
  // Asked for of the document alone, it is that of the document alone.
  pattern.update(next, Follow::afresh);
  EXPECT_EQ(z_of(pattern), z_of(afresh));
}

// How far phases are from others, on average, in radians: those that have nothing to do with each
// other are pi / 2 apart.
double distance_of(const std::vector<Complex>& a, const std::vector<Complex>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    sum += static_cast<double>(std::abs(std::arg(a[v] * std::conj(b[v]))));
  }
  return sum / static_cast<double>(a.size());
}

TEST(LivePattern, StaysNearToTheLastPattern) {
  LivePattern pattern, afresh;
  pattern.update(torus(), Follow::afresh);
  const std::vector<Complex> before = z_of(pattern);
  // Half a stripe more along the diagonal would have to move phases by 0.4 radians.
  const SessionDocument next = with(torus(), "stripes", "20.2");
  pattern.update(next, Follow::loosely);
  afresh.update(next, Follow::afresh);
  const double followed = distance_of(z_of(pattern), before);
  EXPECT_GT(followed, 0);
  EXPECT_LT(followed, 0.3);
  EXPECT_GT(distance_of(z_of(afresh), before), 3 * followed)
      << "the document alone says nothing of where stripes were";
  EXPECT_NEAR(pattern.state()->metrics.phase_step, followed, 1e-3);
}

SessionDocument lit(float azimuth) {
  SessionDocument document = torus();
  document.mesh = "shape:torus,resolution=60";
  document.options["frequency-by"] = {"light"};
  document.options["frequency-range"] = {"0.5..2"};
  document.camera.azimuth_deg = azimuth;
  return document;
}

// A worst case for what follows: phases of one light in another.
SessionDocument misfitting() {
  LivePattern pattern;
  pattern.update(lit(30), Follow::afresh);
  SessionDocument document = lit(150);
  std::vector<float> angles;
  for (const Complex& z : z_of(pattern)) angles.push_back(std::arg(z));
  document.phases = std::make_shared<const std::vector<float>>(std::move(angles));
  return document;
}

TEST(LivePattern, PhasesThatNoLongerFitAreSolvedAnew) {
  LivePattern pattern, afresh;
  pattern.update(misfitting(), Follow::afresh);
  afresh.update(lit(150), Follow::afresh);
  EXPECT_EQ(z_of(pattern), z_of(afresh)) << "bit for bit";
  EXPECT_EQ(pattern.state()->phases, nullptr) << "it is made of the document alone";
  EXPECT_FALSE(pattern.state()->phases != nullptr);
  ASSERT_EQ(pattern.state()->notes.size(), 1);
  EXPECT_TRUE(pattern.state()->notes.front().starts_with("solved again: "));
  EXPECT_TRUE(stages(pattern).contains("solve"));
  // As long as nothing changes, nothing is done again, whether something moves or not.
  SessionDocument turned = misfitting();
  turned.options["stripe-width"] = {"0.3"};
  pattern.update(turned, Follow::loosely);
  pattern.update(turned, Follow::last);
  EXPECT_TRUE(stages(pattern).empty());
  EXPECT_EQ(z_of(pattern), z_of(afresh));
}

// What has followed so far behind that it is shredded: half a turn at once.
TEST(LivePattern, AtRestWhatFollowedIsNoWorseThanTheBound) {
  for (const char* mesh : {"shape:torus,resolution=60", "shape:trefoil,resolution=40"}) {
    SessionDocument document = torus();
    document.mesh = mesh;
    document.options["stripes"] = {"60"};
    LivePattern pattern;
    pattern.update(document, Follow::afresh);
    for (const char* stripes : {"50", "40", "30", "22", "15", "12", "15", "20"}) {
      document.options["stripes"] = {stripes};
      pattern.update(document, Follow::loosely);
      EXPECT_NE(pattern.state()->phases, nullptr) << "while it moves, it follows";
      const Report draft = pattern.state()->report();
      LivePattern resting;
      resting.update(document, Follow::afresh);
      const Report& alone = resting.state()->report();
      pattern.update(document, Follow::last);
      const Report& rest = pattern.state()->report();
      EXPECT_LE(rest.energy, kMostEnergyTimes * alone.energy + kMostEnergyMore + 1e-5);
      EXPECT_LE(rest.quality.spacing_error_mean,
                alone.quality.spacing_error_mean + kMostSpacingErrorMore);
      EXPECT_EQ(pattern.state()->phases != nullptr,
                draft.energy <= kMostEnergyTimes * alone.energy + kMostEnergyMore &&
                    draft.quality.spacing_error_mean <=
                        alone.quality.spacing_error_mean + kMostSpacingErrorMore);
      // What is saved of it comes back as it was.
      SessionDocument kept = document;
      kept.phases = pattern.state()->phases;
      LivePattern loaded;
      loaded.update(kept, Follow::afresh);
      EXPECT_EQ(z_of(loaded), z_of(pattern)) << mesh << ", " << stripes;
    }
  }
}

TEST(LivePattern, AtRestItIsComparedOnce) {
  LivePattern pattern;
  pattern.update(torus(), Follow::afresh);
  const SessionDocument next = with(torus(), "stripes", "20.3");
  pattern.update(next, Follow::loosely);
  const std::vector<Complex> followed = z_of(pattern);
  EXPECT_FALSE(stages(pattern).contains("compare"));
  pattern.update(next, Follow::last);
  EXPECT_EQ(stages(pattern), std::set<std::string>{"compare"});
  EXPECT_EQ(z_of(pattern), followed);
  SessionDocument kept = next;
  kept.phases = pattern.state()->phases;
  kept.camera.azimuth_deg = 70;
  pattern.update(kept, Follow::loosely);
  pattern.update(kept, Follow::last);
  EXPECT_TRUE(stages(pattern).empty());
}

// One place says what stripes follow from: what a session keeps phases through is what a live
// pattern keeps its pattern through.
TEST(LivePattern, SessionsKeepPhasesAsLongAsPatternsStay) {
  SessionDocument by_camera = torus(), by_light = torus(), by_height = torus();
  by_camera.options["frequency-by"] = {"distance:camera"};
  by_light.options["frequency-by"] = {"light"};
  by_height.options["frequency-by"] = {"height"};
  const SessionCommand changes[] = {
      commands::set_camera({80, 20, 1}),
      commands::set_option("up", {"y"}),
      session_command("set_size", {{"size", size_to_json({200, 120})}}),
      commands::set_option("light-from", {"60,10"}),
      commands::set_option("slice", {"z=40%"}),
      commands::set_option("stripe-width", {"0.3"}),
      commands::set_option("stripes", {"25"}),
      commands::set_option("sweeps", {"7"}),
      commands::set_frequency_by_zoom(0.5f),
      commands::show(Shown::curves),
      commands::set_option("width-by", {"light"})};
  int kept = 0;
  for (const SessionDocument& document : {torus(), by_camera, by_light, by_height}) {
    LivePattern pattern;
    pattern.update(document, Follow::afresh);
    const auto phases = std::make_shared<const std::vector<float>>(z_of(pattern).size(), 0.5f);
    for (const SessionCommand& change : changes) {
      Session session(document);
      session.keep_phases(session.revision(), phases);
      ASSERT_TRUE(session.apply(change)) << session.messages().back().text;
      SessionDocument after = session.document();
      after.phases = nullptr;
      LivePattern changed;
      changed.update(document, Follow::afresh);
      changed.update(after, Follow::afresh);
      const bool same = session.document().phases != nullptr;
      EXPECT_EQ(stages(changed).contains("solve"), !same)
          << change.dump() << " of " << document_to_json(document).dump();
      kept += same ? 1 : 0;
    }
  }
  EXPECT_EQ(kept, 9 + 6 + 5 + 8) << "neither all nor none";
}

TEST(LivePattern, FollowsWithSlackOnlyWhileSomethingMoves) {
  const SessionDocument first = with(torus(), "slack", "0.3");
  const SessionDocument next = with(first, "stripes", "20.5");
  LivePattern afresh, pattern;
  afresh.update(next, Follow::afresh);
  pattern.update(first, Follow::afresh);
  pattern.update(next, Follow::loosely);
  const StripePattern& draft = pattern.state()->job->result.stripes();
  EXPECT_TRUE(pattern.state()->phases != nullptr);
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
  // The smooth field of a torus has no curl to yield to until it is turned.
  const SessionDocument turned = with(torus(), "rotate", "40");
  LivePattern pattern;
  pattern.update(with(turned, "slack", "0.3"), Follow::afresh);
  for (const char* slack : {"0.28", "0.1"}) {
    pattern.update(with(turned, "slack", slack), Follow::loosely);
    const StripePattern& draft = pattern.state()->job->result.stripes();
    EXPECT_TRUE(pattern.state()->phases != nullptr);
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
  pattern.update(turned, Follow::loosely);
  EXPECT_TRUE(pattern.state()->phases != nullptr);
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
  for (const int at : testing_support::reports_to_cancel(all.count())) {
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
  for (const int at : testing_support::reports_to_cancel(all.count())) {
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

// Most files say nothing of which axis points up: then heights are z, and say so where pictures
// have y up.
TEST(LivePattern, HeightsFollowTheAxisThatIsSaidToPointUp) {
  const auto path = std::filesystem::path(testing::TempDir()) / "brindle_heights.obj";
  const Mesh box = make_shape("box,resolution=6");
  write_mesh(path, box);
  const auto stl = std::filesystem::path(testing::TempDir()) / "brindle_heights.stl";
  std::ofstream text(stl);
  text << "solid box\n";
  for (const Triangle& triangle : box.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const Index v : triangle) text << "vertex " << box.positions[v].transpose() << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid box\n";
  text.close();
  struct Case {
    std::string mesh, up, title;
    int axis;
    float sign = 1;
  };
  const Case cases[] = {{path.string(), "", "height (z)", 2},
                        {path.string(), "y", "height", 1},
                        {path.string(), "z", "height", 2},
                        {path.string(), "-x", "height", 0, -1},
                        {stl.string(), "", "height", 2},
                        {"shape:box,resolution=6", "", "height", 2},
                        {"shape:box,resolution=6", "y", "height", 1}};
  for (const Case& one : cases) {
    SessionDocument document = with(with(torus(), "color-by", "height"), "frequency-by", "height");
    document.options["frequency-range"] = {"0.5..2"};
    document.mesh = one.mesh;
    if (!one.up.empty()) document.options["up"] = {one.up};
    LivePattern pattern;
    pattern.update(document, Follow::afresh);
    const LiveState& state = *pattern.state();
    const VertexValues& heights = *state.style->input.values.color;
    EXPECT_EQ(heights.title, one.title) << one.mesh << " --up " << one.up;
    const Mesh& mesh = state.job->surface->mesh;
    const FrequencyField& frequencies = state.job->result.stripes().waves.frequencies;
    const auto lowest = std::ranges::min_element(heights.values) - heights.values.begin();
    const auto highest = std::ranges::max_element(heights.values) - heights.values.begin();
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_FLOAT_EQ(heights.values[v], one.sign * mesh.positions[v][one.axis]);
    }
    EXPECT_LT(frequencies[static_cast<std::size_t>(lowest)],
              0.5f * frequencies[static_cast<std::size_t>(highest)])
        << "frequencies and colours have the same heights";
  }
  std::filesystem::remove(stl);
  std::filesystem::remove(path);
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
