// Frequencies that yield, from the command line.
#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "brindle/files.h"
#include "tool.h"

namespace brindle::test {
namespace {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const char* const kTrefoil = "shape:trefoil,resolution=48";

struct SlackTest : ToolTest {
  Json report(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--direction", "0.31,0.9,0.27", "--report", "report.json"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
  std::vector<DataArray> arrays(const std::string& file) const {
    return read_mesh(folder / file).arrays.points;
  }
};

float number(const DataArray& array, std::size_t row) {
  float value = 0;
  std::memcpy(&value, array.bytes.data() + row * sizeof value, sizeof value);
  return value;
}

const DataArray& named(const std::vector<DataArray>& arrays, const std::string& name) {
  const auto found = std::ranges::find(arrays, name, &DataArray::name);
  if (found == arrays.end()) throw std::runtime_error("no array " + name);
  return *found;
}

TEST_F(SlackTest, OfZeroChangesNothing) {
  Json plain = report({"stripe", kTrefoil, "--output", "plain.ply"});
  Json zero = report({"stripe", kTrefoil, "--slack", "0", "--output", "zero.ply"});
  EXPECT_EQ(content(folder / "plain.ply"), content(folder / "zero.ply"));
  for (const char* key : {"options", "milliseconds"}) {
    plain.erase(key);
    zero.erase(key);
  }
  EXPECT_EQ(plain, zero);
  EXPECT_FALSE(zero.contains("frequency_change"));
}

TEST_F(SlackTest, CurvesAreMeasuredAgainstWhatWasAskedForAndWhatWasChosen) {
  const Arguments plain = {"curves", kTrefoil, "--path-width", "1%"};
  Arguments slack = plain;
  slack.insert(slack.end(), {"--slack", "0.25"});
  const Json u = report(slack)["u"], without = report(plain)["u"];
  for (const char* key : {"mean", "deviation", "share_within_10_percent"}) {
    const std::string wanted = std::string(key) + "_wanted";
    EXPECT_NE(u["spacing"].at(key), u["spacing"].at(wanted)) << key;
    EXPECT_FALSE(without["spacing"].contains(wanted)) << key;
  }
  // Curves keep to the frequencies chosen, which differ from those asked for by up to a quarter.
  EXPECT_GT(u["spacing"]["share_within_10_percent"],
            u["spacing"]["share_within_10_percent_wanted"]);
  for (const char* key : {"least_ratio", "mean_ratio", "most_ratio"}) {
    const std::string chosen = std::string(key) + "_chosen";
    EXPECT_TRUE(u["gaps"].contains(chosen)) << key;
    EXPECT_FALSE(without["gaps"].contains(chosen)) << key;
  }
  const double frequency = without["gaps"]["mean_ratio"].get<double>() /
                           without["gaps"]["mean"].get<double>();  // the same everywhere
  EXPECT_NEAR(u["gaps"]["mean_ratio"].get<double>(), frequency * u["gaps"]["mean"].get<double>(),
              1e-4);
  EXPECT_GT(u["coverage"], u["covered_twice"]);
  EXPECT_GT(u["covered_twice"], 0);
}

TEST_F(SlackTest, TimesOfFrequenciesAreToldOfWoundStripesToo) {
  // A straight one: the direction then has one way round.
  const Arguments tube = {"curves", "shape:cylinder,resolution=32", "--stripes", "16", "--slack",
                          "0.1"};
  Arguments wound = tube;
  wound.insert(wound.end(), {"--winding", "2"});
  EXPECT_GT(report(tube)["milliseconds"]["frequency"], 0);
  EXPECT_GT(report(wound)["milliseconds"]["frequency"], 0);
}

TEST_F(SlackTest, LeavesFewerBranchesAndSaysWhatItDid) {
  const Json plain = report({"stripe", kTrefoil});
  const Json slack = report({"stripe", kTrefoil, "--slack", "0.25", "--output", "slack.vtp"});
  EXPECT_LT(slack["branches"].get<double>(), 0.75 * plain["branches"].get<double>());
  EXPECT_LT(slack["angle_error_mean_deg"], plain["angle_error_mean_deg"]);
  const Json& change = slack["frequency_change"];
  EXPECT_NEAR(change["ratio_min"].get<double>(), 0.8, 1e-4);
  EXPECT_LE(change["ratio_max"].get<double>(), 1.25 + 1e-4);
  EXPECT_NEAR(change["ratio_mean"].get<double>(), 1, 1e-4);
  EXPECT_GT(change["share_at_bounds"], 0);
  EXPECT_GT(change["spacing_error_wanted_mean"], slack["spacing_error_mean"]);
  EXPECT_GT(slack["milliseconds"]["frequency"], 0);
  const auto written = arrays("slack.vtp");
  const DataArray& chosen = named(written, "frequency");
  const DataArray& wanted = named(written, "frequency_wanted");
  float least = 1, most = 1;
  for (std::size_t v = 0; v < chosen.rows(); ++v) {
    const float ratio = number(chosen, v) / number(wanted, v);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  EXPECT_NEAR(static_cast<double>(least), change["ratio_min"].get<double>(), 1e-5);
  EXPECT_NEAR(static_cast<double>(most), change["ratio_max"].get<double>(), 1e-5);
}

TEST_F(SlackTest, IsForEveryCommandThatSolves) {
  const char* const torus = "shape:torus,resolution=40";
  const Json curves = report({"curves", torus, "--lines", "both", "--slack", "0.2"});
  EXPECT_TRUE(curves["u"].contains("frequency_change"));
  EXPECT_TRUE(curves["v"].contains("frequency_change"));
  const Json samples = report({"sample", torus, "--slack", "0.2"});
  EXPECT_TRUE(samples.contains("frequency_change_u"));
  EXPECT_TRUE(samples.contains("frequency_change_v"));
  const Json texture = report({"stripe", torus, "--texture", "checker", "--slack", "0.2"});
  EXPECT_TRUE(texture.contains("frequency_change"));
  EXPECT_TRUE(texture["texture"].contains("frequency_change_v"));
  const Json cross = report({"stripe", torus, "--cross", "--slack", "0.2"});
  EXPECT_TRUE(cross.contains("frequency_change"));
  const Json points = report({"stripe", torus, "--points", "--slack", "0.2"});
  EXPECT_TRUE(points.contains("frequency_change"));
  const Json frames = report({"animate", torus, "--frames", "3", "--slack", "0.2"});
  EXPECT_TRUE(frames["frames"][2].contains("frequency_change"));
  ASSERT_EQ(run({"compare", torus, "--slack", "0.2", "--json", "all.json"}).exit_code, 0);
  for (const Json& solver : Json::parse(content(folder / "all.json"))) {
    EXPECT_TRUE(solver.contains("frequency_change"));
  }
}

/// A row for each vertex of a shape of so many.
std::string calm_rows(std::size_t count, const std::string& first = "1") {
  std::string text = "avoid_branches\n" + first + "\n";
  for (std::size_t v = 1; v < count; ++v) text += v < count / 2 ? "1\n" : "0\n";
  return text;
}

TEST_F(SlackTest, PenaltiesAreReadAndCounted) {
  const std::size_t count = report({"stripe", kTrefoil})["vertices"];
  write_text(folder / "none.csv", calm_rows(count));
  const Json branch_penalty =
      report({"stripe", kTrefoil, "--slack", "0.1", "--avoid-branches", "none.csv"});
  const Json& change = branch_penalty["frequency_change"];
  EXPECT_LT(change["branches_in_avoided_area"], branch_penalty["branches"]);
  EXPECT_GT(change["ratio_max"], 1.15);  // three times the slack
}

TEST_F(SlackTest, OfNoUseIsRefused) {
  const Arguments stripe = {"stripe", kTrefoil, "--slack"};
  for (const char* bad : {"-0.1", "inf", "nan", "little", ""}) {
    Arguments arguments = stripe;
    arguments.emplace_back(bad);
    expect_refusal(2, "--slack", arguments);
  }
  write_text(folder / "avoid.csv", "1\n0\n");
  expect_refusal(2, "add --slack", {"stripe", kTrefoil, "--avoid-branches", "avoid.csv"});
  expect_refusal(2, "add --slack", {"animate", kTrefoil, "--avoid-branches", "avoid.csv"});
}

TEST_F(SlackTest, PenaltiesThatDoNotFitAreRefused) {
  const char* const shape = "shape:plane,resolution=5";
  const auto refuse = [&](const std::string& rows, const std::string& message) {
    write_text(folder / "avoid.csv", rows);
    expect_refusal(1, message,
                   {"stripe", shape, "--slack", "0.1", "--avoid-branches", "avoid.csv"});
  };
  refuse("1\n0\n", "'avoid.csv' ends at line 2 after 2 rows");
  refuse("1\n0\n", "give one row per vertex");
  refuse("0.5\n1.5\n", "line 2: avoid_branches is 1.5; give a number from 0 to 1");
  refuse("0.5\nnan\n", "line 2: avoid_branches is nan");
  refuse("-0.5\n", "line 1: avoid_branches is -0.5");
  refuse("0.5\nvery\n", "line 2");
  refuse("1,2\n", "line 1: 2 columns");
  refuse("id,quiet\n1,1\n", "no column of numbers named avoid_branches");
  expect_refusal(1, "missing.csv",
                 {"stripe", shape, "--slack", "0.1", "--avoid-branches", "missing.csv"});
}

}  // namespace
}  // namespace brindle::test
