#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

const char* const kSmallTorus = "shape:torus,resolution=64";

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Stripe : ToolTest {
  // Runs with extra arguments and returns the report.
  Json report(const Arguments& more, const std::string& mesh = kSmallTorus) const {
    Arguments arguments = {"stripe", mesh, "--report", "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

TEST_F(Stripe, ReportHasTheContractsKeys) {
  const Json report = this->report({});
  for (const char* key : {"vertices", "triangles", "edges", "solver", "threads", "iterations",
                          "energy", "branches", "field_singularities", "angle_error_mean_deg",
                          "angle_error_share_over_5deg", "spacing_error_mean", "milliseconds"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  for (const char* key : {"load", "field", "topology", "couple", "solve", "pattern"}) {
    EXPECT_GE(report["milliseconds"].at(key).get<double>(), 0) << key;
  }
  EXPECT_EQ(report["solver"], "multilevel");
  EXPECT_EQ(
      report["vertices"].get<int>() - report["edges"].get<int>() + report["triangles"].get<int>(),
      0);  // a torus
}

TEST_F(Stripe, NumbersDoNotDependOnThreads) {
  for (const char* solver : {"multilevel", "relaxation", "averaged"}) {
    Json one = report({"--solver", solver, "--threads", "1"});
    Json two = report({"--solver", solver, "--threads", "2"});
    EXPECT_EQ(one["threads"], 1);
    EXPECT_EQ(two["threads"], 2);
    for (const char* key : {"threads", "milliseconds", "options"}) {
      one.erase(key);
      two.erase(key);
    }
    EXPECT_EQ(one, two) << solver;
  }
}

TEST_F(Stripe, SubdivisionSplitsEveryTriangleInFour) {
  EXPECT_EQ(report({"--subdivide", "1"})["triangles"].get<int>(),
            4 * report({})["triangles"].get<int>());
}

TEST_F(Stripe, FrequencyIsStripesOverDiagonal) {
  write_text(folder / "mesh.obj", "v 0 0 0\nv 3 0 0\nv 0 4 0\nf 1 2 3\n");
  const Arguments direction = {"--direction", "1,0,0"};
  Json stripes = report({"--direction", "1,0,0", "--stripes", "10"}, "mesh.obj");
  Json frequency = report({"--direction", "1,0,0", "--frequency", "2"}, "mesh.obj");
  for (const char* key : {"milliseconds", "options"}) {
    stripes.erase(key);
    frequency.erase(key);
  }
  EXPECT_EQ(stripes, frequency);
}

TEST_F(Stripe, FieldFilesGiveDirectionsAndFrequencies) {
  write_text(folder / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  write_text(folder / "field.csv", "x,y,z,f\n1,0,0,2\n1,0,0,2\n1,0,0,2\n1,0,0,2\n");
  const Json report = this->report({"--field", "field.csv"}, "mesh.obj");
  EXPECT_LT(report["energy"].get<double>(), 1e-6);
  EXPECT_LT(report["spacing_error_mean"].get<double>(), 1e-3);
}

TEST_F(Stripe, AnswersOnStdoutUnlessQuiet) {
  const ToolResult result = run({"stripe", kSmallTorus});
  EXPECT_NE(result.out.find("branches"), std::string::npos) << result.out;
  const ToolResult quiet = run({"stripe", kSmallTorus, "--quiet"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Stripe, WritesWhatTheExtensionSays) {
  const ToolResult result =
      run({"stripe", kSmallTorus, "-o", "a.obj", "-o", "a.ply", "--output", "a.gltf", "--output",
           "a.GLB", "--output", "a.json", "-o", "a.vtp"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(content(folder / "a.ply").substr(0, 3), "ply");
  EXPECT_EQ(content(folder / "a.GLB").substr(0, 4), "glTF");
  EXPECT_EQ(Json::parse(content(folder / "a.gltf"))["asset"]["version"], "2.0");
  EXPECT_EQ(Json::parse(content(folder / "a.json"))["solver"], "multilevel");
  for (const char* name : {"phase", "direction", "frequency", "branch"}) {
    EXPECT_NE(content(folder / "a.vtp").find("Name=\"" + std::string(name)), std::string::npos);
    EXPECT_NE(content(folder / "a.ply").find("property float " + std::string(name)),
              std::string::npos);
  }
  const int vertices = report({})["vertices"];
  for (const char* mesh : {"a.obj", "a.ply", "a.gltf", "a.GLB"}) {
    EXPECT_EQ(report({}, mesh)["vertices"], vertices) << mesh;
  }
}

TEST_F(Stripe, CyclesLowerTheEnergy) {
  const auto energy = [&](const char* cycles) {
    return report({"--stripes", "12", "--cycles", cycles})["energy"].get<double>();
  };
  EXPECT_LT(energy("3"), energy("0"));
}

struct AcceptedOption : Stripe, testing::WithParamInterface<Arguments> {};

TEST_P(AcceptedOption, GivesAPattern) {
  const Json report = this->report(GetParam());
  EXPECT_LT(report["energy"].get<double>(), 0.08);
}

INSTANTIATE_TEST_SUITE_P(
    Stripe, AcceptedOption,
    testing::Values(
        Arguments{"--direction", "-0.31,0.9,0.27"}, Arguments{"--field", "smooth"},
        Arguments{"--field", "curvature"}, Arguments{"--field", "raw-curvature"},
        Arguments{"--field", "curvature", "--curvature-direction", "min"},
        Arguments{"--field", "smooth", "--curvature-anchor", "0.1"}, Arguments{"--rotate", "-90"},
        Arguments{"--stripes", "10"}, Arguments{"--frequency", "5.5"},
        Arguments{"--solver", "multilevel", "--sweeps", "3"}, Arguments{"--cycles", "2"},
        Arguments{"--weights", "cotangent"},
        Arguments{"--solver", "relaxation", "--epsilon", "0.001", "--momentum", "0", "--seed", "7"},
        Arguments{"--solver", "averaged"}, Arguments{"--phase-shift", "aligned"},
        Arguments{"--phase-shift", "common_source"}, Arguments{"--phase-shift", "trapezoid"},
        Arguments{"--threads", "2"}, Arguments{"--threads", "0"}, Arguments{"--subdivide", "0"},
        Arguments{"--quiet"}));

#ifdef BRINDLE_HAS_CHOLMOD
INSTANTIATE_TEST_SUITE_P(Global, AcceptedOption,
                         testing::Values(Arguments{"--solver", "global", "--global-iterations",
                                                   "10"}));
#else
TEST_F(Stripe, MissingGlobalSolverIsNamed) {
  expect_refusal(1, "CHOLMOD", {"stripe", kSmallTorus, "--solver", "global"});
}
#endif

#ifdef BRINDLE_HAS_GL
// Width and height as a PNG file's header has them.
std::pair<int, int> png_size(const std::string& png) {
  const auto big_endian = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  return {big_endian(16), big_endian(20)};
}

TEST_F(Stripe, DrawsEveryView) {
  std::set<std::string> pictures;
  for (const char* view : {"stripes", "branches", "angle_error"}) {
    report({"--output", "a.png", "--view", view, "--size", "320x200"});
    const std::string picture = content(folder / "a.png");
    EXPECT_EQ(png_size(picture), std::pair(320, 200));
    pictures.insert(picture);
  }
  EXPECT_EQ(pictures.size(), 3u);
}

TEST_F(Stripe, PictureOptionsChangeThePicture) {
  std::set<std::string> pictures;
  const std::vector<Arguments> all = {{},
                                      {"--camera", "-60,45"},
                                      {"--camera", "30,20,3"},
                                      {"--up", "y"},
                                      {"--colors", "#ff0000,#00ff00"},
                                      {"--colors", "f00,0f0,000"},
                                      {"--stripe-width", "0.2"}};
  for (Arguments options : all) {
    options.insert(options.end(), {"--output", "a.png", "--size", "160x120"});
    report(options);
    pictures.insert(content(folder / "a.png"));
  }
  EXPECT_EQ(pictures.size(), all.size());
}
#else
TEST_F(Stripe, PicturesAreRefusedBeforeTheWork) {
  expect_refusal(1, "BRINDLE_GL", {"stripe", kSmallTorus, "--output", "a.png"});
}
#endif

}  // namespace
}  // namespace brindle::test
