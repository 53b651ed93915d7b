#include "session/session_document.h"

#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "apps/tool.h"
#include "brindle/error.h"
#include "session/session_command.h"
#include "test_folder.h"

namespace brindle::tool {
namespace {

SessionDocument full_document() {
  SessionDocument document;
  document.mesh = "shape:box,resolution=8";
  document.options = {{"stripes", {"33.5"}},
                      {"along", {}},
                      {"with", {"shape:torus@striped", "shape:sphere@#ff0000"}},
                      {"field", {"curvature"}},
                      {"color-by", {"height"}}};
  document.shown = Shown::samples;
  document.curves = {{"lines", {"both"}}, {"join", {}}, {"path-width", {"0.4%"}}};
  document.samples = {{"glyph", {"arrow"}}, {"color-by", {"height"}}};
  document.strokes = {{{{0.1, 1.0 / 3, -0.0}, {1e-300, 2, 12345.678901234567}}, 0.1, 0.7}};
  document.camera = {12.3f, -7.7f, 1.1f};
  document.camera.projection = Projection::orthographic;
  document.camera.center = Vec3(0.1f, 0.2f, 0.3f);
  document.size = {321, 123};
  document.views[2] = CameraView{1, 2, 3};
  document.views[8] = CameraView();
  document.views[8]->rotation = Eigen::Quaternionf(0.5f, 0.5f, -0.5f, 0.5f);
  document.frequency_by_zoom = 0.3f;
  document.phases = std::make_shared<const std::vector<float>>(
      std::vector<float>{0.1f, -3.1415927f, 1e-20f, 0, 2});
  return document;
}

struct SessionFile : TestFolder {};

TEST_F(SessionFile, SavedAndLoadedAndSavedHasTheSameBytes) {
  for (const SessionDocument& document : {SessionDocument(), full_document()}) {
    write_session(folder / "a.json", document);
    const SessionDocument read = read_session(folder / "a.json");
    EXPECT_EQ(read, document);
    write_session(folder / "b.json", read);
    EXPECT_EQ(test::content(folder / "a.json"), test::content(folder / "b.json"));
  }
}

TEST_F(SessionFile, SaysWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> wrong[] = {
      {"{", "damaged JSON: parse error at line 1"},
      {"[]", "must be an object"},
      {R"({"mesh": "a.ply"})", "no session"},
      {R"({"brindle_session": 7, "mesh": "a.ply"})", "brindle_session must be 1"},
      {R"({"brindle_session": 1})", "lacks 'mesh'"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "siez": [1, 2]})", "did you mean 'size'"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "size": [0, 2]})", "size must be"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "camera": {"azimuth": 1}})",
       "camera lacks 'elevation'"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "camera": {"azimuth": 1, "elevation": 99}})",
       "camera.elevation must be a number from -90 to 90"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "views": {"0": {}}})", "views: unknown key"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "options": {"stripes": 40}})",
       "options.stripes must be text"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "options": {"stripes": "x"}})",
       "--stripes: expected"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "options": {"nothing": true}})",
       "--nothing: is no option"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "shown": "dots"})",
       "shown must be stripes, curves or samples"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "curves": {"joint": true}})",
       "--joint: is no option of 'brindle curves'; did you mean --join"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "samples": {"stripes": "3"}})",
       "--stripes: is shared by all that is shown; it belongs to 'options'"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "shown": "curves", "curves": {"wales": "3"}})",
       "V is not traced"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "strokes": [{"radius": 1, "points": [[1]]}]})",
       "strokes[0].points[0]"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "phases": "AAA"})", "phases must be"},
      {R"({"brindle_session": 1, "mesh": "shape:box", "options": {"slack": "0.1"},)"
       R"("phases": "AAAAAA=="})",
       "phases are kept of plain stripes"},
  };
  for (const auto& [text, why] : wrong) {
    std::ofstream(folder / "bad.json") << text;
    try {
      read_session(folder / "bad.json");
      ADD_FAILURE() << "accepted " << text;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(why), std::string::npos) << message;
      EXPECT_NE(message.find("bad.json"), std::string::npos) << message;
    }
  }
}

TEST_F(SessionFile, ViewsGoToTheClipboardAndBack) {
  const SessionDocument document = full_document();
  EXPECT_EQ(parse_view_text(view_text(document.camera)), document.camera);
  EXPECT_EQ(parse_view_text(view_text(*document.views[8])), *document.views[8]);
  EXPECT_THROW(parse_view_text("hello"), Error);
  EXPECT_THROW(parse_view_text(R"({"rotation": [0, 0, 0, 0]})"), Error);
}

std::vector<SessionCommand> all_commands() {
  const FieldStroke stroke = full_document().strokes[0];
  return {session_command("open",
                          {{"mesh", "a b.ply"}, {"keep_options", false}, {"keep_strokes", true}}),
          commands::set_option("stripes", {"20"}),
          commands::clear_option("stripes"),
          commands::set_options({{"along", {}}, {"field", {"curvature"}}}, {"stripes"}),
          commands::show(Shown::curves),
          commands::add_stroke(stroke),
          commands::change_stroke(3, stroke),
          commands::erase_stroke(2),
          commands::set_strokes({stroke, stroke}),
          commands::set_camera(full_document().camera),
          session_command("set_size", {{"size", size_to_json({10, 20})}}),
          commands::store_view(3),
          commands::recall_view(4),
          commands::set_frequency_by_zoom(0.25f),
          commands::load(full_document()),
          session_command("begin_drag"),
          session_command("end_drag"),
          session_command("undo"),
          session_command("redo"),
          session_command("previous_view"),
          session_command("next_view"),
          commands::keep_phases(full_document().phases),
          session_command("solve_again"),
          commands::set_steering({stroke})};
}

TEST_F(SessionFile, CommandsAreReadAsTheyWereWritten) {
  const std::vector<SessionCommand> commands = all_commands();
  std::set<std::string> names;
  for (const SessionCommand& command : commands) names.insert(command.at("command"));
  const std::vector<std::string> known = command_names();
  ASSERT_EQ(names, std::set<std::string>(known.begin(), known.end())) << "one of each";
  write_commands(folder / "events.jsonl", commands);
  EXPECT_EQ(read_commands(folder / "events.jsonl"), commands);
}

TEST_F(SessionFile, WrongCommandsAreNamedByTheirLine) {
  std::ofstream(folder / "events.jsonl") << "{\"command\": \"undo\"}\n\n{\"command\": \"undoo\"}\n";
  try {
    read_commands(folder / "events.jsonl");
    ADD_FAILURE();
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("events.jsonl:3: 'undoo' is no command (did you mean 'undo'?)"),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace brindle::tool
