#include "session/session.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "session/session_options.h"

namespace brindle::tool {
namespace {

SessionDocument torus_document() {
  SessionDocument document;
  document.mesh = "shape:torus,resolution=24";
  document.size = {160, 120};
  return document;
}

FieldStroke stroke_at(double x) { return {{{x, 0, 0}, {x, 1, 0}, {x, 1, 1}}, 0.3, 2}; }

/// Any command: most are accepted, some refused.
class AnyCommand {
 public:
  explicit AnyCommand(unsigned seed) : random_(seed) {}

  SessionCommand operator()() {
    switch (below(22)) {
      case 0:
        return session_command("open",
                               {{"mesh", below(2) ? "shape:torus,resolution=24" : "shape:box"},
                                {"keep_options", below(2) > 0}});
      case 1:
        return commands::set_option("stripes", {std::to_string(below(50))});  // 0 is refused
      case 2:
        return commands::set_option("along", {});
      case 3:
        return commands::clear_option(below(2) ? "along" : "stripes");
      case 4:
        return commands::set_options({{"field", {"curvature"}}, {"curvature-direction", {"min"}}},
                                     {"along"});
      case 5:
        return commands::add_stroke(stroke_at(below(5)));
      case 6:
        return commands::change_stroke(static_cast<std::size_t>(below(4)), stroke_at(below(9)));
      case 7:
        return commands::erase_stroke(static_cast<std::size_t>(below(4)));
      case 8:
        return commands::set_strokes({stroke_at(1), stroke_at(2)});
      case 9:
        return commands::set_camera(
            {static_cast<float>(below(360)), static_cast<float>(below(120)), 2});
      case 10:
        return session_command("set_size", {{"size", size_to_json({below(400), 100})}});
      case 11:
        return commands::store_view(below(11));
      case 12:
        return commands::recall_view(below(11));
      case 13:
        return commands::set_frequency_by_zoom(static_cast<float>(below(3)) / 2);
      case 14:
        return session_command(below(2) ? "begin_drag" : "end_drag");
      case 15:
        return commands::show(kAllShown[static_cast<std::size_t>(below(3))]);
      case 16:
        return commands::set_option(below(2) ? "join" : "along", {});
      case 17:
        return commands::set_option("glyph", {"arrow"});  // of samples alone
      case 18:
        return session_command("solve_again");
      case 19:
        return session_command("previous_view");
      case 20:
        return session_command("next_view");
      default:
        return commands::set_option("field", {"raw-curvature"});  // not with strokes
    }
  }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 random_;
};

TEST(Session, AnySequenceUndoneIsTheSameAndRedoneToo) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    AnyCommand any(seed);
    const SessionDocument first = torus_document();
    Session session(first);
    int accepted = 0;
    for (int i = 0; i < 40; ++i) {
      accepted += session.apply(any()) ? 1 : 0;
      if (any.below(6) == 0) session.undo();
      if (any.below(6) == 0) session.redo();
    }
    EXPECT_GT(accepted, 5);
    session.end_drag();
    const SessionDocument last = session.document();
    int steps = 0;
    while (session.undo()) ++steps;
    SessionDocument seen = first;  // from where it was looked at
    seen.camera = session.document().camera;
    EXPECT_EQ(session.document(), seen) << "seed " << seed;
    for (int i = 0; i < steps; ++i) EXPECT_TRUE(session.redo());
    // What was undone before can be redone, too.
    while (!(session.document() == last) && session.undo()) {
    }
    EXPECT_EQ(session.document(), last) << "seed " << seed;
  }
}

