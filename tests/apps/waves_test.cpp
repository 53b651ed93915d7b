// What the program says of waves, of files and of itself.
#include <cmath>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/version.h"
#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Waves : ToolTest {
  // A plane of unit squares in x and y, and beside it a vertex that no triangle uses.
  static constexpr int kSide = 11;
  void SetUp() override {
    ToolTest::SetUp();
    std::string text;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
      }
    }
    text += "v 5 5 5\n";
    for (int y = 0; y + 1 < kSide; ++y) {
      for (int x = 0; x + 1 < kSide; ++x) {
        const int v = 1 + y * kSide + x;
        for (const auto& [b, c] : {std::pair{v + 1, v + kSide + 1}, {v + kSide + 1, v + kSide}}) {
          text +=
              "f " + std::to_string(v) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
        }
      }
    }
    write_text(folder / "plane.obj", text);
  }
  // Rows of the first words, then of the last one.
  void write_field(const std::string& name, int count, const std::string& row,
                   const std::string& rest) const {
    std::string text;
    for (int v = 0; v < kSide * kSide + 1; ++v) text += (v < count ? row : rest) + "\n";
    write_text(folder / name, text);
  }
  Json report(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--report", "report.json"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

TEST_F(Waves, ThatAreNowhereAreAnError) {
  write_field("zero.csv", 0, "", "0,0,0");
  write_field("nan.csv", 0, "", "nan,nan,nan");
  const std::vector<Arguments> fields = {
      {"--direction", "0,0,1"}, {"--field", "zero.csv"}, {"--field", "nan.csv"}};
  for (const Arguments& field : fields) {
    for (const char* command : {"stripe", "curves", "sample", "compare"}) {
      Arguments arguments = {command, "plane.obj",
                             std::string(command) == "compare" ? "--json" : "--report", "a.json"};
      arguments.insert(arguments.end(), field.begin(), field.end());
      expect_refusal(1, "no vertex has a wave", arguments);
    }
  }
  expect_refusal(1, "no vertex has a wave",
                 {"animate", "plane.obj", "--direction", "0,0,1", "--report", "a.json"});
  expect_refusal(1, "no vertex has a wave",
                 {"sample", "plane.obj", "--field-v", "zero.csv", "-o", "a.csv"});
}

TEST_F(Waves, ThatAreMissingAreCounted) {
  write_field("some.csv", 4, "nan,0,0", "1,0,0");
  const Arguments arguments = {"stripe", "plane.obj", "--field", "some.csv", "--stripes", "4"};
  const Json report = this->report(arguments);
  EXPECT_EQ(report.at("vertices_without_wave"), 4);
  EXPECT_EQ(report.at("field_rows_nonfinite"), 4);
  const ToolResult result = run(arguments);
  EXPECT_TRUE(has(result.err, "warning: 4 of 121 vertices have no wave")) << result.err;
  EXPECT_TRUE(has(result.out, "no wave   at 4 of 121 vertices")) << result.out;
}

TEST_F(Waves, TurnedApartOnASurfaceWithOneSideAreWarnedOf) {
  const char* warning = "neighbours turn in opposite senses";
  const auto warns = [&](const std::string& shape, const Arguments& options) {
    Arguments arguments = {"stripe", shape, "--direction", "0.31,0.9,0.27", "--report", "a.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return has(result.err, warning);
  };
  EXPECT_TRUE(warns("shape:mobius", {"--rotate", "20"}));
  EXPECT_FALSE(warns("shape:mobius", {"--along"}));
  EXPECT_FALSE(warns("shape:mobius", {}));
  EXPECT_FALSE(warns("shape:torus", {"--rotate", "20"}));
}

TEST_F(Waves, OfUnusedVerticesAreNotMissed) {
  write_field("one.csv", 1, "0,0,0", "1,0,0");
  const Json report = this->report({"stripe", "plane.obj", "--field", "one.csv", "--stripes", "4"});
  EXPECT_EQ(report.at("vertices_without_wave"), 1) << "the unused vertex does not count";
  EXPECT_EQ(report.at("field_rows_nonfinite"), 0);
  const ToolResult smooth = run({"stripe", "plane.obj", "--stripes", "4"});
  EXPECT_FALSE(has(smooth.err, "warning")) << smooth.err;
  EXPECT_FALSE(has(smooth.out, "no wave")) << smooth.out;
  EXPECT_FALSE(this->report({"stripe", "plane.obj"}).contains("field_rows_nonfinite"));
}

TEST_F(Waves, AreMeasuredAgainstTheEdges) {
  write_field("f.csv", 61, "1,0,0,0.125", "1,0,0,0.25");
  const Json two = report({"stripe", "plane.obj", "--field", "f.csv"});
  EXPECT_EQ(two.at("frequency_min"), 0.125);
  EXPECT_EQ(two.at("frequency_max"), 0.25);
  EXPECT_NEAR(two.at("stripes").get<double>(), 0.1875 * 10 * std::sqrt(2), 0.03);
  // Inside, four edges of six run along x, by 1.
  const Json one = report({"stripe", "plane.obj", "--direction", "1,0,0", "--frequency", "0.25"});
  EXPECT_NEAR(one.at("edges_per_period_median").get<double>(), 4 / (4.0 / 6), 1e-4);
  EXPECT_LE(one.at("edges_per_period_min"), one.at("edges_per_period_median"));
  EXPECT_NEAR(one.at("stripes").get<double>(), 2.5 * std::sqrt(2), 1e-4);
  EXPECT_TRUE(has(run({"stripe", "plane.obj", "--frequency", "0.25"}).out, "waves     frequency"));
}

TEST_F(Waves, OfASpacingHaveItsInverseAsFrequency) {
  const auto written = [&](const Arguments& density) {
    Arguments arguments = {"stripe", kTorus32, "-o", "a.ply", "-q"};
    arguments.insert(arguments.end(), density.begin(), density.end());
    EXPECT_EQ(run(arguments).exit_code, 0);
    return content(folder / "a.ply");
  };
  EXPECT_TRUE(written({"--spacing", "0.08"}) == written({"--frequency", "12.5"}));
  const Json part = report({"stripe", kTorus32, "--spacing", "5%"});
  EXPECT_NEAR(part.at("stripes").get<double>(), 20, 1e-4);
  write_field("f.csv", 61, "1,0,0,0.125", "1,0,0,0.25");
  const Json over = report({"stripe", "plane.obj", "--field", "f.csv", "--spacing", "5"});
  EXPECT_FLOAT_EQ(over.at("frequency_min").get<float>(), 0.2f);
  EXPECT_FLOAT_EQ(over.at("frequency_max").get<float>(), 0.2f);
  for (const char* other : {"--stripes", "--frequency"}) {
    expect_refusal(2, other, {"stripe", kTorus32, "--spacing", "0.1", other, "9"});
  }
  expect_refusal(2, "--spacing", {"stripe", kTorus32, "--spacing", "0"});
}

TEST_F(Waves, RunAlongAxesByTheirNames) {
  const std::vector<std::pair<std::string, std::string>> axes = {
      {"x", "1,0,0"}, {"y", "0,1,0"}, {"z", "0,0,1"}, {"-x", "-1,0,0"}, {"-z", "0,0,-1"}};
  for (const auto& [name, numbers] : axes) {
    const auto written = [&](const std::string& direction) {
      EXPECT_EQ(
          run({"stripe", kTorus32, "--direction=" + direction, "-o", "a.ply", "-q"}).exit_code, 0);
      return content(folder / "a.ply");
    };
    EXPECT_TRUE(written(name) == written(numbers)) << name;
  }
  expect_refusal(2, "or an axis such as x or -z", {"stripe", kTorus32, "--direction", "w"});
}

TEST_F(Waves, TooFineForTheMeshAreWarnedOf) {
  const std::string ball = "shape:sphere,resolution=8";
  for (const char* command : {"stripe", "curves", "sample", "compare"}) {
    const ToolResult fine = run({command, ball, "--stripes", "10"});
    EXPECT_FALSE(has(fine.err, "of the area")) << fine.err;
    const ToolResult coarse = run({command, ball, "--stripes", "200"});
    EXPECT_EQ(coarse.exit_code, 0) << coarse.err;
    EXPECT_TRUE(has(coarse.err, "% of the area")) << command << coarse.err;
    EXPECT_TRUE(has(coarse.err, "--subdivide 4")) << coarse.err;
    EXPECT_TRUE(has(coarse.err, "unit of the mesh's own length")) << coarse.err;
    EXPECT_EQ(run({command, ball, "--stripes", "200", "--quiet"}).err, "");
  }
  // Metres taken for millimetres.
  const ToolResult wrong = run({"stripe", ball, "--frequency", "3000"});
  EXPECT_TRUE(has(wrong.err, "% of the area")) << wrong.err;
  EXPECT_FALSE(has(wrong.err, "--subdivide")) << "too far off: " << wrong.err;
  expect_refusal(1, "unit of the mesh's own length",
                 {"stripe", kTorus32, "--stripes", "1e30", "-o", "a.ply"});
}

TEST_F(Waves, ThatBranchEverywhereAreWarnedOf) {
  // Every vertex has a direction of its own.
  std::string field;
  for (int v = 0; v < kSide * kSide + 1; ++v) {
    const double angle = 1e3 * std::sin(12.9898 * v);
    field += std::to_string(std::cos(angle)) + "," + std::to_string(std::sin(angle)) + ",0\n";
  }
  write_text(folder / "noise.csv", field);
  const Arguments noise = {"plane.obj", "--field", "noise.csv", "--frequency", "0.2"};
  for (const char* command : {"stripe", "curves", "sample", "compare"}) {
    Arguments arguments = noise;
    arguments.insert(arguments.begin(), command);
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(has(result.err, "stripes begin or end in ")) << command << result.err;
  }
}

TEST_F(Waves, RunAcrossTheFieldOrAlongIt) {
  const Arguments curves = {"curves", "plane.obj", "--frequency", "0.25", "--direction",
                            "1,0,0",  "-o",        "a.csv",       "-q"};
  const auto lines = [&](const Arguments& more) {
    Arguments arguments = curves;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).exit_code, 0);
    return content(folder / "a.csv");
  };
  const std::string across = lines({}), along = lines({"--along"});
  EXPECT_NE(across, along);
  EXPECT_EQ(lines({"--along", "--rotate", "-90"}), across);
  EXPECT_EQ(lines({"--rotate", "90"}), along);
  const Json turned = report({"stripe", "plane.obj", "--direction", "1,0,0", "--along"});
  const Json given = report({"stripe", "plane.obj", "--direction", "0,1,0"});
  EXPECT_NEAR(turned.at("energy").get<double>(), given.at("energy").get<double>(), 1e-6);
  EXPECT_TRUE(has(run({"stripe", "--help"}).out, "ACROSS"));
}

