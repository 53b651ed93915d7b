// Every example that the program's help shows runs, with smaller pictures and fewer frames.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include "tool.h"
#include "vtp_text.h"

#if defined(BRINDLE_HAS_GL) && defined(BRINDLE_HAS_CHOLMOD) && defined(BRINDLE_HAS_NANOFLANN)

namespace brindle::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

Arguments words_of(const std::string& line) {
  std::istringstream in(line);
  Arguments words;
  for (std::string word; in >> word;) {
    std::erase(word, '\'');
    words.push_back(word);
  }
  return words;
}

// The lines of a help text that call the program, without its name.
std::vector<Arguments> examples_in(const std::string& help) {
  std::vector<Arguments> examples;
  std::istringstream lines(help);
  bool reached = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Examples:")) reached = true;
    Arguments words = words_of(line);
    if (!reached || words.empty() || words.front() != "brindle") continue;
    examples.emplace_back(words.begin() + 1, words.end());
  }
  return examples;
}

void set_option(Arguments& arguments, const std::string& option, const std::string& value) {
  const auto found = std::find(arguments.begin(), arguments.end(), option);
  if (found != arguments.end()) {
    *(found + 1) = value;
  } else {
    arguments.insert(arguments.end(), {option, value});
  }
}

bool draws(const Arguments& arguments) {
  const auto output = std::find(arguments.begin(), arguments.end(), "--output");
  return output != arguments.end() &&
         ((output + 1)->ends_with(".png") || (output + 1)->ends_with(".mp4"));
}

// The same command with less to do.
Arguments shortened(Arguments arguments) {
  if (draws(arguments)) set_option(arguments, "--size", "64x48");
  const bool series = std::ranges::find(arguments, "--series") != arguments.end();
  if (arguments.front() == "animate" && !series) set_option(arguments, "--frames", "2");
  if (arguments.front() == "gallery" && arguments.size() > 1)
    set_option(arguments, "--detail", "0.25");
  return arguments;
}

struct Examples : ToolTest {
  std::string path = std::getenv("PATH");

  // A surface with a flow along it, and a plate with stresses.
  void write_data() const {
    TextMesh mesh;
    std::istringstream scan(content(folder / "scan.obj"));
    for (std::string line; std::getline(scan, line);) {
      const Arguments words = words_of(line);
      if (words.size() != 4) continue;
      if (words[0] == "v") {
        mesh.positions.push_back({std::stod(words[1]), std::stod(words[2]), std::stod(words[3])});
      } else if (words[0] == "f") {
        mesh.triangles.push_back(
            {std::stoi(words[1]) - 1, std::stoi(words[2]) - 1, std::stoi(words[3]) - 1});
      }
    }
    TextArray velocity{"velocity", 3, {}}, speed{"speed", 1, {}}, stress{"stress", 6, {}};
    for (const auto& [x, y, z] : mesh.positions) {
      velocity.numbers.insert(velocity.numbers.end(), {-y, x, 0.1});
      speed.numbers.push_back(std::hypot(x, y));
      stress.numbers.insert(stress.numbers.end(), {3, 1 + x, 2, y, 0, 0});
    }
    mesh.points = {velocity, speed, stress};
    for (const char* name : {"flow.vtp", "plate.vtp"}) write_text(folder / name, vtp_text(mesh));
    std::string branch_penalty;
    for (const auto& [x, y, z] : mesh.positions) branch_penalty += z > 0 ? "1\n" : "0\n";
    write_text(folder / "face.csv", branch_penalty);
  }

  // Two steps of each kind.
  void write_series() const {
    for (const char* step : {"v0000.vtp", "v0001.vtp", "step2.vtp"}) {
      fs::copy_file(folder / "flow.vtp", folder / step);
    }
    for (const char* step : {"wind0000.csv", "wind0001.csv"}) {
      fs::copy_file(folder / "wind.csv", folder / step);
    }
    write_text(folder / "run.pvd",
               "<VTKFile type=\"Collection\"><Collection>"
               "<DataSet timestep=\"0\" file=\"v0000.vtp\"/>"
               "<DataSet timestep=\"1\" file=\"v0001.vtp\"/></Collection></VTKFile>");
    make({"stripe", "flow.vtp", "-o", "step1_stripes.vtp"});
  }

  // The files that examples speak of.
  void SetUp() override {
    ToolTest::SetUp();
    make({"stripe", "shape:torus,resolution=24", "-o", "horse.ply", "-o", "scan.obj"});
    make({"stripe", "shape:torus,resolution=24", "--points", "-o", "points.ply"});
    make({"stripe", "shape:torus,resolution=24", "--size", "32x32", "-o", "cloth.png"});
    std::string field;
    std::string points;
    std::istringstream scan(content(folder / "scan.obj"));
    for (std::string line; std::getline(scan, line);) {
      const Arguments words = words_of(line);
      if (words.size() < 4 || words.front() != "v") continue;
      field += "-" + words[2] + "," + words[1] + ",0.1,12\n";
      points += words[1] + "," + words[2] + "," + words[3] + "\n";
    }
    // "--1" where a coordinate is negative.
    for (std::size_t at = 0; (at = field.find("--")) != std::string::npos;) field.erase(at, 2);
    write_data();
    for (const char* name : {"wind.csv", "importance.csv"}) write_text(folder / name, field);
    write_text(folder / "points.csv", points);
    write_series();
    write_text(folder / "session.json",
               "{\"brindle_session\": 1, \"mesh\": \"horse.ply\", \"size\": [64, 48]}");
    write_text(folder / "events.jsonl", "{\"command\": \"set_option\", \"name\": \"along\"}");
    fs::create_directory(folder / "frames");
    write_text(folder / "ffmpeg", "#!/bin/sh\nfor last; do :; done; cat > \"${last#file:}\"\n");
    fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
    setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
  }
  void TearDown() override {
    setenv("PATH", path.c_str(), 1);
    ToolTest::TearDown();
  }
  void make(Arguments arguments) const {
    arguments.push_back("--quiet");
    const ToolResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
};

// Of one command, or of the program where it is empty.
std::vector<Arguments> examples_of(const ToolTest& test, const std::string& command) {
  const ToolResult help =
      command.empty() ? test.run({"--help"}) : test.run({command, "--help-all"});
  return examples_in(help.out);
}

const std::vector<std::string> kCommands = {"",        "stripe",  "compare", "curves",
                                            "sample",  "animate", "info",    "render",
                                            "gallery", "paths",   "relief"};

// A test for each, so that they can run beside each other.
struct ExamplesOf : Examples, testing::WithParamInterface<std::string> {};

TEST_P(ExamplesOf, HelpRun) {
  const std::vector<Arguments> examples = examples_of(*this, GetParam());
  EXPECT_FALSE(examples.empty());
  for (const Arguments& example : examples) {
    std::string line;
    for (const std::string& word : example) line += ' ' + word;
    const ToolResult result = run(shortened(example));
    EXPECT_EQ(result.exit_code, 0) << "brindle" << line << '\n' << result.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ExamplesOf, testing::ValuesIn(kCommands), [](const auto& of) {
  return of.param.empty() ? std::string("tool") : of.param;
});

TEST_F(ToolTest, HelpShowsMoreThanThirtyExamples) {
  std::size_t count = 0;
  for (const std::string& command : kCommands) count += examples_of(*this, command).size();
  EXPECT_GT(count, 30u);
}

}  // namespace
}  // namespace brindle::test

#endif