TEST(Session, RefusesWithoutATraceAndSaysWhy) {
  const std::pair<SessionCommand, const char*> refused[] = {
      {commands::set_option("stripes", {"-3"}), "--stripes: expected a finite number above zero"},
      {commands::set_option("stripez", {"3"}), "did you mean --stripes"},
      {commands::set_option("along", {"yes"}), "takes no value"},
      {commands::set_option("stripes", {}), "lacks its value"},
      {commands::set_option("stripes", {"1", "2"}), "takes one value"},
      {commands::set_option("camera", {"1,2"}), "the session's camera"},
      {commands::set_option("curvature-direction", {"min"}), "has no effect here"},
      {commands::set_option("field", {"array:speed"}), "built-in shapes have no arrays"},
      {commands::set_option("legend", {""}), "--legend"},
      {commands::open("nowhere.ply"), "there is no such file"},
      {commands::open("shape:toruss"), "torus"},
      {commands::change_stroke(7, stroke_at(0)), "there is no stroke 7"},
      {commands::add_stroke({{{0, 0, 0}}, 1, 1}), "strokes[0]"},
      {commands::recall_view(3), "no view is stored under the key 3"},
      {commands::store_view(12), "1 to 9"},
      {session_command("set_size", {{"size", size_to_json({0, 100})}}), "from 1 to"},
      {commands::set_camera({0, 95, 1}), "elevation"},
      {commands::set_camera({0, 0, 0}), "zoom"},
      {commands::set_frequency_by_zoom(2), "0 to 1"},
  };
  Session session(torus_document());
  for (const auto& [command, why] : refused) {
    const std::uint64_t revision = session.revision();
    EXPECT_FALSE(session.apply(command)) << why;
    EXPECT_EQ(session.document(), torus_document());
    EXPECT_EQ(session.revision(), revision);
    EXPECT_FALSE(session.can_undo());
    ASSERT_FALSE(session.messages().empty());
    EXPECT_NE(session.messages().back().text.find(why), std::string::npos)
        << session.messages().back().text;
  }
}

TEST(Session, OptionsBelongToWhatIsShown) {
  Session session(torus_document());
  EXPECT_FALSE(session.apply(commands::set_option("join", {})));
  EXPECT_NE(session.messages().back().text.find(
                "is no option of 'brindle stripe', whose picture is shown; show curves"),
            std::string::npos)
      << session.messages().back().text;
  EXPECT_TRUE(session.apply(commands::set_option("color-by", {"height"})));
  EXPECT_TRUE(session.apply(commands::set_option("stripes", {"30"})));
  EXPECT_TRUE(session.apply(commands::show(Shown::curves)));
  EXPECT_TRUE(session.apply(commands::set_option("join", {})));
  EXPECT_FALSE(session.apply(commands::set_option("color-by", {"height"})));
  EXPECT_FALSE(session.apply(commands::set_option("wales", {"8"}))) << "V is not traced";
  EXPECT_TRUE(session.apply(commands::set_option("stripes", {"20"}))) << "all have it";
  EXPECT_EQ(shown_options(session.document()), (OptionValues{{"join", {}}, {"stripes", {"20"}}}));
  EXPECT_TRUE(session.apply(commands::show(Shown::samples)));
  EXPECT_EQ(shown_options(session.document()), (OptionValues{{"stripes", {"20"}}}))
      << "colours of stripes are not those of glyphs";
  EXPECT_TRUE(session.apply(commands::show(Shown::stripes)));
  EXPECT_EQ(shown_options(session.document()),
            (OptionValues{{"color-by", {"height"}}, {"stripes", {"20"}}}));
  EXPECT_EQ(session.document().curves, (OptionValues{{"join", {}}}));
}

TEST(Session, WhatIsShownIsNoOtherPatternWhereItHasTheSameStripes) {
  Session session(torus_document());
  const auto phases = std::make_shared<const std::vector<float>>(2, 0.5f);
  session.keep_phases(session.revision(), phases);
  session.apply(commands::show(Shown::curves));
  session.apply(commands::set_option("offset", {"0.5"}));
  EXPECT_EQ(session.document().phases, phases);
  session.apply(commands::show(Shown::stripes));
  session.apply(commands::set_option("texture", {"bricks"}));
  EXPECT_EQ(session.document().phases, nullptr);
  session.keep_phases(session.revision(), phases);
  EXPECT_EQ(session.document().phases, nullptr) << "textures do not follow";
}

TEST(Session, StrokesNeedAFieldThatFollowsThem) {
  Session session(torus_document());
  EXPECT_TRUE(session.apply(commands::add_stroke(stroke_at(0))));
  EXPECT_FALSE(session.apply(commands::set_option("direction", {"1,0,0"})));
  EXPECT_NE(session.messages().back().text.find("erase the strokes"), std::string::npos);
  EXPECT_TRUE(session.apply(commands::set_strokes({})));
  EXPECT_TRUE(session.apply(commands::set_option("direction", {"1,0,0"})));
}

