// Frequencies that follow values which need no array.
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "brindle/base/array_numbers.h"
#include "brindle/files.h"
#include "tool.h"

namespace brindle::test {
namespace {

using Arguments = std::vector<std::string>;
using Json = nlohmann::json;

constexpr int kSide = 21;

struct FrequencyValues : ToolTest {
  /// A flat square from 0 to 1 in the plane of x and y, moved by `x`; a CSV file with its x.
  void write_square(const std::string& name, double x) {
    std::ostringstream mesh, column;
    column << "x\n";
    mesh.precision(17);
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        mesh << "v " << x + i / (kSide - 1.0) << ' ' << j / (kSide - 1.0) << " 0\n";
        column << i / (kSide - 1.0) << '\n';
      }
    }
    for (int i = 1; i < kSide; ++i) {
      for (int j = 1; j < kSide; ++j) {
        const int v = kSide * i + j + 1;
        mesh << "f " << v - kSide - 1 << ' ' << v - 1 << ' ' << v << '\n'
             << "f " << v - kSide - 1 << ' ' << v << ' ' << v - kSide << '\n';
      }
    }
    write_text(folder / (name + ".obj"), mesh.str());
    write_text(folder / (name + ".csv"), column.str());
  }
  Json report(Arguments more) {
    more.insert(more.begin(), {"stripe"});
    more.insert(more.end(), {"--direction", "1,0,0", "--report", "report.json", "-q"});
    const ToolResult result = run(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::ifstream in(folder / "report.json");
    return Json::parse(in);
  }
  std::vector<double> frequencies(Arguments more) {
    more.insert(more.begin(), {"stripe"});
    more.insert(more.end(), {"--direction", "1,0,0", "-o", "made.ply", "-q"});
    const ToolResult result = run(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const LoadedMesh made = read_mesh(folder / "made.ply");
    return doubles_of(find_array(made.arrays.points, "frequency")->view());
  }
  /// Samples with a larger x than the square's middle less those with a smaller one.
  int balance(Arguments more) {
    more.insert(more.begin(), {"sample", "square.obj", "--direction", "1,0,0"});
    more.insert(more.end(), {"-o", "samples.csv", "-q"});
    EXPECT_EQ(run(more).exit_code, 0);
    std::istringstream rows(content(folder / "samples.csv"));
    std::string row;
    std::getline(rows, row);
    int balance = 0;
    while (std::getline(rows, row)) balance += std::stod(row) > 0.5 ? 1 : -1;
    return balance;
  }
};

TEST_F(FrequencyValues, ReachTheEndsOfTheRange) {
  write_square("square", 0);
  const Arguments values = {"distance:0,0,0", "square.csv", "square.csv:x", "distance:0,-1e4,0"};
  for (const std::string& value : values) {
    const Json metrics =
        report({"square.obj", "--frequency", "10", "--frequency-by", value + "@0.5..2"});
    EXPECT_NEAR(metrics.at("frequency_min").get<double>(), 5, 1e-5) << value;
    EXPECT_NEAR(metrics.at("frequency_max").get<double>(), 20, 1e-5) << value;
  }
}

TEST_F(FrequencyValues, GrowEvenlyWithTheDistance) {
  write_square("square", 0);
  const auto frequencies = this->frequencies(
      {"square.obj", "--frequency", "8", "--frequency-by", "distance:0,0.5,0@0.5..2"});
  const double farthest = std::hypot(1, 0.5);
  ASSERT_EQ(frequencies.size(), static_cast<std::size_t>(kSide * kSide));
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double distance = std::hypot(i / (kSide - 1.0), j / (kSide - 1.0) - 0.5);
      EXPECT_NEAR(frequencies[kSide * i + j], 8 * (0.5 + 1.5 * distance / farthest), 1e-4);
    }
  }
  EXPECT_GT(balance({"--frequency-by", "distance:-3000,0.5,0"}), 20);
  EXPECT_LT(balance({"--frequency-by", "distance:3000,0.5,0"}), -20);
}

TEST_F(FrequencyValues, CountInTheCoordinatesOfTheFile) {
  // A float has no such place.
  constexpr double kFar = 7000000.3;
  write_square("square", 0);
  write_square("far", kFar);
  const auto here = frequencies({"square.obj", "--frequency-by", "distance:0.25,0.5,0"});
  const auto far = frequencies({"far.obj", "--frequency-by", "distance:7000000.55,0.5,0"});
  ASSERT_EQ(here.size(), far.size());
  for (std::size_t v = 0; v < here.size(); ++v) EXPECT_NEAR(far[v], here[v], 1e-4 * here[v]);
}

TEST_F(FrequencyValues, ThatAreMissingLeaveNoWave) {
  write_square("square", 0);
  std::string column = "a,b\n";
  for (int v = 0; v < kSide * kSide; ++v) {
    column += (v == 7 || v == 40 ? "nan," : std::to_string(v) + ",") + "nan\n";
  }
  write_text(folder / "holes.csv", column);
  const Json metrics = report({"square.obj", "--frequency-by", "holes.csv:a"});
  EXPECT_EQ(metrics.at("vertices_without_frequency"), 2);
  expect_refusal(1, "no finite number", {"stripe", "square.obj", "--frequency-by", "holes.csv:b"});
  expect_refusal(1, "several columns", {"stripe", "square.obj", "--frequency-by", "holes.csv"});
  expect_refusal(2, "X,Y,Z", {"stripe", "square.obj", "--frequency-by", "distance:1"});
  expect_refusal(2, "distance:X,Y,Z", {"stripe", "square.obj", "--frequency-by", "heigth"});
  expect_refusal(2, "'holes.csv' is read by --frequency-by",
                 {"sample", "square.obj", "--frequency-by", "holes.csv:a", "-o", "holes.csv"});
}

TEST_F(FrequencyValues, OfACameraNeedOne) {
  write_square("square", 0);
  for (const char* value : {"distance:camera", "light"}) {
    expect_refusal(2, "camera", {"compare", "square.obj", "--frequency-by", value});
#ifndef BRINDLE_HAS_GL
    expect_refusal(2, "camera", {"stripe", "square.obj", "--frequency-by", value});
#endif
  }
}

#ifdef BRINDLE_HAS_GL

TEST_F(FrequencyValues, FollowTheCamera) {
  write_square("square", 0);
  const auto from = [&](const std::string& camera, const std::string& range) {
    return balance({"--frequency-by", "distance:camera@" + range, "--camera", camera, "--up", "z"});
  };
  // Azimuth 90 looks from +x: what is near has a larger x.
  EXPECT_GT(from("90,20", "0.3..2,inverse"), 20);
  EXPECT_LT(from("90,20", "0.3..2"), -20);
  EXPECT_LT(from("-90,20", "0.3..2,inverse"), -20);
}

TEST_F(FrequencyValues, FollowTheCameraInASeries) {
  write_square("step0", 0);
  write_square("step1", 3);
  ASSERT_EQ(run({"animate", "--series", "step%d.obj", "--direction", "1,0,0", "--frequency-by",
                 "distance:camera", "--report", "report.json", "-q"})
                .exit_code,
            0);
  expect_refusal(2, "--camera",
                 {"stripe", "step0.obj", "--frequency-by", "height", "--camera", "1,2"});
}

#endif

}  // namespace
}  // namespace brindle::test
