#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "apps/tool.h"
#include "brindle/image.h"
#include "pictures/drawing_file.h"
#include "session/session.h"
#include "session/session_export.h"
#include "session/session_worker.h"

namespace brindle::tool {
namespace {

using test::content;

SessionDocument small_document() {
  SessionDocument document;
  document.mesh = "shape:torus,resolution=24";
  document.size = {160, 120};
  return document;
}

struct RenderTool : test::ToolTest {
  /// The bytes of the picture that the tool draws of a session.
  std::string rendered(const SessionDocument& document,
                       const std::vector<std::string>& more = {}) const {
    write_session(folder / "s.json", document);
    std::vector<std::string> arguments = {"render", "s.json", "--output", "s.png", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const test::ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "s.png");
  }
};

TEST_F(RenderTool, DrawsWhatStripeDraws) {
  const std::vector<OptionValues> looks = {
      {{"stripes", {"30"}}, {"along", {}}},
      {{"color-by", {"height"}}, {"width-by", {"height"}}, {"outline", {"dashed"}}},
      {{"texture", {"arrows"}}, {"field", {"curvature"}}},
      {{"with", {"shape:sphere@striped", "shape:box@#303030"}}, {"between", {"nothing"}}},
      {{"with", {"shape:sphere@striped@stripes=9@stripe-width=0.2@stripe-color=#ff0000"}}},
      {{"with", {"shape:sphere@color-by=height@outlined", "shape:box@texture=dots@0,0,1.5"}}},
      {{"with", {"shape:sphere@discarded@texture=plus@color-by=curvature", "shape:box@outlined"}},
       {"color-by", {"height"}}},
      {{"slack", {"0.2"}}, {"view", {"branches"}}, {"direction", {"-1,0.3,0"}}}};
  for (const OptionValues& options : looks) {
    SessionDocument document = small_document();
    document.options = options;
    document.camera = {50, 35, 1.5f};
    std::vector<std::string> arguments = {"stripe", document.mesh, "--camera=50,35,1.5",
                                          "--size", "160x120",     "--output",
                                          "a.png",  "--quiet"};
    for (const auto& [name, values] : options) {
      if (values.empty()) arguments.push_back("--" + name);
      for (const std::string& value : values) arguments.push_back("--" + name + "=" + value);
    }
    const test::ToolResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(rendered(document), content(folder / "a.png")) << options.begin()->first;
  }
}

TEST_F(RenderTool, DrawsAndWritesWhatCurvesAndSampleDo) {
  struct Case {
    Shown shown;
    OptionValues options, own;
    std::string file;
  };
  const std::vector<Case> cases = {
      {Shown::curves, {{"stripes", {"30"}}}, {{"join", {}}, {"min-length", {"3%"}}}, "a.vtp"},
      {Shown::curves,
       {{"direction", {"-1,0.3,0"}}, {"slack", {"0.2"}}},
       {{"lines", {"both"}}, {"stripes-v", {"25"}}, {"offset", {"0.5"}}, {"tube-radius", {"0.5%"}}},
       "a.ply"},
      {Shown::samples, {{"field", {"curvature"}}}, {{"min-distance", {"0.5"}}}, "a.vtp"},
      {Shown::samples,
       {{"stripes", {"20"}}},
       {{"glyph", {"arrow"}}, {"color-by", {"height"}}, {"size-by", {"distance:camera"}}},
       "a.csv"}};
  for (const auto& [shown, options, own, file] : cases) {
    SessionDocument document = small_document();
    document.shown = shown;
    document.options = options;
    (shown == Shown::curves ? document.curves : document.samples) = own;
    document.camera = {50, 35, 1.5f};
    std::vector<std::string> arguments = {shown == Shown::curves ? "curves" : "sample",
                                          document.mesh,
                                          "--camera=50,35,1.5",
                                          "--size=160x120",
                                          "--output=a.png",
                                          "--output=" + file,
                                          "--quiet"};
    for (const auto& [name, values] : shown_options(document)) {
      arguments.push_back("--" + name + (values.empty() ? "" : "=" + values.front()));
    }
    const test::ToolResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(rendered(document, {"--output", "b_" + file}), content(folder / "a.png")) << file;
    EXPECT_EQ(content(folder / ("b_" + file)), content(folder / file)) << file;
  }
}

// Times alone may differ.
TEST_F(RenderTool, ReportsOfCurvesWhatCurvesReports) {
  struct Case {
    std::string mesh;
    OptionValues options, own;
  };
  const std::vector<Case> cases = {
      {"shape:torus,resolution=24",
       {{"stripes", {"30"}}},
       {{"join", {}}, {"min-length", {"3%"}}, {"resample", {"2%"}}}},
      {"shape:torus,resolution=24",
       {{"slack", {"0.2"}}, {"cancel-branches", {"0.1"}}},
       {{"lines", {"both"}}, {"offset", {"0.3"}}, {"wales", {"loop-1:5"}}, {"path-width", {"1%"}}}},
      {"shape:tube,resolution=24",
       {{"field", {"curvature"}}, {"curvature-direction", {"min"}}, {"winding", {"0"}}},
       {{"trim", {"0.5"}}, {"fair", {"0.25"}}}}};
  for (const auto& [mesh, options, own] : cases) {
    SessionDocument document = small_document();
    document.mesh = mesh;
    document.shown = Shown::curves;
    document.options = options;
    document.curves = own;
    std::vector<std::string> arguments = {"curves", document.mesh, "--report=a.json", "--quiet"};
    for (const auto& [name, values] : shown_options(document)) {
      if (name == "curvature-direction") continue;  // a part of --field
      arguments.push_back("--" + name + (values.empty() ? "" : "=" + values.front()));
      const auto part = options.find("curvature-direction");
      if (name == "field" && part != options.end()) arguments.back() += "," + part->second.front();
    }
    const test::ToolResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    rendered(document, {"--output", "b.json"});
    const auto report = [&](const char* name) {
      auto json = nlohmann::json::parse(content(folder / name));
      for (const char* own_key : {"milliseconds", "options", "picture_quality"})
        json.erase(own_key);
      return json;
    };
    EXPECT_EQ(report("a.json"), report("b.json"));
    EXPECT_TRUE(report("b.json")["u"].contains("gaps"));
    EXPECT_TRUE(report("b.json")["u"].contains("loops"));
  }
}

TEST_F(RenderTool, RefusesFilesThatWhatIsShownHasNot) {
  std::ofstream(folder / "points.csv") << "x,y,z\n0,0,0\n1,0,0\n0,1,0\n1,1,0\n0,2,0\n1,2,0\n";
  SessionDocument document = small_document();
  document.shown = Shown::curves;
  write_session(folder / "curves.json", document);
  document.mesh = (folder / "points.csv").string();
  write_session(folder / "points.json", document);
  document = small_document();
  document.shown = Shown::samples;
  write_session(folder / "samples.json", document);
  struct Case {
    const char *session, *output;
    int exit_code;
    const char* why;
  };
  for (const auto& [session, output, exit_code, why] :
       {Case{"curves.json", "a.glb", 2, "ask for tubes with --tube-radius"},
        Case{"samples.json", "a.obj", 2, "files hold no samples"},
        Case{"points.json", "a.png", 1, "curves need triangles"}}) {
    const test::ToolResult result = run({"render", session, "--output", output});
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_NE(result.err.find(why), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / output));
  }
}

TEST_F(RenderTool, DrawsWhatTheWindowShows) {
  SessionWorker worker;
  Session session(small_document());
  const auto show = [&](PictureQuality quality) {
    worker.request({session.document(), session.revision(), quality,
                    session.follows() ? Follow::last : Follow::afresh});
    worker.wait();
    session.keep_phases(worker.latest()->revision, worker.latest()->state->phases);
  };
  show(PictureQuality::final);
  session.apply(commands::set_option("stripes", {"23"}));
  show(PictureQuality::interactive);
  show(PictureQuality::final);
  ASSERT_NE(session.document().phases, nullptr) << "it followed";
  EXPECT_EQ(rendered(session.document()), png_of(worker.latest()->image));
}

TEST_F(RenderTool, ReplayedCommandsGiveThePictureOfTheirScript) {
  const std::vector<SessionCommand> commands = {
      commands::set_option("stripes", {"30"}),
      session_command("begin_drag"),
      commands::set_camera({10, 20, 1}),
      commands::set_camera({60, 20, 1.4f}),
      session_command("end_drag"),
      commands::add_stroke({{{-0.2, 0.9, 0.3}, {0.2, 0.9, 0.3}}, 0.5, 2}),
      commands::set_option("stripe-width", {"0.2"}),
      session_command("undo"),
      commands::store_view(2)};
  write_commands(folder / "events.jsonl", commands);
  Session session(small_document());
  for (const SessionCommand& command : commands) EXPECT_TRUE(session.apply(command));
  const std::string replayed = rendered(small_document(), {"--replay", "events.jsonl"});
  EXPECT_EQ(replayed, rendered(session.document()));
  EXPECT_NE(replayed, rendered(small_document()));
}

TEST_F(RenderTool, SaysWhichCommandIsRefused) {
  write_session(folder / "s.json", small_document());
  write_commands(folder / "e.jsonl",
                 {commands::set_option("stripes", {"9"}), session_command("redo")});
  expect_refusal(1, "e.jsonl: command 2, redo",
                 {"render", "s.json", "-o", "a.png", "--replay", "e.jsonl"});
}

TEST_F(RenderTool, OutputsMustSuit) {
  write_session(folder / "s.json", small_document());
  expect_refusal(2, "--output is required", {"render", "s.json"});
  expect_refusal(2, "--quality: has no effect here: it is for pixels",
                 {"render", "s.json", "-o", "a.svg", "--quality", "interactive"});
  expect_refusal(2, "--dpi: has no effect here: it is for pixels",
                 {"render", "s.json", "-o", "a.svg", "--dpi", "300"});
  expect_refusal(2, "--dpi", {"render", "s.json", "-o", "a.png", "--dpi", "0"});
  expect_refusal(2, "use .png for a picture, .svg or", {"render", "s.json", "-o", "a.jpg"});
  expect_refusal(2, "is read by SESSION", {"render", "s.json", "-o", "s.json"});
  expect_refusal(2, "--size", {"render", "s.json", "-o", "a.vtp", "--size", "10x10"});
  expect_refusal(2, "--transparent", {"render", "s.json", "-o", "a.vtp", "--transparent"});
  expect_refusal(1, "t.json", {"render", "t.json", "-o", "a.png"});
  EXPECT_EQ(run({"render", "s.json", "-o", "a.vtp", "-o", "r.json", "-q"}).exit_code, 0);
  EXPECT_EQ(run({"stripe", "shape:torus,resolution=24", "-o", "b.vtp", "-q"}).exit_code, 0);
  EXPECT_EQ(content(folder / "a.vtp"), content(folder / "b.vtp"));
}

TEST_F(RenderTool, DrawingsAreThoseOfStripeAndCurves) {
  SessionDocument document = small_document();
  document.options = {{"stripes", {"20"}}, {"outline", {"solid"}}};
  document.camera = {50, 35, 1.5f};
  for (const Shown shown : {Shown::stripes, Shown::curves}) {
    document.shown = shown;
    write_session(folder / "s.json", document);
    for (const std::string kind : {".svg", ".pdf"}) {
      if (!drawing_refusal("a" + kind).empty()) continue;
      std::vector<std::string> arguments = {std::string(command_of(shown)),
                                            document.mesh,
                                            "--camera=50,35,1.5",
                                            "--size=160x120",
                                            "--stripes=20",
                                            "--output=a" + kind,
                                            "--quiet"};
      if (shown == Shown::stripes) arguments.emplace_back("--outline=solid");
      ASSERT_EQ(run(arguments).exit_code, 0);
      ASSERT_EQ(run({"render", "s.json", "-q", "-o", "b" + kind}).exit_code, 0);
      EXPECT_EQ(content(folder / ("a" + kind)), content(folder / ("b" + kind))) << kind;
    }
  }
}

TEST_F(RenderTool, DrawingsOfTilesAreThoseOfStripe) {
  for (const bool cross : {false, true}) {
    SessionDocument document = small_document();
    document.options = {{"stripes", {"12"}}, {"texture", {"plus"}}};
    if (cross) document.options["cross"] = {};
    write_session(folder / "s.json", document);
    std::vector<std::string> arguments = {"stripe",         document.mesh,    "--stripes=12",
                                          "--texture=plus", "--size=160x120", "--output=a.svg",
                                          "--quiet"};
    if (cross) arguments.emplace_back("--cross");
    ASSERT_EQ(run(arguments).exit_code, 0);
    ASSERT_EQ(run({"render", "s.json", "-q", "-o", "b.svg"}).exit_code, 0);
    EXPECT_EQ(content(folder / "a.svg"), content(folder / "b.svg"));
    EXPECT_NE(content(folder / "a.svg").find("tiles"), std::string::npos);
  }
}

TEST_F(RenderTool, DrawingsShowOutlinesAlone) {
  write_png(folder / "tile.png", Image(4, 4));
  const std::pair<OptionValues, const char*> refused[] = {
      {{{"view", {"branches"}}}, "--view has colours"},
      {{{"texture", {"tile.png"}}}, "picture of pixels"},
      {{{"color-by", {"height"}}}, "--color-by"},
      {{{"transparent", {}}}, "no background"}};
  for (const auto& [options, why] : refused) {
    SessionDocument document = small_document();
    document.options = options;
    write_session(folder / "s.json", document);
    expect_refusal(2, why, {"render", "s.json", "-o", "a.svg"});
    EXPECT_THROW(planned_picture(document, {}, folder / "a.svg"), CLI::ValidationError);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.svg"));
  }
  SessionDocument document = small_document();
  document.shown = Shown::samples;
  write_session(folder / "s.json", document);
  expect_refusal(2, "files hold no samples", {"render", "s.json", "-o", "a.svg"});
}

TEST_F(RenderTool, PrintsLookLikeTheWindow) {
  struct Case {
    OptionValues options, scaled;
  };
  const Case cases[] = {{{{"pixel-width", {"3"}}, {"stroke-spacing", {"10"}}},
                         {{"pixel-width", {"7.5"}}, {"stroke-spacing", {"25"}}}},
                        {{{"width-by", {"height"}}, {"width-range", {"1px..4px"}}},
                         {{"width-by", {"height"}}, {"width-range", {"2.5px..10px"}}}},
                        {{{"outline", {"solid"}}, {"line-width", {"2"}}},
                         {{"outline", {"solid"}}, {"line-width", {"5"}}}}};
  for (const auto& [options, scaled] : cases) {
    SessionDocument small = small_document(), large = small;
    small.options = options;
    large.options = scaled;
    large.size = {400, 320};  // two and a half times as wide
    EXPECT_EQ(with_changes(small, {large.size, false, true}), large);
    const std::string print = rendered(small, {"--size", "400x320", "--scale-widths"});
    EXPECT_EQ(print, rendered(large));
    EXPECT_NE(print, rendered(small, {"--size", "400x320"}));
  }
}

TEST_F(RenderTool, WithoutABackgroundAsIfTheSessionSaidSo) {
  SessionDocument document = small_document(), transparent = document;
  transparent.options["transparent"] = {};
  EXPECT_EQ(rendered(document, {"--transparent"}), rendered(transparent));
  EXPECT_EQ(rendered(document, {"--dpi", "300"}).size(), rendered(document).size() + 21);
  EXPECT_NE(rendered(document), rendered(transparent));
}

TEST_F(RenderTool, ChangesWithoutEffectAreRefused) {
  SessionDocument document = small_document();
  write_session(folder / "s.json", document);
  expect_refusal(1, "no width is measured in pixels",
                 {"render", "s.json", "-o", "a.png", "--size", "9x9", "--scale-widths"});
  document.shown = Shown::curves;
  write_session(folder / "s.json", document);
  expect_refusal(2, "--transparent", {"render", "s.json", "-o", "a.png", "--transparent"});
  document.shown = Shown::stripes;
  document.options["pixel-width"] = {"3"};
  write_session(folder / "s.json", document);
  expect_refusal(2, "--scale-widths requires --size",
                 {"render", "s.json", "-o", "a.png", "--scale-widths"});
  EXPECT_THROW(with_changes(document, {PictureSize{0, 5}}), Error);
  EXPECT_THROW(with_changes(document, {PictureSize{kMaxImageSide + 1, 5}}), Error);
  document.options["pixel-width"] = {"3000"};
  EXPECT_THROW(with_changes(document, {PictureSize{1600, 1200}, false, true}), CLI::ValidationError)
      << "wider than --pixel-width takes";
}

/// Cancels at the first report behind a share of the job.
class CancelledAt : public JobListener {
 public:
  explicit CancelledAt(double share) : share_(share) {}
  void note(const std::string&) override {}

