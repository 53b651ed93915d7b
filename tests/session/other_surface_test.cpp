#include "pictures/other_surface.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

TEST(OtherSurface, ReadsWhatItWrites) {
  for (const char* text :
       {"a b.ply", "shape:torus,resolution=8@striped", "x@discarded@stripes=12.5@rotate=-30",
        "x@striped@stripe-width=0.25@stripe-color=#102030@untinted@whole@#ff0080@1,-2.5,0.125",
        "x@discarded@texture=dots@stripes=8@stripe-color=#102030@outlined", "x@outlined@#102030",
        "x@texture=plusminus@color-by=array:points/a b@#ff0080",
        "x.vtp@striped@color-by=distance:1,2,-3@untinted@4,5,6", "x@color-by=y.csv:z"}) {
    const OtherSurfaceChoice choice = parse_other_surface("--with", text);
    EXPECT_EQ(text_of(choice), text);
    EXPECT_EQ(parse_other_surface("--with", text_of(choice)), choice);
  }
  const OtherSurfaceChoice named = parse_other_surface("--with", "x@steelblue@opaque");
  EXPECT_EQ(parse_other_surface("--with", text_of(named)), named);
  EXPECT_EQ(text_of(parse_other_surface("--with", "x@texture=dots@discarded")),
            "x@discarded@texture=dots");
}

TEST(OtherSurface, RefusesWhatHasNoEffect) {
  for (const char* text : {"x@stripes=3",
                           "x@opaque@rotate=3",
                           "x@stripe-width=0.2",
                           "x@stripe-color=red",
                           "x@striped@texture=dots",
                           "x@striped@opaque",
                           "x@discarded@striped",
                           "x@texture=dots@texture=plus",
                           "x@red@#00ff00",
                           "x@1,0,0@0,1,0",
                           "x@texture=dots@stripe-width=0.2",
                           "x@striped@color-by=height@stripe-color=red",
                           "x@discarded@color-by=height@#ffffff",
                           "x@discarded@texture=dots@color-by=height@stripe-color=red",
                           "x@discarded@texture=dots@color-by=height@#ffffff",
                           "x@color-by=light",
                           "x@color-by=distance:camera",
                           "x@color-by=coherence",
                           "x@color-by=",
                           "x@color-by=array:",
                           "x@color-by=red",
                           "x@texture=",
                           "x@texture=leaf.png",
                           "x@outline",
                           "x@outlined=1"}) {
    EXPECT_THROW(parse_other_surface("--with", text), CLI::ValidationError) << text;
  }
}

// What widgets change leaves nothing behind that would be refused.
TEST(OtherSurface, ChangesIntoWhatCanBeRead) {
  const std::vector<std::string> texts = {
      "x",
      "x@#ff0080@outlined",
      "x@striped@stripes=3@stripe-width=0.5@stripe-color=#102030@#ffffff",
      "x@texture=plus@stripes=3@rotate=5@stripe-color=#102030@#ffffff",
      "x@discarded@stripes=3@stripe-color=#102030@#ffffff",
      "x@striped@color-by=height@#ffffff",
      "x@color-by=height@#ffffff",
      "x@discarded@texture=dots@color-by=height"};
  for (const std::string& text : texts) {
    const OtherSurfaceChoice choice = parse_other_surface("--with", text);
    for (const char* value : {"", "height", "array:a"}) {
      const OtherSurfaceChoice colored = with_color_by(choice, value);
      EXPECT_EQ(parse_other_surface("--with", text_of(colored)), colored) << text << value;
      for (const auto between : {BetweenStrokes::surface, BetweenStrokes::discarded}) {
        const OtherSurfaceChoice tiled = with_pattern(colored, false, "dots", between),
                                 striped = with_pattern(colored, true, "", between);
        EXPECT_EQ(parse_other_surface("--with", text_of(tiled)), tiled) << text << value;
        EXPECT_EQ(parse_other_surface("--with", text_of(striped)), striped) << text << value;
      }
      const OtherSurfaceChoice plain = with_pattern(colored, false, "", BetweenStrokes::surface);
      EXPECT_EQ(parse_other_surface("--with", text_of(plain)), plain) << text << value;
    }
    EXPECT_EQ(with_color_by(choice, choice.color_by), choice);
    EXPECT_EQ(with_pattern(choice, choice.striped, choice.tile, choice.between), choice);
  }
}

TEST(OtherSurface, IsWhatItIsWithoutItsLooks) {
  const auto geometry = [](const char* text) {
    return text_of(without_looks(parse_other_surface("--with", text)));
  };
  EXPECT_EQ(geometry("x@discarded@stripe-width=0.25@stripe-color=red@#fff@untinted@whole"),
            geometry("x@striped"));
  EXPECT_EQ(geometry("x@striped@color-by=height@outlined"), geometry("x@striped"));
  EXPECT_EQ(geometry("x@discarded@texture=dots@stripe-color=red"), geometry("x@texture=dots"));
  for (const char* other : {"y@striped", "x", "x@striped@stripes=3", "x@striped@rotate=3",
                            "x@striped@0,0,1", "x@texture=dots"}) {
    EXPECT_NE(geometry(other), geometry("x@striped")) << other;
  }
}

}  // namespace
}  // namespace brindle::tool
