#include "brindle/base/input_stream.h"

#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "brindle/base/output_file.h"
#include "brindle/error.h"
#include "test_folder.h"

namespace brindle {
namespace {

struct InputStream : TestFolder {
  static std::string refusal(const std::filesystem::path& path) {
    try {
      open_input(path, "a mesh file");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(InputStream, HasTheBytesOfTheFile) {
  const std::string bytes("a\r\n\0\xff", 5);
  write_file(folder / "a", [&](std::ostream& out) { out << bytes; });
  EXPECT_EQ(whole_input(folder / "a", "a mesh file"), bytes);
}

// None of these may wait for somebody to write, or read for ever.
TEST_F(InputStream, PipesAndDevicesAreRefusedWithTheRemedy) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder / "link");
  for (const auto& path : {folder / "pipe", folder / "link", std::filesystem::path("/dev/zero")}) {
    const std::string message = refusal(path);
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    EXPECT_NE(message.find("save a mesh file first"), std::string::npos) << message;
  }
}

TEST_F(InputStream, FoldersAndWhatIsNotThereAreRefused) {
  EXPECT_NE(refusal(folder).find("is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder / "none").find("no such file"), std::string::npos);
  EXPECT_NE(refusal(folder / "\n\xff").find("\\x0a\\xff: there is no"), std::string::npos);
}

}  // namespace
}  // namespace brindle
