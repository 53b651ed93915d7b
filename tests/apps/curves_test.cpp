#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Curves : ToolTest {
  Json report(const Arguments& more, const std::string& mesh = kTorus48) const {
    Arguments arguments = {"curves", mesh, "--report", "report.json", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    return Json::parse(content(folder / "report.json"));
  }
};

std::size_t lines_that_begin(const std::string& text, const std::string& begin) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("\n" + begin, at)) != std::string::npos; ++at) ++count;
  return count;
}

TEST_F(Curves, ReportBalances) {
  const auto begin = std::chrono::steady_clock::now();
  const Json report = this->report({"--lines", "both"});
  const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - begin;
  for (const char* family : {"u", "v"}) {
    const Json& lines = report.at(family);
    const Json& ends = lines.at("ends");
    int sum = 0;
    for (const char* kind : {"boundary", "no_wave", "nonmanifold", "branch", "singularity"}) {
      sum += ends.at(kind).get<int>();
    }
    EXPECT_EQ(ends.at("total"), sum);
    EXPECT_EQ(2 * (lines.at("curves").get<int>() - lines.at("closed").get<int>()), sum);
    EXPECT_GT(lines.at("points").get<int>(), lines.at("curves").get<int>());
    EXPECT_GT(lines.at("length").get<double>(), 0);
  }
  double sum = 0;
  for (const char* key : {"load", "field", "topology", "couple", "solve", "pattern", "extract"}) {
    EXPECT_GT(report.at("milliseconds").at(key).get<double>(), 0) << key;
    sum += report.at("milliseconds").at(key).get<double>();
  }
  EXPECT_LT(sum, wall.count()) << "stages are parts of a run";
}

TEST_F(Curves, WritesWhatTheExtensionSays) {
  const Json report = this->report(
      {"-o", "a.obj", "-o", "a.ply", "-o", "a.vtp", "-o", "a.CSV", "-o", "a.svg", "-o", "a.json"});
  const auto& u = report.at("u");
  const std::string obj = content(folder / "a.obj");
  EXPECT_EQ(lines_that_begin(obj, "v "), u.at("points"));
  EXPECT_EQ(lines_that_begin(obj, "l "), u.at("curves"));
  EXPECT_EQ(lines_that_begin(content(folder / "a.CSV"), "u,"), u.at("points"));
  EXPECT_NE(content(folder / "a.ply").find("element edge "), std::string::npos);
  EXPECT_NE(content(folder / "a.vtp")
                .find("NumberOfLines=\"" + std::to_string(u.at("curves").get<int>())),
            std::string::npos);
  EXPECT_GT(lines_that_begin(content(folder / "a.svg"), "<path"), 10u);
  EXPECT_EQ(Json::parse(content(folder / "a.json")).at("u"), u);
}

TEST_F(Curves, TubesAreMeshesThatCanBeReadAgain) {
  const Arguments tubes = {"--tube-radius", "0.3%", "--tube-sides", "5", "--stripes", "10"};
  for (const std::string name : {"a.obj", "a.ply", "a.glb", "a.vtp"}) {
    Arguments arguments = tubes;
    arguments.insert(arguments.end(), {"-o", name});
    report(arguments);
    if (name == "a.vtp") continue;
    const ToolResult info = run({"info", name});
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_NE(info.out.find(" 0 on a boundary, 0 non-manifold"), std::string::npos) << info.out;
  }
}

TEST_F(Curves, NumbersDoNotDependOnThreads) {
  const auto with = [&](const char* threads) {
    Json json = report({"--lines", "both", "--threads", threads, "-o", "a.csv"});
    json.erase("milliseconds");
    json.erase("threads");
    json.erase("options");
    return std::pair(json, content(folder / "a.csv"));
  };
  EXPECT_EQ(with("1"), with("2"));
}

