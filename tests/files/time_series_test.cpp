#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct PvdFile : TestFolder {
  void SetUp() override { fs::create_directories(folder / "steps"); }

  std::string written(const std::vector<TimedFile>& files) const {
    write_pvd(folder / "run.pvd", files);
    std::ifstream in(folder / "run.pvd");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
};

TEST_F(PvdFile, NamesFilesAsSeenFromItsFolder) {
  const std::string text =
      written({{0, folder / "a.vtp"}, {0.25, folder / "steps" / "b.vtp"}, {1e-9, "c<&\".vtp"}});
  EXPECT_NE(text.find("timestep=\"0\" part=\"0\" file=\"a.vtp\""), std::string::npos) << text;
  EXPECT_NE(text.find("timestep=\"0.25\" part=\"0\" file=\"steps/b.vtp\""), std::string::npos)
      << text;
  EXPECT_NE(text.find("file=\"c&lt;&amp;&quot;.vtp\""), std::string::npos) << text;
}

#ifdef BRINDLE_HAS_VTK
TEST_F(PvdFile, ComesBackInTheOrderOfTimes) {
  const std::vector<TimedFile> files = {
      {3, folder / "z&y.vtp"}, {0.1, folder / "steps" / "b c.vtp"}, {-1e300, folder / "a.vtp"}};
  written(files);
  const std::vector<TimedFile> read = read_pvd(folder / "run.pvd");
  ASSERT_EQ(read.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read[i].time, files[2 - i].time);
    EXPECT_EQ(read[i].file, files[2 - i].file);
  }
}

TEST_F(PvdFile, AnyPartOfAFileIsReadOrRefused) {
  const std::string whole = written({{0, folder / "a.vtp"}, {1, folder / "b.vtp"}});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    std::ofstream(folder / "run.pvd") << whole.substr(0, length);
    try {
      EXPECT_EQ(read_pvd(folder / "run.pvd").size(), 2u) << length;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("run.pvd"), std::string::npos) << error.what();
    }
  }
}
#endif

TEST_F(PvdFile, SeriesComeBackInTheOrderOfTimes) {
  const std::string text =
      R"({"file-series-version": "1.0", "files": [{"name": "b.vtu", "time": 2.5},
          {"name": "sub/a.vtu", "time": 1}]})";
  std::ofstream(folder / "run.vtu.series") << text;
  const std::vector<TimedFile> read = read_file_series(folder / "run.vtu.series");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].file, folder / "sub/a.vtu");
  EXPECT_EQ(read[0].time, 1);
  EXPECT_EQ(read[1].file, folder / "b.vtu");
  for (std::size_t length = 1; length < text.size(); ++length) {
    std::ofstream(folder / "cut.series") << text.substr(0, length);
    EXPECT_THROW(read_file_series(folder / "cut.series"), Error) << length;
  }
  for (const char* wrong : {"[]", "{}", R"({"files": []})", R"({"files": [{"name": "a"}]})",
                            R"({"files": [{"name": 1, "time": 2}]})", R"({"files": [1]})",
                            R"({"files": [{"name": "a", "time": 1}, {"name": "b", "time": 1}]})"}) {
    std::ofstream(folder / "wrong.series") << wrong;
    EXPECT_THROW(read_file_series(folder / "wrong.series"), Error) << wrong;
  }
}

}  // namespace
}  // namespace brindle
