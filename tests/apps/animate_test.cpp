#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#ifdef BRINDLE_HAS_GL
#include "brindle/image.h"
#endif
#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Animate : ToolTest {
  // Plays three frames with extra arguments.
  Arguments command(const Arguments& more) const {
    Arguments arguments = {"animate", kTorus32, "--frames", "3"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  Json report(Arguments more) const {
    more.insert(more.end(), {"--report", "report.json"});
    const ToolResult result = run(command(more));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(content(folder / "report.json"));
  }
};

const char* const kScenes[] = {"zoom", "vortices", "rotate", "wobble", "brush"};

TEST_F(Animate, ReportsEveryFrameOfEveryScene) {
  for (const char* scene : kScenes) {
    const Json report = this->report({"--scene", scene});
    EXPECT_EQ(report["scene"], scene);
    ASSERT_EQ(report["frames"].size(), 3u);
    for (std::size_t n = 0; n < 3; ++n) {
      const Json& frame = report["frames"][n];
      EXPECT_EQ(frame.at("frame"), n);
      EXPECT_LT(frame.at("energy").get<double>(), 0.16);
      EXPECT_EQ(frame.at("phase_step") == 0, n == 0) << scene << ' ' << n;
      for (const char* key : {"branches", "angle_error_mean_deg", "unchanged"}) {
        EXPECT_TRUE(frame.contains(key)) << key;
      }
      for (const char* key : {"scene", "couple", "sum", "solve", "render"}) {
        EXPECT_GE(frame.at("milliseconds").at(key).get<double>(), 0) << key;
      }
      EXPECT_FALSE(frame.contains("from_scratch"));
    }
  }
}

TEST_F(Animate, MetricsDoNotDependOnThreads) {
  const auto metrics = [&](const char* threads, const char* scene) {
    Json report = this->report({"--scene", scene, "--threads", threads, "--subdivide", "1"});
    EXPECT_EQ(report["threads"], std::stoi(threads));
    for (Json& frame : report["frames"]) frame.erase("milliseconds");
    return report["frames"];
  };
  for (const char* scene : kScenes) EXPECT_EQ(metrics("1", scene), metrics("2", scene)) << scene;
}

TEST_F(Animate, ComparesWithFramesFromScratch) {
  const Json report = this->report({"--compare-from-scratch"});
  const Json& last = report["frames"].back();
  EXPECT_GT(last["from_scratch"]["phase_step"].get<double>(), 0);
  EXPECT_DOUBLE_EQ(report["last_against_from_scratch"]["energy_ratio"].get<double>(),
                   last["energy"].get<double>() / last["from_scratch"]["energy"].get<double>());
  EXPECT_EQ(report["frames"][0]["energy"], report["frames"][0]["from_scratch"]["energy"]);
}

TEST_F(Animate, LambdaZeroIsFromScratch) {
  const Json report = this->report({"--solver", "multilevel,lambda=0", "--compare-from-scratch"});
  for (const Json& frame : report["frames"]) {
    EXPECT_EQ(frame["energy"], frame["from_scratch"]["energy"]);
    EXPECT_EQ(frame["phase_step"], frame["from_scratch"]["phase_step"]);
  }
}

TEST_F(Animate, TakesThePapersIterations) {
  const Json report = this->report({"--solver", "relaxation,iterations=5"});
  EXPECT_EQ(report["solver"], "relaxation");
  EXPECT_EQ(report["iterations"], 5);
}

TEST_F(Animate, PrintsAReportUnlessQuiet) {
  const ToolResult result = run(command({"--compare-from-scratch"}));
  EXPECT_NE(result.out.find("phase step"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("against from scratch"), std::string::npos) << result.out;
  const ToolResult quiet = run(command({"--quiet"}));
  EXPECT_EQ(quiet.out + quiet.err, "");
}

TEST_F(Animate, OneFrameIsEnough) {
  Arguments arguments = command({"--compare-from-scratch"});
  arguments[3] = "1";
  EXPECT_EQ(run(arguments).exit_code, 0);
}

struct AnimateUsage : Animate, testing::WithParamInterface<Arguments> {};

TEST_P(AnimateUsage, EndsWithCodeTwo) {
  expect_refusal(2, GetParam().front(), command(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(
    Animate, AnimateUsage,
    testing::Values(Arguments{"--scene", "dream"}, Arguments{"--frames", "0"},
                    Arguments{"--frames", "-1"}, Arguments{"--frames", "many"},
                    Arguments{"--solver", "multilevel,lambda=-1"},
                    Arguments{"--solver", "multilevel,lambda=1e30"},
                    Arguments{"--solver", "multilevel,lambda=nan"},
                    Arguments{"--solver", "multilevel,sweeps=-1"},
                    Arguments{"--solver", "multilevel,iterations=0"},
                    Arguments{"--solver", "global"},
                    Arguments{"--solver", "multilevel,phase-shift=common_source"},
                    Arguments{"--fps", "0"}, Arguments{"--threads", "-1"},
                    Arguments{"--direction", "0,0,0"}, Arguments{"--stripes", "0"},
                    Arguments{"--output", "frames.png"}, Arguments{"--output", "%d"},
                    Arguments{"--output", "%4d.png"}, Arguments{"--output", "%s.png"},
                    Arguments{"--output", "%04x.png"}, Arguments{"--output", "%0999d.png"},
                    Arguments{"--output", "%d%d.png"}, Arguments{"--output", "%%.png"},
                    Arguments{"--output", "%.png"}, Arguments{"--output", "%d/a.png"},
                    Arguments{"--output", "%04d.jpeg"}, Arguments{"--output", "a.gif"}));

TEST_F(Animate, ADirectionIsRefusedWhereItMeansNothing) {
  expect_refusal(2, "--direction", command({"--scene", "vortices", "--direction", "1,0,0"}));
}

TEST_F(Animate, MissingFilesAndFolders) {
  expect_refusal(1, "none.ply", {"animate", "none.ply"});
  expect_refusal(1, "none", command({"--report", "none/report.json"}));
}

#ifdef BRINDLE_HAS_GL
const Arguments kSmall = {"--size", "64x48"};

TEST_F(Animate, WritesAPictureAFrame) {
  for (const char* scene : {"zoom", "wobble", "brush"}) {
    Arguments more = {"--scene", scene, "--output", "50%%-%03d.png", "-q"};
    more.insert(more.end(), kSmall.begin(), kSmall.end());
    ASSERT_EQ(run(command(more)).exit_code, 0);
    EXPECT_EQ(listing(), (std::set<std::string>{"50%-000.png", "50%-001.png", "50%-002.png"}));
    EXPECT_NE(content(folder / "50%-000.png"), content(folder / "50%-002.png")) << scene;
  }
}

TEST_F(Animate, QualityIsDrawnAndReported) {
  for (const char* quality : {"interactive", "final"}) {
    Arguments more = {"--quality", quality, "--output", "%d.png", "--report", "a.json", "-q"};
    more.insert(more.end(), kSmall.begin(), kSmall.end());
    ASSERT_EQ(run(command(more)).exit_code, 0);
    EXPECT_EQ(Json::parse(content(folder / "a.json"))["picture_quality"], quality);
    fs::rename(folder / "1.png", folder / (std::string(quality) + ".png"));
  }
  EXPECT_NE(content(folder / "interactive.png"), content(folder / "final.png"));
}

TEST_F(Animate, MissingFolderOfFrames) {
  expect_refusal(1, "none", command({"--output", "none/%04d.png"}));
  expect_refusal(1, "none", command({"--output", "none/a.mp4"}));
}

// Videos with another program in the place of ffmpeg.
struct Video : Animate {
  fs::path programs;
  std::string path = std::getenv("PATH");

  void SetUp() override {
    Animate::SetUp();
    programs = folder.string() + "_programs";
    fs::create_directories(programs);
  }
  void TearDown() override {
    setenv("PATH", path.c_str(), 1);
    fs::remove_all(programs);
    Animate::TearDown();
  }
  void have_ffmpeg(const std::string& script) {
    write_text(programs / "ffmpeg", "#!/bin/sh\n" + script + "\n");
    fs::permissions(programs / "ffmpeg", fs::perms::owner_all);
    setenv("PATH", (programs.string() + ":" + path).c_str(), 1);
  }
  Arguments video() const {
    Arguments more = {"--output", "a.mp4", "-q"};
    more.insert(more.end(), kSmall.begin(), kSmall.end());
    return command(more);
  }
};

// The last argument of ffmpeg is the file, as file:NAME.
const char* const kCopyFrames = R"(for last; do :; done; cat > "${last#file:}")";

TEST_F(Video, HoldsEveryFrame) {
  have_ffmpeg(kCopyFrames);
  const ToolResult result = run(video());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(listing(), std::set<std::string>{"a.mp4"});
  EXPECT_EQ(content(folder / "a.mp4").size(), 3u * 64 * 48 * 4);
}

TEST_F(Video, HoldsFramesInTheirOrder) {
  // The program reads more slowly than frames are drawn, so that they wait.
  have_ffmpeg(R"(for last; do :; done
while dd bs=12288 count=1 iflag=fullblock 2> /dev/null > part && [ -s part ]; do
  cat part >> "${last#file:}"; sleep 0.05; done; rm -f part)");
  Arguments arguments = video();
  arguments.insert(arguments.end(), {"--scene", "zoom", "--output", "%d.png"});
  std::ranges::replace(arguments, std::string("3"), std::string("7"));
  const ToolResult result = run(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string frames = content(folder / "a.mp4");
  ASSERT_EQ(frames.size(), 7u * 64 * 48 * 4);
  for (std::size_t number = 0; number < 7; ++number) {
    const Image image = read_png(folder / (std::to_string(number) + ".png"));
    EXPECT_EQ(std::memcmp(image.pixels.data(), frames.data() + number * 64 * 48 * 4, 64 * 48 * 4),
              0)
        << number;
  }
}

TEST_F(Video, OfAFailingProgramLeavesNothingAndTellsWhy) {
  for (const char* script :
       {"echo too blue >&2; exit 3", "cat > /dev/null; echo too blue; exit 1"}) {
    have_ffmpeg(script);
    expect_refusal(1, "too blue", video());
  }
}

TEST_F(Video, WithoutTheProgramNamesThePackage) {
  setenv("PATH", programs.c_str(), 1);
  expect_refusal(1, "install the package 'ffmpeg'", video());
}
#else
TEST_F(Animate, PicturesAreRefusedBeforeTheWork) {
  expect_refusal(1, "BRINDLE_GL", command({"--output", "%d.png"}));
}
#endif

}  // namespace
}  // namespace brindle::test