TEST(Session, ADragIsOneStep) {
  Session session(torus_document());
  session.apply(commands::set_option("stripes", {"30"}));
  session.begin_drag();
  for (int i = 31; i < 40; ++i) session.apply(commands::set_option("stripes", {std::to_string(i)}));
  session.end_drag();
  EXPECT_EQ(session.document().options.at("stripes").front(), "39");
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.document().options.at("stripes").front(), "30");
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.document().options.at("stripes").front(), "39");
  // A drag that comes back is none.
  session.begin_drag();
  session.apply(commands::set_option("stripes", {"50"}));
  session.apply(commands::set_option("stripes", {"39"}));
  session.end_drag();
  session.undo();
  EXPECT_EQ(session.document().options.at("stripes").front(), "30");
}

TEST(Session, UndoLeavesTheCamera) {
  Session session(torus_document());
  session.apply(commands::set_option("stripes", {"30"}));
  session.apply(commands::set_camera({80, 20, 2}));
  session.apply(commands::set_option("stripes", {"40"}));
  session.apply(commands::set_camera({10, -5, 1}));
  const CameraView camera = session.document().camera;
  EXPECT_EQ(session.undo_name(), "number of stripes");
  for (const char* stripes : {"30", ""}) {
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(session.document().camera, camera);
    EXPECT_EQ(session.document().options.contains("stripes"), *stripes != '\0');
  }
  EXPECT_FALSE(session.undo()) << "views are no steps";
  session.apply(commands::set_camera({0, 0, 1}));
  EXPECT_TRUE(session.redo()) << "a view takes no redo away";
  EXPECT_EQ(session.document().options.at("stripes").front(), "30");
  EXPECT_EQ(session.document().camera, (CameraView{0, 0, 1}));
}

TEST(Session, ViewsHaveTheirOwnWayBack) {
  Session session(torus_document());
  const CameraView first = session.document().camera, second{80, 20, 2}, third{10, -5, 1};
  EXPECT_FALSE(session.apply(session_command("previous_view")));
  session.apply(commands::set_camera(second));
  session.apply(commands::store_view(1));
  session.apply(commands::set_camera(third));
  session.apply(commands::set_option("stripes", {"30"}));
  session.apply(commands::recall_view(1));
  for (const CameraView& camera : {third, second, first}) {
    EXPECT_TRUE(session.apply(session_command("previous_view")));
    EXPECT_EQ(session.document().camera, camera);
  }
  EXPECT_EQ(session.document().options.at("stripes").front(), "30") << "edits stay";
  EXPECT_FALSE(session.has_previous_view());
  EXPECT_TRUE(session.apply(session_command("next_view")));
  EXPECT_EQ(session.document().camera, second);
  EXPECT_TRUE(session.follows()) << "stripes move calmly, as where a view is turned";
  session.apply(commands::set_camera(first));
  EXPECT_FALSE(session.has_next_view()) << "another way was gone";
}

TEST(Session, ADraggedViewIsOneView) {
  Session session(torus_document());
  const CameraView first = session.document().camera;
  session.begin_drag();
  for (int i = 1; i < 9; ++i) {
    session.apply(commands::set_camera({static_cast<float>(i), 0, 1}));
    session.apply(commands::set_option("rotate", {std::to_string(i)}));
  }
  session.end_drag();
  EXPECT_TRUE(session.previous_view());
  EXPECT_EQ(session.document().camera, first);
  EXPECT_EQ(session.document().options.at("rotate").front(), "8");
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.document(), torus_document());
  // One that comes back is none.
  session.begin_drag();
  session.apply(commands::set_camera({70, 0, 1}));
  session.apply(commands::set_camera(first));
  session.end_drag();
  EXPECT_FALSE(session.has_previous_view());
}

// They stand in space, so that a surface like the old one may have them.
TEST(Session, StrokesMayOutlastTheirSurface) {
  Session session;
  session.apply(commands::add_stroke({{{1, 0, 0}, {1, 1, 0}}, 0.2, 1}));
  const std::vector<FieldStroke> strokes = session.document().strokes;
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_TRUE(session.apply(commands::open("shape:trefoil,resolution=20", true)));
  EXPECT_EQ(session.document().strokes, strokes);
  EXPECT_TRUE(session.apply(commands::open("shape:trefoil")));
  EXPECT_TRUE(session.document().strokes.empty());
  session.undo();
  EXPECT_EQ(session.document().strokes, strokes);
}