 private:
  Progress whole_progress() override {
    return Progress([this](const ProgressReport& report) { return report.fraction <= share_; });
  }
  double share_;
};

TEST_F(RenderTool, ExportsAreWhatRenderDrawsOrNothing) {
  SessionDocument document = small_document();
  document.options["pixel-width"] = {"3"};
  const PictureChanges changes{PictureSize{320, 240}, true, true};
  for (const std::string kind : {".png", ".svg"}) {
    PictureChanges fitting = changes;
    fitting.transparent = kind == ".png";
    const std::filesystem::path path = folder / ("e" + kind);
    const SessionDocument planned = planned_picture(document, fitting, path);
    for (const double share : {0.0, 0.3, 0.7}) {
      CancelledAt listener(share);
      EXPECT_THROW(export_picture(planned, path, 0, listener), Cancelled) << kind << share;
      EXPECT_FALSE(std::filesystem::exists(path));
    }
    CancelledAt never(2);
    export_picture(planned, path, 0, never);
    write_session(folder / "s.json", document);
    std::vector<std::string> arguments = {"render",  "s.json",         "-q", "--size",
                                          "320x240", "--scale-widths", "-o", "r" + kind};
    if (fitting.transparent) arguments.emplace_back("--transparent");
    ASSERT_EQ(run(arguments).exit_code, 0);
    EXPECT_EQ(content(path), content(folder / ("r" + kind))) << kind;
  }
}

// The window shows an empty picture and says why; no file has it.
TEST_F(RenderTool, PicturesOfWhichASliceLeavesNothingAreNotWritten) {
  for (const Shown shown : kAllShown) {
    SessionDocument document = small_document();
    document.shown = shown;
    document.options["slice"] = {"z=-9"};
    write_session(folder / "s.json", document);
    std::vector<std::string> files = {"s.png"};
    if (shown != Shown::samples) files.emplace_back("s.svg");
    for (const std::string& file : files) {
      const test::ToolResult result = run({"render", "s.json", "-q", "-o", file});
      EXPECT_EQ(result.exit_code, 1) << file;
      EXPECT_NE(result.err.find("--slice leaves nothing"), std::string::npos) << result.err;
      EXPECT_FALSE(std::filesystem::exists(folder / file));
    }
    SessionWorker worker;
    worker.request({document, 1, PictureQuality::interactive});
    worker.wait();
    ASSERT_TRUE(worker.latest());
    EXPECT_NE(worker.latest()->nothing_left.find("--slice"), std::string::npos);
    document.options["slice"] = {"z=50%"};
    worker.request({document, 2, PictureQuality::final});
    worker.wait();
    EXPECT_EQ(worker.latest()->nothing_left, "");
  }
}

// What other surfaces look like is drawn anew, and solved for only where it must be.
TEST_F(RenderTool, StylesOfOtherSurfacesAreThoseOfASessionDrawnAfresh) {
  SessionDocument document = small_document();
  SessionWorker worker;
  std::uint64_t revision = 0;
  std::shared_ptr<const std::vector<OtherSurface>> last;
  const auto expect_afresh = [&](const std::string& style, bool solved) {
    document.options["with"] = {"shape:sphere,radius=1.2,resolution=10" + style};
    worker.request({document, ++revision, PictureQuality::final, Follow::last});
    worker.wait();
    write_png(folder / "w.png", worker.latest()->image);
    EXPECT_EQ(content(folder / "w.png"), rendered(document)) << style;
    const auto& others = worker.latest()->state->style->patterns.others;
    EXPECT_EQ(others != last, solved) << style;
    last = others;
  };
  expect_afresh("@striped", true);
  expect_afresh("@striped@stripe-width=0.2", false);
  expect_afresh("@discarded@stripe-color=#ff0000", false);
  expect_afresh("@discarded@stripes=30", true);
  expect_afresh("@#ff0000", true);
  document.frequency_by_zoom = 1;
  document.camera.zoom = 1.5f;
  expect_afresh("@striped", true);
}

// Values follow the side that is seen once a plane opens the surface; patterns do not.
TEST_F(RenderTool, WhatFollowsTheLightIsThatOfASessionDrawnAfresh) {
  for (const char* option : {"color-by", "frequency-by"}) {
    SessionDocument document = small_document();
    document.options[option] = {"light"};
    SessionWorker worker;
    std::uint64_t revision = 0;
    const auto shown = [&] {
      worker.request({document, ++revision, PictureQuality::final, Follow::last});
      worker.wait();
      write_png(folder / "w.png", worker.latest()->image);
      return content(folder / "w.png");
    };
    shown();
    const StripePattern& whole = worker.latest()->state->job->result.stripes();
    document.options["slice"] = {"z=50%"};
    EXPECT_EQ(shown(), rendered(document)) << option;
    EXPECT_EQ(&worker.latest()->state->job->result.stripes(), &whole) << option;
    document.options["slice"] = {"z=40%"};
    EXPECT_EQ(shown(), rendered(document)) << option;
    document.options.erase("slice");
    EXPECT_EQ(shown(), rendered(document)) << option;
  }
}

TEST_F(RenderTool, ExportsGoOnBesideAWindow) {
  SessionDocument document = small_document();
  const std::string alone = rendered(document);
  SessionWorker worker;
  std::vector<std::jthread> exports;
  for (int i = 0; i < 3; ++i) {
    exports.emplace_back([&, i] {
      CancelledAt never(2);
      export_picture(document, folder / (std::to_string(i) + ".png"), 0, never);
    });
    SessionDocument moved = document;
    moved.camera.azimuth_deg = static_cast<float>(20 * i);
    worker.request({moved, static_cast<std::uint64_t>(i + 1), PictureQuality::interactive});
  }
  exports.clear();
  worker.wait();
  EXPECT_EQ(worker.latest()->revision, 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(content(folder / (std::to_string(i) + ".png")), alone);
}

TEST_F(RenderTool, AFileThatIsNoMeshFailsAndWritesNothing) {
  test::write_text(folder / "bad.ply", "ply, or not");
  SessionDocument document = small_document();
  document.mesh = "bad.ply";
  write_session(folder / "s.json", document);
  expect_refusal(1, "bad.ply", {"render", "s.json", "-o", "a.png"});
}

}  // namespace
}  // namespace brindle::tool
