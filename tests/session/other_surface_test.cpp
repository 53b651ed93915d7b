#include "pictures/other_surface.h"

#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

TEST(OtherSurface, ReadsWhatItWrites) {
  for (const char* text :
       {"a b.ply", "shape:torus,resolution=8@striped", "x@discarded@stripes=12.5@rotate=-30",
        "x@striped@stripe-width=0.25@stripe-color=#102030@untinted@whole@#ff0080@1,-2.5,0.125"}) {
    const OtherSurfaceChoice choice = parse_other_surface("--with", text);
    EXPECT_EQ(text_of(choice), text);
    EXPECT_EQ(parse_other_surface("--with", text_of(choice)), choice);
  }
  const OtherSurfaceChoice named = parse_other_surface("--with", "x@steelblue@opaque");
  EXPECT_EQ(parse_other_surface("--with", text_of(named)), named);
}

TEST(OtherSurface, IsWhatItIsWithoutItsLooks) {
  const auto geometry = [](const char* text) {
    return text_of(without_looks(parse_other_surface("--with", text)));
  };
  EXPECT_EQ(geometry("x@discarded@stripe-width=0.25@stripe-color=red@#fff@untinted@whole"),
            geometry("x@striped"));
  for (const char* other :
       {"y@striped", "x", "x@striped@stripes=3", "x@striped@rotate=3", "x@striped@0,0,1"}) {
    EXPECT_NE(geometry(other), geometry("x@striped")) << other;
  }
}

}  // namespace
}  // namespace brindle::tool