TEST_F(Curves, OptionsChangeTheLines) {
  const Json plain = report({}).at("u");
  const auto points = [&](const Arguments& more) {
    return report(more).at("u").at("points").get<int>();
  };
  EXPECT_LT(points({"--simplify", "0.5%"}), plain.at("points").get<int>());
  EXPECT_NEAR(points({"--resample", "1%"}), plain.at("length").get<double>() / (0.01 * 2.89),
              0.05 * points({"--resample", "1%"}));
  const Json longer = report({"--min-length", "30%"}).at("u");
  EXPECT_EQ(longer.at("curves").get<int>() + longer.at("short_curves_left_out").get<int>(),
            plain.at("curves").get<int>());
  EXPECT_EQ(longer.at("ends"), plain.at("ends")) << "ends are those of all curves";
  EXPECT_NE(report({"--offset", "0.25", "-o", "a.csv"}).at("u"), plain);
  EXPECT_LE(report({"--join"}).at("u").at("curves"), report({"--trim", "0"}).at("u").at("curves"));
  const std::string sphere = "shape:sphere,resolution=20";
  const Json whole = report({"--stripes", "30", "--trim", "0"}, sphere).at("u");
  const Json faired = report({"--stripes", "30", "--trim", "0", "--fair", "0.25"}, sphere).at("u");
  EXPECT_EQ(faired.at("curves"), whole.at("curves"));
  EXPECT_GT(faired.at("largest_move"), 0);
  EXPECT_EQ(whole.at("largest_move"), 0);
  const Json trimmed = report({"--stripes", "30"}, sphere).at("u");
  EXPECT_LT(trimmed.at("length"), whole.at("length"));
  EXPECT_GT(trimmed.at("trimmed_ends"), 0);
  EXPECT_EQ(whole.at("trimmed_ends"), 0);
  EXPECT_EQ(report({"--stripes", "30", "--trim", "0.6"}, sphere).at("u"), trimmed);
  EXPECT_EQ(trimmed.at("curves").get<int>() + trimmed.at("trimmed_away").get<int>(),
            whole.at("curves").get<int>());
  EXPECT_TRUE(report({"--lines", "v"}).contains("v"));
  EXPECT_FALSE(report({"--lines", "v"}).contains("u"));
}

