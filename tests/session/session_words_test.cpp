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

TEST(SessionWords, HavePartsOfValuesApart) {
  const SessionDocument document = document_of_words(
      {"stripe", "shape:torus", "--solver", "relaxation,epsilon=0.1,seed=3", "--color-by",
       "height@0..0.5", "--stripe-width", "3px", "--legend", "none"});
  EXPECT_EQ(document.options, (OptionValues{{"solver", {"relaxation"}},
                                            {"epsilon", {"0.1"}},
                                            {"seed", {"3"}},
                                            {"color-by", {"height"}},
                                            {"color-range", {"0..0.5"}},
                                            {"pixel-width", {"3"}},
                                            {"no-legend", {}}}));
}

/// Command lines cannot say these: there, they are parts of the option that is missing.
TEST(SessionDocument, PartsWithoutTheirOptionAreRefusedWithTheReason) {
  const std::vector<std::pair<OptionValues, std::string>> refused = {
      {{{"color-range", {"0..1"}}}, "colours follow no value; add --color-by VALUE"},
      {{{"opacity-range", {"0..1"}}}, "opacity follows no value; add --opacity-by VALUE"},
      {{{"width-range", {"0.1..0.2"}}}, "widths follow no value; add --width-by VALUE"},
      {{{"tile-size-range", {"0.1..0.5"}}, {"texture", {"dots"}}}, "add --tile-size-by VALUE"},
      {{{"frequency-range", {"1..2"}}}, "nothing varies the frequency; add --frequency-by VALUE"},
      {{{"cross-hatch", {"0.5"}}}, "strokes do not follow the light; add --width-by light"},
      {{{"regions", {"0,plus"}}, {"texture", {"dots"}}}, "add --texture-by VALUE"},
      {{{"tiles", {"whole"}}}, "add --texture"},
      {{{"texture-shift", {"0.5"}}}, "add --texture"},
      {{{"hidden-lines", {"dashed"}}}, "no lines are drawn"},
      {{{"line-width", {"2"}}}, "no lines are drawn"},
      {{{"feature-angle", {"30"}}}, "nothing draws the field to sharp edges; add --feature-anchor"},
      {{{"feature-radius", {"5%"}}}, "nothing draws the field to sharp edges"},
      {{{"max-distance", {"1%"}}, {"field", {"array:a"}}}, "add --field-mesh FILE"},
      {{{"cancel-distance", {"20"}}}, "no branch pairs are cancelled; add --cancel-branches"},
      {{{"fill", {"1"}}}, "nothing is filled"},
      {{{"lambda", {"0.1"}}}, "no pattern is followed; add --previous"},
      {{{"match", {"number"}}}, "no pattern is followed; add --previous"},
      {{{"rounded", {}}}, "--subdivide"}};
  for (const auto& [options, why] : refused) {
    SessionDocument document;
    document.mesh = "plate.vtp";
    document.options = options;
    const std::string option = options.begin()->first;
    try {
      check_document(document);
      ADD_FAILURE() << option;
    } catch (const std::exception& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos)
          << option << ": " << error.what();
    }
  }
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
