#include <chrono>
#include <filesystem>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Stripe : ToolTest {
  // Runs with extra arguments and returns the report.
  Json report(const Arguments& more, const std::string& mesh = kTorus64) const {
    Arguments arguments = {"stripe", mesh, "--report", "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

TEST_F(Stripe, ReportHasTheContractsKeys) {
  const auto begin = std::chrono::steady_clock::now();
  const Json report = this->report({});
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begin;
  for (const char* key : {"vertices", "triangles", "edges", "solver", "threads", "iterations",
                          "energy", "branches", "field_singularities", "angle_error_mean_deg",
                          "angle_error_share_over_5deg", "spacing_error_mean", "milliseconds"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  double sum = 0;
  for (const char* key : {"load", "field", "topology", "couple", "solve", "pattern"}) {
    EXPECT_GT(report["milliseconds"].at(key).get<double>(), 0) << key;
    sum += report["milliseconds"].at(key).get<double>();
  }
  EXPECT_LT(sum, wall.count()) << "stages are parts of a run";
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
  const ToolResult result = run({"stripe", kTorus64});
  EXPECT_NE(result.out.find("branches"), std::string::npos) << result.out;
  const ToolResult quiet = run({"stripe", kTorus64, "--quiet"});
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Stripe, WritesWhatTheExtensionSays) {
  const ToolResult result =
      run({"stripe", kTorus64, "-o", "a.obj", "-o", "a.ply", "--output", "a.gltf", "--output",
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
  const auto energy = [&](const std::string& cycles) {
    return report({"--stripes", "12", "--solver", "multilevel,cycles=" + cycles})["energy"]
        .get<double>();
  };
  EXPECT_LT(energy("3"), energy("0"));
}

/// Options, and whether they change the pattern that comes of `without`.
struct Accepted {
  Arguments options;
  bool changes = true;
  Arguments without = {};
};

std::ostream& operator<<(std::ostream& out, const Accepted& accepted) {
  for (const std::string& word : accepted.options) out << word << ' ';
  return out;
}

struct AcceptedOption : Stripe, testing::WithParamInterface<Accepted> {
  Json metrics(const Arguments& options) const {
    Json metrics = report(options);
    for (const char* key : {"milliseconds", "options", "threads", "solver", "iterations"}) {
      metrics.erase(key);
    }
    return metrics;
  }
};

TEST_P(AcceptedOption, GivesAPattern) {
  const Json with = metrics(GetParam().options), without = metrics(GetParam().without);
  EXPECT_LT(with["energy"].get<double>(), 0.12);  // of phases by chance: 0.5
  EXPECT_EQ(with != without, GetParam().changes) << with;
}

const Arguments kCurvature = {"--field", "curvature"};
const Arguments kRelaxation = {"--solver", "relaxation"};

INSTANTIATE_TEST_SUITE_P(
    Stripe, AcceptedOption,
    testing::Values(
        Accepted{{"--direction", "-0.31,0.9,0.27"}}, Accepted{{"--field", "smooth"}, false},
        Accepted{kCurvature}, Accepted{{"--field", "raw-curvature"}, true, kCurvature},
        Accepted{{"--field", "curvature,min"}, true, kCurvature},
        Accepted{{"--field", "smooth", "--curvature-anchor", "0.1"}}, Accepted{{"--rotate", "-90"}},
        Accepted{{"--field", "raw-curvature", "--field-smoothing", "1"},
                 true,
                 {"--field", "raw-curvature"}},
        Accepted{{"--field", "raw-curvature", "--field-smoothing", "1,arrows"},
                 true,
                 {"--field", "raw-curvature", "--field-smoothing", "1"}},
        Accepted{{"--field", "raw-curvature", "--field-smoothing", "1,hold-out=0.1"},
                 true,
                 {"--field", "raw-curvature", "--field-smoothing", "1"}},
        // This field has none.
        Accepted{{"--field", "raw-curvature", "--field-smoothing", "1,singularities=0"},
                 false,
                 {"--field", "raw-curvature", "--field-smoothing", "1"}},
        Accepted{{"--stripes", "10"}}, Accepted{{"--frequency", "5.5"}},
        Accepted{{"--solver", "multilevel"}, false}, Accepted{{"--solver", "multilevel,sweeps=3"}},
        Accepted{{"--solver", "multilevel,cycles=2"}},
        Accepted{{"--solver", "multilevel,weights=cotangent"}}, Accepted{kRelaxation},
        Accepted{{"--solver", "relaxation,epsilon=0.001"}, true, kRelaxation},
        Accepted{{"--solver", "relaxation,momentum=0"}, true, kRelaxation},
        Accepted{{"--solver", "relaxation,seed=7"}, true, kRelaxation},
        Accepted{{"--solver", "averaged"}},
        Accepted{{"--solver", "multilevel,phase-shift=aligned"}, false},
        Accepted{{"--solver", "multilevel,phase-shift=common_source"}},
        Accepted{{"--solver", "multilevel,phase-shift=trapezoid"}},
        Accepted{{"--threads", "2"}, false}, Accepted{{"--threads", "0"}, false},
        Accepted{{"--subdivide", "0"}, false}, Accepted{{"--subdivide", "1"}},
        Accepted{{"--quiet"}, false}));

#ifdef BRINDLE_HAS_CHOLMOD
INSTANTIATE_TEST_SUITE_P(
    Global, AcceptedOption,
    testing::Values(Accepted{{"--solver", "global"}},
                    Accepted{{"--solver", "global,iterations=10"}, true, {"--solver", "global"}}));
#else
/// The line of the field, the warning and the report say one number.
TEST_F(Stripe, SingularitiesThatAreLeftAreTold) {
  const ToolResult result =
      run({"stripe", "shape:sphere,resolution=20", "--field", "raw-curvature", "--field-smoothing",
           "1,singularities=0", "--stripes", "10", "--report", "report.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = Json::parse(content(folder / "report.json"));
  const auto left = std::to_string(report["field_singularities"].get<std::size_t>());
  ASSERT_NE(left, "0");
  EXPECT_TRUE(has(result.err, "warning: " + left + " singularities")) << result.err;
  EXPECT_TRUE(has(result.out, ", " + left + " singularities of")) << result.out;
}

TEST_F(Stripe, MissingGlobalSolverIsNamed) {
  expect_refusal(1, "CHOLMOD", {"stripe", kTorus64, "--solver", "global"});
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
  expect_refusal(1, "BRINDLE_GL", {"stripe", kTorus64, "--output", "a.png"});
}
#endif

}  // namespace
}  // namespace brindle::test