TEST(Session, AnotherSurfaceHasItsCamera) {
  Session session(torus_document());
  CameraView near{80, 20, 3};
  near.center = Vec3(1, 0, 0);
  session.apply(commands::set_camera(near));
  session.apply(commands::open("shape:box"));
  EXPECT_EQ(session.document().camera.center, std::nullopt);
  EXPECT_FALSE(session.has_previous_view()) << "they were of the torus";
  session.apply(commands::set_camera({5, 5, 1}));
  session.undo();
  EXPECT_EQ(session.document().camera, near);
  EXPECT_FALSE(session.has_previous_view());
  session.redo();
  EXPECT_EQ(session.document().camera, (CameraView{5, 5, 1}));
}

TEST(Session, TakesBackViewsBeforeEdits) {
  Session session(torus_document());
  const CameraView first = session.document().camera;
  session.apply(commands::set_option("stripes", {"20"}));
  session.apply(commands::set_camera({80, 20, 1}));
  EXPECT_TRUE(session.take_back(session.revision(), "no memory"));
  EXPECT_EQ(session.document().camera, first);
  EXPECT_EQ(session.document().options.at("stripes").front(), "20");
  EXPECT_TRUE(session.take_back(session.revision(), "still none"));
  EXPECT_EQ(session.document(), torus_document());
  EXPECT_FALSE(session.take_back(session.revision(), "still none"));
}

TEST(Session, PhasesBelongToTheirWavesAlone) {
  Session session(torus_document());
  const auto phases = std::make_shared<const std::vector<float>>(std::vector<float>{0.5f, 1.0f});
  EXPECT_FALSE(session.keep_phases(session.revision() + 1, phases));
  EXPECT_TRUE(session.keep_phases(session.revision(), phases));
  EXPECT_FALSE(session.can_undo()) << "no step of its own";
  session.apply(commands::set_camera({10, 10, 1}));
  session.apply(commands::set_option("stripe-width", {"0.3"}));
  EXPECT_EQ(session.document().phases, phases) << "looks do not change the pattern";
  session.apply(commands::set_option("stripes", {"50"}));
  EXPECT_EQ(session.document().phases, nullptr);
  session.undo();
  EXPECT_EQ(session.document().phases, phases);
}

TEST(Session, PhasesGoWhereACameraMakesOtherWaves) {
  const auto phases = std::make_shared<const std::vector<float>>(2, 0.5f);
  for (const char* value : {"light", "distance:camera", "height"}) {
    Session session(torus_document());
    session.apply(commands::set_option("frequency-by", {value}));
    session.keep_phases(session.revision(), phases);
    session.apply(commands::set_option("stripe-width", {"0.3"}));
    EXPECT_EQ(session.document().phases, phases) << value;
    session.apply(commands::set_camera({80, 20, 1}));
    EXPECT_EQ(session.document().phases != nullptr, value == std::string("height")) << value;
    session.previous_view();
    session.undo();
    EXPECT_EQ(session.document().phases, phases) << value;
    session.apply(commands::set_option("up", {"y"}));
    EXPECT_EQ(session.document().phases, nullptr) << value << ": another axis points up";
    session.apply(commands::set_camera({80, 20, 1}));
    session.undo();
    EXPECT_EQ(session.document().phases != nullptr, value == std::string("height"))
        << value << ": undone, but seen from elsewhere";
  }
}

TEST(Session, StepsAreCalledByWords) {
  Session session(torus_document());
  const std::pair<SessionCommand, const char*> named[] = {
      {commands::set_option("stripes", {"30"}), "number of stripes"},
      {commands::clear_option("stripes"), "number of stripes left out"},
      {commands::set_options({{"field", {"curvature"}}, {"rotate", {"10"}}}, {}),
       "direction field, rotate"},
      {commands::show(Shown::curves), "showing curves"},
      {commands::set_option("join", {}), "join ends"},
      {commands::open("shape:box"), "opening shape:box"}};
  for (const auto& [command, name] : named) {
    ASSERT_TRUE(session.apply(command)) << name;
    EXPECT_EQ(session.undo_name(), name);
  }
  session.undo();
  EXPECT_EQ(session.redo_name(), "opening shape:box");
}

