#include "brindle/base/input_file.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "brindle/base/output_file.h"
#include "brindle/error.h"
#include "test_folder.h"

namespace brindle {
namespace {

struct OpenInput : TestFolder {
  static std::string refusal(const std::filesystem::path& path) {
    try {
      open_input(path, "a mesh file");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(OpenInput, HasTheBytesOfTheFile) {
  const std::string bytes("a\r\n\0\xff", 5);
  write_file(folder / "a", [&](OutputStream& out) { out << bytes; });
  EXPECT_EQ(whole_input(folder / "a", "a mesh file"), bytes);
}

TEST_F(OpenInput, ReadsFromAnywhereAndSaysHowMuchThereWas) {
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i % 251);
  write_file(folder / "a", [&](OutputStream& out) { out << bytes; });
  EXPECT_EQ(whole_input(folder / "a", "a mesh file"), bytes);
  InputStream stream = open_input(folder / "a", "a mesh file");
  std::string part(70000, '\0');
  EXPECT_EQ(stream.read(part.data(), part.size()), part.size());
  EXPECT_EQ(part, bytes.substr(0, 70000));
  EXPECT_EQ(stream.place(), 70000u);
  EXPECT_EQ(stream.read(part.data(), part.size()), 30000u);
  EXPECT_EQ(part.substr(0, 30000), bytes.substr(70000));
  EXPECT_EQ(stream.read(part.data(), 1), 0u);
  stream.seek(99990);
  EXPECT_EQ(stream.read(part.data(), 100), 10u);
  EXPECT_EQ(part.substr(0, 10), bytes.substr(99990));
  EXPECT_FALSE(stream.bad());
}

TEST_F(OpenInput, LinesAreThoseOfTheFileHoweverLong) {
  const std::string lengthy(200000, 'x');
  const std::vector<std::string> lines = {"", "a", lengthy, "", std::string(65536, 'y'), "b\r"};
  for (const bool ended : {true, false}) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    if (!ended) text.pop_back();
    write_file(folder / "a", [&](OutputStream& out) { out << text; });
    InputLines file(open_input(folder / "a", "a CSV file"));
    std::string line;
    for (const std::string& expected : lines) {
      ASSERT_TRUE(file.next(line));
      EXPECT_EQ(line, expected);
    }
    EXPECT_FALSE(file.next(line));
  }
}

// None of these may wait for somebody to write, or read for ever.
TEST_F(OpenInput, PipesAndDevicesAreRefusedWithTheRemedy) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder / "link");
  for (const auto& path : {folder / "pipe", folder / "link", std::filesystem::path("/dev/zero")}) {
    const std::string message = refusal(path);
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    EXPECT_NE(message.find("save a mesh file first"), std::string::npos) << message;
  }
}

TEST_F(OpenInput, FoldersAndWhatIsNotThereAreRefused) {
  EXPECT_NE(refusal(folder).find("is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder / "none").find("no such file"), std::string::npos);
  EXPECT_NE(refusal(folder / "\n\xff").find("\\x0a\\xff: there is no"), std::string::npos);
}

}  // namespace
}  // namespace brindle
