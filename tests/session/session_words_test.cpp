#include "session/session_words.h"

#include <gtest/gtest.h>

#include "gallery/gallery.h"
#include "session/session_options.h"

namespace brindle::tool {
namespace {

TEST(SessionWords, AreTheCommandLine) {
  const SessionDocument document = document_of_words(
      {"stripe", "shape:torus", "--along", "--stripes", "12", "--camera", "-15,18,2", "--with",
       "shape:box", "--color-by", "height", "--with", "shape:sphere@#fff"});
  EXPECT_EQ(document.mesh, "shape:torus");
  EXPECT_EQ(document.options, (OptionValues{{"along", {}},
                                            {"stripes", {"12"}},
                                            {"with", {"shape:box", "shape:sphere@#fff"}},
                                            {"color-by", {"height"}}}));
}

TEST(SessionWords, OfOtherCommandsShowWhatTheyDraw) {
  const SessionDocument curves =
      document_of_words({"curves", "shape:torus", "--stripes", "12", "--join", "--lines", "both"});
  EXPECT_EQ(curves.shown, Shown::curves);
  EXPECT_EQ(curves.options, (OptionValues{{"stripes", {"12"}}}));
  EXPECT_EQ(curves.curves, (OptionValues{{"join", {}}, {"lines", {"both"}}}));
  const SessionDocument samples =
      document_of_words({"sample", "shape:torus", "--glyph", "arrow", "--color-by", "height"});
  EXPECT_EQ(samples.shown, Shown::samples);
  EXPECT_EQ(samples.samples, (OptionValues{{"glyph", {"arrow"}}, {"color-by", {"height"}}}));
}

TEST(SessionWords, RefuseWhatSessionsDoNotHave) {
  using Words = std::vector<std::string>;
  for (const Words& words : {Words{}, Words{"animate", "shape:torus"}, Words{"stripe"},
                             Words{"stripe", "shape:torus", "--nothing", "1"},
                             Words{"stripe", "shape:torus", "--stripes"},
                             Words{"stripe", "shape:torus", "--camera", "up"},
                             Words{"stripe", "shape:torus", "--output", "a.png"}}) {
    EXPECT_ANY_THROW(document_of_words(words));
  }
}

TEST(SessionWords, ReadEveryGalleryPictureThatASessionCanHave) {
  std::size_t items = 0;
  for (const GalleryItem& item : gallery_items()) {
    bool any = false;
    for (const GalleryPicture& picture : item.pictures) {
      if (!is_still_picture(picture)) continue;
      any = true;
      SessionDocument document;
      ASSERT_NO_THROW(document = document_of_words(filled_words(picture, {"data", "", "", ""})))
          << item.name << ' ' << picture.name;
      EXPECT_TRUE(document.mesh.starts_with("data/"));
      for (const std::string& name : picture.live) {
        EXPECT_NE(find_session_option(name, document.shown), nullptr) << item.name << ": " << name;
      }
    }
    items += any ? 1 : 0;
  }
  EXPECT_EQ(items, gallery_items().size());
}

}  // namespace
}  // namespace brindle::tool