TEST(Session, SolvesAnewInOneStep) {
  Session session(torus_document());
  session.apply(commands::set_option("stripes", {"30"}));
  const auto phases = std::make_shared<const std::vector<float>>(2, 0.5f);
  session.keep_phases(session.revision(), phases);
  EXPECT_TRUE(session.follows());
  const std::uint64_t before = session.revision();
  EXPECT_TRUE(session.apply(session_command("solve_again")));
  EXPECT_EQ(session.document().phases, nullptr);
  EXPECT_FALSE(session.follows()) << "whatever is shown";
  EXPECT_GT(session.revision(), before);
  EXPECT_EQ(session.undo_name(), "solving again");
  EXPECT_TRUE(session.undo());
  EXPECT_EQ(session.document().phases, phases);
  EXPECT_TRUE(session.redo());
  EXPECT_EQ(session.document().phases, nullptr);
  // Where nothing was kept, what is shown may still have followed.
  session.apply(commands::set_option("stripes", {"31"}));
  const std::string last = session.undo_name();
  EXPECT_TRUE(session.follows());
  EXPECT_TRUE(session.apply(session_command("solve_again")));
  EXPECT_FALSE(session.follows());
  EXPECT_EQ(session.undo_name(), last) << "the document is the same";
}

TEST(Session, PhasesThatWereOutdoneGo) {
  Session session(torus_document());
  EXPECT_FALSE(session.keep_phases(session.revision(), nullptr)) << "there were none";
  session.keep_phases(session.revision(), std::make_shared<const std::vector<float>>(2, 0.5f));
  EXPECT_FALSE(session.keep_phases(session.revision() + 1, nullptr)) << "of another document";
  EXPECT_TRUE(session.keep_phases(session.revision(), nullptr));
  EXPECT_EQ(session.document().phases, nullptr);
  EXPECT_FALSE(session.can_undo()) << "no step of its own";
}

TEST(Session, ZoomChangesWavesWhereFrequenciesFollowIt) {
  Session session(torus_document());
  const auto phases = std::make_shared<const std::vector<float>>(2, 0.5f);
  session.apply(commands::set_frequency_by_zoom(1));
  session.keep_phases(session.revision(), phases);
  session.apply(commands::set_camera({40, 20, 1}));
  EXPECT_EQ(session.document().phases, phases);
  session.apply(commands::set_camera({40, 20, 2}));
  EXPECT_EQ(session.document().phases, nullptr);
  EXPECT_FLOAT_EQ(frequency_factor(session.document()), 2);
}

TEST(Session, TakesBackWhatTurnedOutNotToWork) {
  Session session(torus_document());
  session.apply(commands::set_option("stripes", {"20"}));
  const SessionDocument good = session.document();
  session.apply(commands::set_option("avoid-branches", {"nowhere.csv"}));  // needs --slack: refused
  session.apply(
      commands::set_options({{"slack", {"0.1"}}, {"avoid-branches", {"nowhere.csv"}}}, {}));
  EXPECT_TRUE(session.take_back(session.revision(), "nowhere.csv: there is no such file"));
  EXPECT_EQ(session.document(), good);
  EXPECT_FALSE(session.can_redo());
  EXPECT_EQ(session.messages().back().text, "nowhere.csv: there is no such file");
  // What failed belongs to a document that is gone: only said.
  const std::uint64_t old = session.revision();
  session.apply(commands::set_option("stripes", {"25"}));
  EXPECT_FALSE(session.take_back(old, "late"));
  EXPECT_EQ(session.document().options.at("stripes").front(), "25");
}

TEST(Session, FollowsChangesOfOneSurface) {
  Session session(torus_document());
  EXPECT_FALSE(session.follows());
  session.apply(commands::set_option("stripes", {"20"}));
  EXPECT_TRUE(session.follows());
  session.undo();
  EXPECT_FALSE(session.follows());
  session.apply(commands::open("shape:box"));
  EXPECT_FALSE(session.follows());
}