TEST_F(Curves, SecondPatternHasItsOwnFieldAndFrequency) {
  const auto v = [&](const Arguments& more) {
    Arguments arguments = {"--lines", "v"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments, "mesh.obj").at("v").at("length").get<double>();
  };
  write_text(folder / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  std::string field;
  for (int i = 0; i < 4; ++i) field += "1,0,0,30\n";
  write_text(folder / "v.csv", field);
  EXPECT_NEAR(v({"--direction", "0,1,0", "--frequency-v", "20"}), 20, 1.5);
  EXPECT_NEAR(v({"--direction", "0,1,0", "--frequency", "20"}), 20, 1.5);
  EXPECT_NEAR(v({"--direction", "0,1,0", "--field-v", "v.csv"}), 30, 1.5);
  EXPECT_NEAR(v({"--direction", "0,1,0", "--field-v", "v.csv", "--stripes-v", "14.142"}), 10, 1.5);
}

TEST_F(Curves, SecondPatternHasTheFrequencyOfTheFieldFile) {
  const auto v = [&](const Arguments& more) {
    Arguments arguments = {"--lines", "v", "--field", "both.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments, "mesh.obj").at("v").at("length").get<double>();
  };
  write_text(folder / "mesh.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  std::string field, field_v;
  for (int i = 0; i < 4; ++i) field += "0,1,0,10,30\n", field_v += "1,0,0,25\n";
  write_text(folder / "both.csv", field);
  write_text(folder / "v.csv", field_v);
  EXPECT_NEAR(v({}), 30, 1.5);
  EXPECT_NEAR(v({"--frequency-v", "20"}), 20, 1.5);
  EXPECT_NEAR(v({"--stripes-v", "28.284"}), 20, 1.5);
  EXPECT_NEAR(v({"--field-v", "v.csv"}), 25, 1.5);
  EXPECT_NEAR(v({"--frequency", "15"}), 15, 1.5) << "goes before all of the file's frequencies";
}

TEST_F(Curves, SimplifyingComesAfterEqualSteps) {
  const auto rows = [&](const Arguments& more) {
    Arguments arguments = {"-o", "a.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    report(arguments);
    std::istringstream lines(content(folder / "a.csv"));
    std::vector<std::string> sorted;
    for (std::string line; std::getline(lines, line);) sorted.push_back(line);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  const auto steps = rows({"--resample", "0.5%"});
  const auto fewer = rows({"--resample", "0.5%", "--simplify", "0.2%"});
  EXPECT_LT(fewer.size(), steps.size() * 3 / 4);
  EXPECT_TRUE(std::includes(steps.begin(), steps.end(), fewer.begin(), fewer.end()));
}

TEST_F(Curves, NeedTriangles) {
  write_text(folder / "points.csv", "0,0,0\n1,0,0\n0,1,0\n1,1,0\n");
  write_text(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  for (const char* name : {"points.csv", "points.obj"}) {
    expect_refusal(1, "need triangles", {"curves", name, "-o", "a.obj"});
  }
}

TEST_F(Curves, SayThatThereAreNone) {
  const auto said = [&](const Arguments& more) {
    Arguments arguments = {"curves"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"-o", "a.csv"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(lines_that_begin(content(folder / "a.csv"), "u,"), 0u);
    return result.err;
  };
  EXPECT_NE(said({"shape:plane", "--direction", "1,0,0", "--stripes", "0.001", "--offset", "0.5"})
                .find("u: no curves"),
            std::string::npos);
  const std::string err = said({kTorus48, "--min-length", "10000%"});
  EXPECT_NE(err.find("--min-length"), std::string::npos) << err;
  EXPECT_EQ(said({kTorus48, "--min-length", "10000%", "--quiet"}), "");
}

TEST_F(Curves, FormatsThatHoldNoLinesNameOneThatDoes) {
  for (const char* name : {"a.glb", "a.gltf"}) {
    expect_refusal(2, "--tube-radius", {"curves", kTorus48, "-o", name});
  }
  expect_refusal(2, ".vtp", {"curves", kTorus48, "-o", "a.stl"});
  expect_refusal(2, ".glb", {"curves", kTorus48, "-o", "a.csv", "--tube-radius", "1%"});
  expect_refusal(1, "none", {"curves", kTorus48, "-o", "a.obj", "-o", "none/a.svg"});
  expect_refusal(1, "none", {"curves", kTorus48, "--report", "none/a.json"});
  expect_refusal(1, "none.csv", {"curves", kTorus48, "--lines", "v", "--field-v", "none.csv"});
  expect_refusal(1, "none.ply", {"curves", "none.ply", "-o", "a.obj"});
}

TEST_F(Curves, FullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const char* name : {"full.obj", "full.ply", "full.vtp", "full.csv", "full.svg"}) {
    std::filesystem::create_symlink("/dev/full", folder / name);
    Arguments arguments = {"curves", kTorus48, "-o", name};
    if (std::string(name).ends_with(".svg")) arguments.insert(arguments.end(), {"--size", "64x48"});
    expect_refusal(1, name, arguments);
  }
}

TEST_F(Curves, TooManyPointsAreRefused) {
  expect_refusal(1, "the smallest spacing that would do is",
                 {"curves", kTorus48, "--resample", "1e-12", "-q"});
}

struct WrongCurves : ToolTest, testing::WithParamInterface<Arguments> {};

TEST_P(WrongCurves, EndsWithCodeTwo) {
  Arguments arguments = {"curves", kTorus48, "--report", "out.json"};
  arguments.insert(arguments.end(), GetParam().begin(), GetParam().end());
  expect_refusal(2, GetParam().front(), arguments);
}

INSTANTIATE_TEST_SUITE_P(
    Curves, WrongCurves,
    testing::Values(Arguments{"--lines", "w"}, Arguments{"--offset", "half"},
                    Arguments{"--offset", "inf"}, Arguments{"--min-length", "-1"},
                    Arguments{"--trim", "-0.1"}, Arguments{"--trim", "1.2"},
                    Arguments{"--fair", "-0.1"}, Arguments{"--trim", "0.6", "--join"},
                    Arguments{"--min-length", "1 %"}, Arguments{"--simplify", "nan"},
                    Arguments{"--simplify", "%"}, Arguments{"--resample", "0"},
                    Arguments{"--tube-radius", "0%"}, Arguments{"--tube-sides", "2"},
                    Arguments{"--stripes-v", "0"}, Arguments{"--frequency-v", "-2"},
                    Arguments{"--stripes-v", "2", "--frequency-v", "3"}, Arguments{"--field-v"}));

INSTANTIATE_TEST_SUITE_P(
    CurvesWithoutEffect, WrongCurves,
    testing::Values(Arguments{"--stripes-v", "20"}, Arguments{"--frequency-v", "2"},
                    Arguments{"--field-v", "none.csv", "--lines", "u"},
                    Arguments{"--tube-radius", "1%"}, Arguments{"--tube-sides", "5"},
                    Arguments{"--tube-sides", "5", "-o", "a.obj"},
                    Arguments{"--tube-radius", "1%", "-o", "a.svg"}, Arguments{"--up", "y"},
                    Arguments{"--creases", "40", "-o", "a.svg"},
                    Arguments{"--camera", "30,20", "-o", "a.ply"}, Arguments{"--size", "64x48"},
                    Arguments{"--colors", "#000000,#ffffff", "-o", "a.csv"}));

TEST_F(Curves, CreasesAreLinesOfTheirOwn) {
  const std::string cylinder = "shape:cylinder,resolution=24";
  report({"-o", "plain.obj", "-o", "plain.csv"}, cylinder);
  report({"--creases", "40", "-o", "a.obj", "-o", "a.csv", "-o", "a.ply", "-o", "a.vtp"}, cylinder);
  const std::string plain = content(folder / "plain.csv"), all = content(folder / "a.csv");
  EXPECT_TRUE(all.starts_with(plain)) << "stripes stay";
  EXPECT_EQ(lines_that_begin(plain, "creases,"), 0u);
  const std::size_t points = lines_that_begin(all, "creases,");
  EXPECT_GT(points, 8u);
  EXPECT_EQ(lines_that_begin(content(folder / "a.obj"), "v "),
            lines_that_begin(content(folder / "plain.obj"), "v ") + points);
  EXPECT_NE(content(folder / "a.obj").find("creases"), std::string::npos);
  report({"--creases", "40", "-o", "a.csv"}, kTorus48);
  EXPECT_EQ(lines_that_begin(content(folder / "a.csv"), "creases,"), 0u) << "a torus has none";
}

TEST_F(Curves, DrawingsTakeSidesAndProjections) {
  const auto drawn = [&](const Arguments& more) {
    Arguments arguments = {"-o", "a.svg", "--size", "320x240"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    report(arguments);
    return content(folder / "a.svg");
  };
  const std::string above = drawn({"--camera", "top,orthographic"});
  EXPECT_EQ(drawn({"--camera", "0,90,orthographic"}), above);
  EXPECT_NE(drawn({"--camera", "top"}), above);
  EXPECT_EQ(drawn({"--camera", "top,perspective"}), drawn({"--camera", "0,90"}));
}

TEST_F(Curves, MeasuresWhatAMakerAsksFor) {
  const std::string cylinder = "shape:cylinder,resolution=60";
  const Arguments rings = {"--direction", "0,0,1", "--stripes", "20", "--path-width", "0.02"};
  const Json u = report(rings, cylinder).at("u");
  const Json& lengths = u.at("lengths");
  EXPECT_EQ(u.at("open"), 0);
  EXPECT_EQ(lengths.at("open"), 0);
  EXPECT_NEAR(lengths.at("closed").get<double>(), u.at("length").get<double>(), 1e-6);
  EXPECT_NEAR(lengths.at("longest").get<double>(), 3.14, 0.01);
  EXPECT_NEAR(u.at("coverage").get<double>(), 0.02 * u.at("length").get<double>() / (2 * 3.1416),
              0.01);
#ifdef BRINDLE_HAS_NANOFLANN
  EXPECT_NEAR(u.at("gaps").at("least_ratio").get<double>(), 1, 0.01);
  EXPECT_NEAR(u.at("gaps").at("most_ratio").get<double>(), 1, 0.01);
#endif
  EXPECT_FALSE(report({}).at("u").contains("coverage"));
  expect_refusal(2, "--path-width", {"curves", cylinder, "--path-width", "0"});
}

TEST_F(Curves, LengthsAreThoseOfTheCurvesThatAreWritten) {
  for (const Arguments& more : {Arguments{"--resample", "3%"}, Arguments{"--simplify", "2%"}}) {
    const Json v = report(more).at("u");
    const Json& lengths = v.at("lengths");
    EXPECT_NEAR(lengths.at("closed").get<double>() + lengths.at("open").get<double>(),
                v.at("length").get<double>(), 1e-5);
    EXPECT_NE(v.at("length"), report({}).at("u").at("length"));
  }
}

TEST_F(Curves, TakeTextureCoordinatesAlong) {
  ASSERT_EQ(run({"stripe", "shape:torus,resolution=16", "--uv", "--output", "a.ply"}).exit_code, 0);
  for (const char* command : {"curves", "sample"}) {
    ASSERT_EQ(run({command, "a.ply", "--stripes", "6", "--output", "b.ply"}).exit_code, 0);
    const ToolResult info = run({"info", "b.ply", "--points"});
    EXPECT_EQ(info.exit_code, 0) << info.err;
    EXPECT_NE(info.out.find("uv"), std::string::npos) << info.out;
  }
}

TEST_F(Curves, WindAsTheyAreAskedTo) {
  const std::string tube = "shape:tube,radius=0.2,bend=30,resolution=48";
  const Arguments slanted = {"--field", "curvature,min", "--rotate", "8", "--stripes", "24"};
  const auto wound = [&](const Arguments& more) {
    Arguments arguments = slanted;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return report(arguments, tube);
  };
  const Json before = wound({}).at("u");
  EXPECT_EQ(before.at("loops").size(), 2u);
  EXPECT_EQ(before.at("loops").at(0).at("name"), "boundary-1");
  EXPECT_EQ(before.at("loops").at(0).at("winding"), 2);
  const Json rings = wound({"--winding", "0", "--anchor-boundary", "0"}).at("u");
  EXPECT_EQ(rings.at("open"), 0);
  EXPECT_EQ(rings.at("loops").at(1).at("winding"), 0);
  EXPECT_EQ(rings.at("loops").at(1).at("winding_before"), 2);
  EXPECT_EQ(rings.at("boundary_vertices_fixed"), 96);
  const Json spiral = wound({"--winding", "boundary-1:1"}).at("u");
  EXPECT_EQ(spiral.at("curves"), 1);
  EXPECT_LT(spiral.at("turned").at("largest_deg").get<double>(), 6);
  const Json sleeve = wound({"--lines", "both", "--wales", "30"}).at("v");
  EXPECT_EQ(sleeve.at("curves"), 30);
  const Json named = wound({"--lines", "both", "--wales", "boundary-2:21"}).at("v");
  EXPECT_EQ(named.at("curves"), 21);
  // Boundaries are told apart by where they are.
  const Json centers[] = {before.at("loops").at(0).at("center"),
                          before.at("loops").at(1).at("center")};
  EXPECT_GT(std::abs(centers[0].at(2).get<double>() - centers[1].at(2).get<double>()), 1);
}

TEST_F(Curves, WindingsThatCannotBeAreRefused) {
  expect_refusal(1, "no way round", {"curves", "shape:sphere,resolution=8", "--winding", "1"});
  expect_refusal(1, "loop-1, loop-2", {"curves", kTorus48, "--winding", "1"});
  for (const char* bad : {"one", "1.5", ":1", "loop-1:", "99999999999"}) {
    expect_refusal(2, "--winding", {"curves", kTorus48, "--winding", bad});
  }
  expect_refusal(1, "--anchor-boundary",
                 {"curves", kTorus48, "--anchor-boundary", "0", "--report", "r.json"});
  expect_refusal(2, "--cancel-branches", {"curves", kTorus48, "--cancel-branches", "-1"});
  for (const char* bad : {"0", "-3", "boundary-1:0", ":3", "x"}) {
    expect_refusal(2, "--wales", {"curves", kTorus48, "--lines", "v", "--wales", bad});
  }
  expect_refusal(1, "no 'boundary-1'",
                 {"curves", kTorus48, "--lines", "v", "--wales", "boundary-1:20"});
}

TEST_F(Curves, HaveFewerBranchesOnceTheseAreMerged) {
  const std::string knot = "shape:trefoil,resolution=28";
  const Json u =
      report({"--direction", "0.31,0.9,0.27", "--stripes", "24", "--cancel-branches", "0"}, knot)
          .at("u");
  EXPECT_GT(u.at("cancelled_branches").at("pairs"), 0);
  EXPECT_LT(u.at("branches"), u.at("cancelled_branches").at("branches_before"));
  EXPECT_LE(u.at("energy"), u.at("cancelled_branches").at("energy_before"));
}

}  // namespace
}  // namespace brindle::test