TEST_F(Waves, OfScenesRunAlongTheirFieldIfAskedFor) {
  const Json across = report({"animate", kTorus32, "--frames", "1"});
  const Json along = report({"animate", kTorus32, "--frames", "1", "--along"});
  EXPECT_NE(across["frames"][0]["energy"], along["frames"][0]["energy"]);
  const Json still = report({"stripe", kTorus32, "--direction", "0.31,0.9,0.27", "--along"});
  EXPECT_NEAR(along["frames"][0]["energy"].get<double>(), still["energy"].get<double>(), 1e-6);
  EXPECT_EQ(along.at("vertices_without_wave"), 0);
}

TEST_F(Waves, AlongCurvatureAreSmooth) {
  const auto metrics = [&](const Arguments& more) {
    Arguments arguments = {"stripe", "shape:torus,resolution=32,noise=0.1", "--stripes", "20"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Json report = this->report(arguments);
    for (const char* key : {"milliseconds", "options"}) report.erase(key);
    return report;
  };
  const Json curvature = metrics({"--field", "curvature"});
  EXPECT_EQ(curvature, metrics({"--curvature-anchor", "0.1"}));
  EXPECT_EQ(metrics({"--field", "curvature", "--curvature-anchor", "0.3"}),
            metrics({"--curvature-anchor", "0.3"}));
  EXPECT_LT(2 * curvature.at("branches").get<int>(),
            metrics({"--field", "raw-curvature"}).at("branches").get<int>());
}

TEST_F(Waves, AreReportedWithTheirOrigin) {
  const Json report = this->report({"stripe", "plane.obj", "--stripes", "4", "--along", "-q"});
  EXPECT_EQ(report.at("version"), BRINDLE_VERSION);
  EXPECT_EQ(report.at("command"), "stripe");
  EXPECT_EQ(report.at("input"), "plane.obj");
  EXPECT_EQ(report.at("kind"), "mesh");
  EXPECT_EQ(report.at("options"),
            (Json{{"stripes", "4"}, {"along", true}, {"report", "report.json"}, {"quiet", true}}));
  const Json outputs = this->report({"stripe", "plane.obj", "-o", "a.ply", "-o", "b.ply"});
  EXPECT_EQ(outputs.at("options").at("output"), (Json{"a.ply", "b.ply"}));
  for (const char* command : {"curves", "sample", "animate"}) {
    const Json other = this->report({command, kTorus32});
    EXPECT_EQ(other.at("version"), BRINDLE_VERSION);
    EXPECT_EQ(other.at("command"), command);
    EXPECT_EQ(other.at("input"), kTorus32);
    EXPECT_EQ(other.at("kind"), "mesh");
    EXPECT_EQ(other.at("vertices_without_wave"), 0);
    EXPECT_TRUE(other.contains("edges_per_period_min"));
  }
  ASSERT_EQ(run({"compare", kTorus32, "--json", "all.json"}).exit_code, 0);
  for (const Json& each : Json::parse(content(folder / "all.json"))) {
    EXPECT_EQ(each.at("command"), "compare");
    EXPECT_EQ(each.at("version"), BRINDLE_VERSION);
    EXPECT_EQ(each.at("kind"), "mesh");
  }
}

TEST_F(Waves, LeaveALineForEveryFile) {
  const auto expect_lines = [&](const Arguments& arguments, const Arguments& files) {
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    for (const std::string& file : files) {
      EXPECT_TRUE(has(result.out, "\nwrote " + file + " (")) << file << '\n' << result.out;
    }
    Arguments quiet = arguments;
    quiet.push_back("--quiet");
    EXPECT_EQ(run(quiet).out, "");
  };
  expect_lines({"stripe", kTorus32, "-o", "a.ply", "--report", "a.json"}, {"a.ply", "a.json"});
  expect_lines({"curves", kTorus32, "-o", "a.csv", "--report", "a.json"}, {"a.csv", "a.json"});
  expect_lines({"sample", kTorus32, "-o", "a.csv", "--report", "a.json"}, {"a.csv", "a.json"});
  expect_lines({"compare", kTorus32, "--json", "a.json"}, {"a.json"});
  expect_lines({"animate", kTorus32, "--frames", "2", "--report", "a.json"}, {"a.json"});
  const ToolResult size = run({"stripe", kTorus32, "-o", "a.ply", "-o", "/dev/null"});
  EXPECT_EQ(size.exit_code, 2) << "/dev/null says nothing of a format";
#ifdef BRINDLE_HAS_GL
  expect_lines({"stripe", kTorus32, "--texture", "dots", "-o", "t.obj"},
               {"t.obj", "t.mtl", "t_texture.png"});
  expect_lines({"animate", kTorus32, "--frames", "2", "-o", "%d.png", "--size", "64x48"},
               {"0.png to 1.png"});
#endif
}

#ifdef BRINDLE_HAS_GL

TEST_F(Waves, AreDrawnInATimeThatIsReported) {
  // The report is named before the picture, and written after it.
  const Json report =
      this->report({"stripe", kTorus32, "-o", "a.json", "-o", "a.png", "--size", "64x48"});
  EXPECT_GT(report.at("milliseconds").at("draw").get<double>(), 0);
  EXPECT_EQ(Json::parse(content(folder / "a.json")).at("milliseconds"), report.at("milliseconds"));
  EXPECT_TRUE(has(run({"stripe", kTorus32, "-o", "a.png", "--size", "64x48"}).out, ", draw "));
  EXPECT_FALSE(this->report({"stripe", kTorus32}).at("milliseconds").contains("draw"));
  for (const char* command : {"curves", "sample"}) {
    EXPECT_GT(this->report({command, kTorus32, "-o", "a.png", "--size", "64x48"})
                  .at("milliseconds")
                  .at("draw")
                  .get<double>(),
              0);
  }
}

#endif

}  // namespace
}  // namespace brindle::test