/// What the parser of a document's command has, but what a session has another way.
std::set<std::string> options_of_command(Shown shown) {
  std::set<std::string> elsewhere = {"camera",   "projection", "size",    "scale",  "dpi",
                                     "min-area", "quality",    "threads", "output", "report",
                                     "quiet",    "uv",         "help"};
  if (shown == Shown::curves) elsewhere.insert("creases");
  SessionDocument document;
  document.shown = shown;
  const ParsedSession parsed(document);
  std::set<std::string> names;
  for (const CLI::Option* option : parsed.command().get_options()) {
    if (option->get_positional()) continue;
    const std::string name = option->get_lnames().front();
    if (!elsewhere.contains(name)) names.insert(name);
  }
  return names;
}

TEST(SessionOptions, AreThoseOfTheCommand) {
  for (const Shown shown : kAllShown) {
    std::set<std::string> names;
    for (const OptionInfo* option : session_options(shown)) names.emplace(option->name);
    EXPECT_EQ(names, options_of_command(shown)) << name_of(shown);
  }
  EXPECT_EQ(find_session_option("output"), nullptr);
  EXPECT_EQ(find_session_option("camera"), nullptr);
  EXPECT_EQ(choices_of(*find_session_option("solver")),
            (std::vector<std::string>{"multilevel", "relaxation", "averaged", "global"}));
  EXPECT_TRUE(choices_of(*find_session_option("field")).empty()) << "a file may be given, too";
}

TEST(SessionOptions, OfCurvesAndSamplesAreShared) {
  for (const Shown shown : {Shown::curves, Shown::samples}) {
    for (const OptionInfo* option : session_options(shown)) {
      const std::string name(option->name);
      if (is_own(*option, shown)) {
        EXPECT_TRUE(has(option->stale, OptionStage::style)) << name;
      } else {
        EXPECT_EQ(find_session_option(name), option) << name;
      }
    }
  }
  EXPECT_TRUE(is_own(*find_session_option("path-width", Shown::curves), Shown::curves))
      << "another one than stripes'";
  EXPECT_EQ(find_session_option("texture", Shown::curves), nullptr);
  EXPECT_EQ(find_session_option("points", Shown::curves), nullptr);
  EXPECT_FALSE(is_own(*find_session_option("points", Shown::samples), Shown::samples));
}

TEST(Session, WorkIsWhatOneWouldMiss) {
  const SessionDocument saved;
  SessionDocument looked_at = saved;
  looked_at.camera.azimuth_deg = 77;
  looked_at.size = {640, 480};
  EXPECT_TRUE(same_work(looked_at, saved));
  SessionDocument striped = saved, drawn = saved, stored = saved, zoomed = saved, joined = saved;
  striped.options["stripes"] = {"30"};
  drawn.strokes = {{{{0, 0, 0}, {1, 0, 0}}, 0.1, 1}};
  stored.views[3] = CameraView();
  zoomed.frequency_by_zoom = 1;
  joined.curves["join"] = {};
  for (const SessionDocument& changed : {striped, drawn, stored, zoomed, joined}) {
    EXPECT_FALSE(same_work(changed, saved));
  }
}

TEST(Session, WhatWouldBeLostIsWhatNobodyElseHas) {
  using Words = std::vector<std::string_view>;
  const SessionDocument saved = torus_document();
  SessionDocument now = saved;
  EXPECT_EQ(lost_work(now, saved, SessionDocument()), Words());
  now.options["stripes"] = {"30"};
  now.strokes = {stroke_at(0)};
  now.views[2] = CameraView();
  EXPECT_EQ(lost_work(now, saved, now), Words());
  EXPECT_EQ(lost_work(now, now, saved), Words()) << "all is saved";
  EXPECT_EQ(lost_work(now, saved, saved), (Words{"options", "strokes", "stored views"}));
  const auto opened = [](const SessionDocument& document) {
    Session session(document);
    session.apply(commands::open("shape:box"));
    return session.document();
  };
  EXPECT_EQ(lost_work(now, saved, opened(now)), Words{"strokes"}) << "another mesh keeps the rest";
  SessionDocument erased = now;
  erased.strokes.clear();
  EXPECT_EQ(lost_work(erased, now, opened(erased)), Words())
      << "what was erased is not there to be lost";
}

}  // namespace
}  // namespace brindle::tool
