#include "window/base/window_settings.h"

#include <fstream>

#include <gtest/gtest.h>

#include "test_folder.h"

namespace brindle::tool {
namespace {

using WindowSettingsTest = TestFolder;

TEST_F(WindowSettingsTest, WhatIsWrittenIsReadAgain) {
  WindowSettings settings;
  settings.recent = {"/a/horse.ply", "shape:torus,minor=0.2"};
  settings.dark = false;
  settings.show_metrics = false;
  settings.folder = "/a";
  const auto path = folder / "deep" / "below" / "window.json";
  write_settings(path, settings);
  const WindowSettings read = read_settings(path);
  EXPECT_EQ(read.recent, settings.recent);
  EXPECT_EQ(read.dark, settings.dark);
  EXPECT_EQ(read.show_options, settings.show_options);
  EXPECT_EQ(read.show_metrics, settings.show_metrics);
  EXPECT_EQ(read.folder, settings.folder);
}

TEST_F(WindowSettingsTest, SpoiltFilesAreAsIfTheyWereNotThere) {
  const auto path = folder / "window.json";
  for (const char* text : {"", "{", "[1, 2]", R"({"recent": 3, "dark": "very"})"}) {
    std::ofstream(path) << text;
    const WindowSettings read = read_settings(path);
    EXPECT_TRUE(read.recent.empty());
    EXPECT_TRUE(read.dark);
  }
  EXPECT_TRUE(read_settings(folder / "missing.json").recent.empty());
}

TEST(RecentFilesTest, TheNewestComesFirstAndOnce) {
  WindowSettings settings;
  for (int i = 0; i < 20; ++i) remember(settings, "/mesh" + std::to_string(i) + ".ply");
  remember(settings, "/mesh15.ply");
  remember(settings, "shape:torus");
  ASSERT_EQ(settings.recent.size(), 12);
  EXPECT_EQ(settings.recent[0], "shape:torus");
  EXPECT_EQ(settings.recent[1], "/mesh15.ply");
  EXPECT_EQ(settings.recent[2], "/mesh19.ply");
  EXPECT_EQ(std::ranges::count(settings.recent, "/mesh15.ply"), 1);
}

TEST(RecentFilesTest, WhatCannotBeReadIsForgotten) {
  WindowSettings settings;
  remember(settings, "bad.ply");  // by its whole path
  remember(settings, "/good.ply");
  EXPECT_TRUE(forget(settings, "bad.ply"));
  EXPECT_FALSE(forget(settings, "bad.ply"));
  EXPECT_EQ(settings.recent, std::vector<std::string>{"/good.ply"});
}

}  // namespace
}  // namespace brindle::tool
