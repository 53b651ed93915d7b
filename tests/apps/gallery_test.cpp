#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>

#include "tool.h"

#if defined(BRINDLE_HAS_GL) && defined(BRINDLE_HAS_VTK)

#include "brindle/image.h"

namespace brindle::test {
namespace {

struct GalleryTool : ToolTest {};

struct ItemAndPicture {
  const char* item;
  const char* picture;
};

void PrintTo(const ItemAndPicture& p, std::ostream* out) { *out << p.item << ' ' << p.picture; }

struct EveryGalleryPicture : ToolTest, testing::WithParamInterface<ItemAndPicture> {};

INSTANTIATE_TEST_SUITE_P(
    Gallery, EveryGalleryPicture,
    testing::Values(ItemAndPicture{"liver", "near"}, ItemAndPicture{"liver", "far"},
                    ItemAndPicture{"nested", "focus"}, ItemAndPicture{"vortices", "still"},
                    ItemAndPicture{"aneurysm", "stress"}, ItemAndPicture{"aneurysm", "second"},
                    ItemAndPicture{"molecule", "signs"}, ItemAndPicture{"molecule", "colors"},
                    ItemAndPicture{"hatching", "pen"}, ItemAndPicture{"hatching", "dashed"},
                    ItemAndPicture{"hatching", "strokes"}, ItemAndPicture{"glyphs", "arrows"},
                    ItemAndPicture{"glyphs", "ellipses"}, ItemAndPicture{"crosses", "tiles"},
                    ItemAndPicture{"rough", "all"}, ItemAndPicture{"giant", "stripes"}));

/// The words of the command line that the tool printed, with its line breaks and quotes.
std::vector<std::string> words_of_printed(const std::string& out) {
  const std::size_t begin = out.find("brindle ");
  std::string text = out.substr(begin, out.find("\n\n", begin) - begin);
  std::vector<std::string> words(1);
  bool inside = false;
  for (const char c : text) {
    if (c == '\'') {
      inside = !inside;
    } else if (!inside && (c == ' ' || c == '\n' || c == '\\')) {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return {words.begin() + 1, words.end()};
}

/// Pixels that are unlike that in the corner.
int pixels_of_subject(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += image.at(x, y) != image.at(0, 0);
  }
  return count;
}

TEST_P(EveryGalleryPicture, IsWhatThePrintedCommandDrawsFromTheFiles) {
  const auto [item, picture] = GetParam();
  const ToolResult drawn = run({"gallery", item, "--picture", picture, "--detail", "0.25", "--size",
                                "96x72", "--quality", "interactive", "-o", "drawn.png", "-q"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(listing(), std::set<std::string>{"drawn.png"});
  const ToolResult written = run({"gallery", item, "--picture", picture, "--detail", "0.25",
                                  "--size", "96x72", "--quality", "interactive", "--data", "data"});
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const std::vector<std::string> words = words_of_printed(written.out);
  const ToolResult again = run(words);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(content(folder / words.back()), content(folder / "drawn.png"));
  const Image image = read_png(folder / "drawn.png");
  EXPECT_EQ(image.width, 96);
  EXPECT_EQ(image.height, 72);
  EXPECT_GT(pixels_of_subject(image), 50) << "nothing is seen";
}

TEST_F(GalleryTool, ListsItsItemsAndTellsOfEach) {
  const ToolResult list = run({"gallery"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_NE(list.out.find("aneurysm"), std::string::npos);
  const ToolResult item = run({"gallery", "aneurysm"});
  EXPECT_EQ(item.exit_code, 0);
  EXPECT_NE(item.out.find("brindle stripe aneurysm/aneurysm.vtp"), std::string::npos) << item.out;
  EXPECT_TRUE(listing().empty());
}

TEST_F(GalleryTool, MovesWhereItMoves) {
  const ToolResult result =
      run({"gallery", "vortices", "--picture", "flow", "--detail", "0.25", "--size", "96x72",
           "--quality", "interactive", "-q", "-o", "frame_%02d.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(listing().size(), 60);
  EXPECT_NE(content(folder / "frame_00.png"), content(folder / "frame_30.png"));
}

TEST_F(GalleryTool, TakesTheUsersOwnFiles) {
  ASSERT_EQ(run({"gallery", "aneurysm", "--detail", "0.3", "--data", "data", "-q"}).exit_code, 0);
  const auto draw = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"gallery",  "aneurysm", "--surface", "data/aneurysm.vtp",
                                      "--detail", "0.25",     "--size",    "96x72",
                                      "-q",       "-o",       "own.png"};
    words.insert(words.end(), more.begin(), more.end());
    const ToolResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "own.png");
  };
  const std::string own = draw({});
  EXPECT_NE(draw({"--values", "array:second"}), own);
  EXPECT_NE(draw({"--field", "curvature"}), own);
}

TEST_F(GalleryTool, TakesTheOptionsOfItsCommandLines) {
  const auto printed = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"gallery", "crosses"};
    words.insert(words.end(), more.begin(), more.end());
    const ToolResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return words_of_printed(result.out);
  };
  const auto value_of = [](const std::vector<std::string>& words, const std::string& option) {
    const auto at = std::find(words.begin(), words.end(), option);
    EXPECT_EQ(std::count(words.begin(), words.end(), option), 1) << option;
    return at == words.end() ? "" : *(at + 1);
  };
  const auto words = printed({"--up", "y", "--camera", "10,20", "--stripes", "30"});
  EXPECT_EQ(value_of(words, "--up"), "y");
  EXPECT_EQ(value_of(words, "--camera"), "10,20");
  EXPECT_EQ(value_of(words, "--stripes"), "30");
  // What excludes an option of the line takes its place.
  const auto by_frequency = printed({"--frequency", "2"});
  EXPECT_EQ(value_of(by_frequency, "--frequency"), "2");
  EXPECT_EQ(std::count(by_frequency.begin(), by_frequency.end(), "--stripes"), 0);
  const auto draw = [&](std::vector<std::string> more) {
    std::vector<std::string> all = {"gallery", "rough", "--detail", "0.25", "--size",
                                    "96x72",   "-q",    "-o",       "a.png"};
    all.insert(all.end(), more.begin(), more.end());
    const ToolResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return content(folder / "a.png");
  };
  const std::string plain = draw({});
  EXPECT_NE(draw({"--depth-cue", "haze"}), plain);
  EXPECT_NE(draw({"--flat"}), plain);
  expect_refusal(2, "--min-distance", {"gallery", "rough", "--min-distance", "1", "-o", "x.png"});
  expect_refusal(2, "--stripes", {"gallery", "--stripes", "30"});
}

TEST_F(GalleryTool, OwnFilesStandUpright) {
  write_text(folder / "own.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write_text(folder / "own.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_text(folder / "own.stl",
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
             "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
  const auto up_of = [&](std::vector<std::string> more) {
    std::vector<std::string> words = {"gallery", "crosses", "--surface"};
    words.insert(words.end(), more.begin(), more.end());
    const ToolResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto line = words_of_printed(result.out);
    return *(std::find(line.begin(), line.end(), "--up") + 1) +
           (result.err.find("points up") == std::string::npos ? "" : " said");
  };
  EXPECT_EQ(up_of({"own.obj"}), "y said");
  EXPECT_EQ(up_of({"own.off"}), "y said");
  EXPECT_EQ(up_of({"own.stl"}), "z said");
  EXPECT_EQ(up_of({"own.stl", "--up", "y"}), "y");
  EXPECT_EQ(up_of({"shape:box"}), "z");
}

TEST_F(GalleryTool, SaysWhatIsWrong) {
  expect_refusal(2, "did you mean 'liver'", {"gallery", "livver"});
  expect_refusal(2, "there are: signs, colors", {"gallery", "molecule", "--picture", "plus"});
  expect_refusal(2, "has no effect", {"gallery", "--output", "x.png"});
  expect_refusal(2, "write .png or .svg", {"gallery", "molecule", "--output", "x.vtp"});
  expect_refusal(2, "has no effect", {"gallery", "giant", "--values", "height", "-o", "x.png"});
  expect_refusal(2, "has no effect", {"gallery", "giant", "--detail", "0.25"});
  expect_refusal(2, "0.25 to 4", {"gallery", "giant", "--detail", "9", "-o", "x.png"});
  expect_refusal(2, "--size",
                 {"gallery", "rough", "--detail", "0.25", "--size", "9", "-o", "x.png"});
  expect_refusal(1, "none", {"gallery", "giant", "--detail", "0.25", "-o", "none/x.png"});
  expect_refusal(1, "none.vtp",
                 {"gallery", "rough", "--detail", "0.25", "--surface", "none.vtp", "-o", "x.png"});
  write_text(folder / "square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  expect_refusal(
      1, "stress",
      {"gallery", "aneurysm", "--detail", "0.25", "--surface", "square.obj", "-o", "x.png"});
  expect_refusal(2, "--surface",
                 {"gallery", "rough", "--surface", "square.obj", "-o", "square.obj"});
  ASSERT_EQ(run({"gallery", "rough", "--detail", "0.25", "--data", ".", "-q"}).exit_code, 0);
  expect_refusal(2, "--data",
                 {"gallery", "rough", "--detail", "0.25", "--surface", "rough.vtp", "--data", "."});
}

}  // namespace
}  // namespace brindle::test

#endif
