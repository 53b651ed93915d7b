#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct StrokeFile : testing::Test {
  fs::path path =
      fs::temp_directory_path() /
      ("brindle_strokes_" +
       std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".json");

  void TearDown() override { fs::remove(path); }

  void write(const std::string& text) const { std::ofstream(path, std::ios::binary) << text; }
  std::string bytes() const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// What reading `text` complains of.
  std::string complaint(const std::string& text) const {
    write(text);
    try {
      read_strokes(path);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
      return std::string(error.what()).substr(path.string().size());
    }
    return "";
  }
};

#ifdef BRINDLE_HAS_JSON

TEST_F(StrokeFile, WrittenReadAndWrittenAgainHasTheSameBytes) {
  const std::vector<FieldStroke> strokes = {
      {{Eigen::Vector3d(0.1, -2e-9, 1.0 / 3), Eigen::Vector3d(1e17, 3, -0.0)}, 0.1f, 1},
      {{Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(4, 5, 6), Eigen::Vector3d(7, 8, 9)}, 2.5, 0}};
  write_strokes(path, strokes);
  const std::string first = bytes();
  const std::vector<FieldStroke> read = read_strokes(path);
  EXPECT_EQ(read, strokes);
  write_strokes(path, read);
  EXPECT_EQ(bytes(), first);
}

TEST_F(StrokeFile, StrengthMayBeMissing) {
  write(R"({"strokes": [{"radius": 1, "points": [[0,0,0],[1,0,0]]}]})");
  EXPECT_EQ(read_strokes(path).at(0).strength, 1);
}

TEST_F(StrokeFile, DamagedJsonIsNamedByLineAndColumn) {
  const std::string text = complaint("{\"strokes\": [\n  {\"radius\": 1,, \"points\": []}]}");
  EXPECT_NE(text.find("line 2, column 16"), std::string::npos) << text;
  EXPECT_NE(complaint("{\"strokes\": [").find("line 1"), std::string::npos);
  EXPECT_NE(complaint(R"({"strokes": [{"radius": NaN, "points": []}]})").find("column"),
            std::string::npos);
}

TEST_F(StrokeFile, WhatIsWrongIsNamedByItsPlace) {
  const auto stroke = [](const std::string& inside) {
    return R"({"strokes": [{"radius": 1, "points": [[0,0,0],[1,0,0]]}, {)" + inside + "}]}";
  };
  const std::vector<std::array<std::string, 2>> cases = {
      {"[]", "must be an object"},
      {"{}", "lacks 'strokes'"},
      {R"({"strokes": {}})", "must be a list"},
      {R"({"strokes": []})", "empty"},
      {R"({"strokes": [3]})", "strokes[0] must be an object"},
      {R"({"strokes": [], "version": 1})", "unknown key 'version'"},
      {stroke(R"("points": [[0,0,0],[1,0,0]])"), "strokes[1] lacks 'radius'"},
      {stroke(R"("radius": 1)"), "strokes[1] lacks 'points'"},
      {stroke(R"("radius": "1", "points": [])"), "strokes[1].radius must be a number"},
      {stroke(R"("radius": 1, "colour": 1, "points": [])"), "unknown key 'colour'"},
      {stroke(R"("radius": 1, "points": 7)"), "strokes[1].points must be a list"},
      {stroke(R"("radius": 1, "points": [[0,0,0],[1,0]])"), "strokes[1].points[1] must have 3"},
      {stroke(R"("radius": 1, "points": [[0,0,0],[1,null,0]])"), "strokes[1].points[1][1]"},
      {stroke(R"("radius": 1, "points": [[0,0,0],[1,1e999,0]])"), "1e999"},
      {stroke(R"("radius": 1, "points": [])"), "strokes[1] has no length"},
      {stroke(R"("radius": 0, "points": [[0,0,0],[1,0,0]])"), "strokes[1]: the radius"},
      {stroke(R"("radius": 1, "strength": -1, "points": [[0,0,0],[1,0,0]])"),
       "strokes[1]: the strength"}};
  for (const auto& [text, part] : cases) {
    const std::string found = complaint(text);
    EXPECT_NE(found.find(part), std::string::npos) << text << '\n' << found;
  }
  EXPECT_THROW(read_strokes("none.json"), Error);
}

#else

TEST_F(StrokeFile, IsAnErrorInABuildWithoutJson) { EXPECT_NE(complaint(R"({"strokes": []})"), ""); }

#endif

TEST_F(StrokeFile, StrokesThatAreNoneAreNotWritten) {
  const std::vector<FieldStroke> strokes = {{{Eigen::Vector3d(0, 0, 0)}, 1, 1}};
  EXPECT_THROW(write_strokes(path, strokes), Error);
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace brindle
