#include "session/named_places.h"

#include <gtest/gtest.h>

namespace brindle::tool {
namespace {

const OptionValues kOptions = {{"frequency-by", {"distance:-40,-26,19"}},
                               {"width-by", {"distance:-40,-26,19.0"}},
                               {"color-by", {"distance:camera"}},
                               {"opacity-by", {"distance:1,2,3"}},
                               {"legend", {"distance:5,6,7 of nothing"}},
                               {"direction", {"0,0,1"}},
                               {"with", {"a,b.vtp@#ffffff@-40,-26,19", "b.vtp@striped", "c.vtp"}}};

TEST(NamedPlaces, AreFoundOnceEachWithTheirOptions) {
  const std::vector<NamedPlace> places = named_places(kOptions);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].at, Eigen::Vector3d(-40, -26, 19));
  EXPECT_EQ(places[0].options, (std::vector<std::string>{"frequency-by", "width-by", "with"}));
  EXPECT_EQ(places[1].at, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(places[1].options, std::vector<std::string>{"opacity-by"});
  EXPECT_TRUE(named_places({}).empty());
}

TEST(NamedPlaces, AreInValuesOfOtherSurfaces) {
  const OptionValues options = {
      {"with", {"a.vtp@striped@color-by=distance:1,2,3@4,5,6", "b.vtp@color-by=array:1,2,3"}}};
  const std::vector<NamedPlace> places = named_places(options);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].at, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(with_place_at({7, 8, 9}, places[0], options).at("with"),
            (std::vector<std::string>{"a.vtp@striped@color-by=distance:7,8,9@4,5,6",
                                      "b.vtp@color-by=array:1,2,3"}));
}

TEST(NamedPlaces, MoveInAllOptionsThatNameThemAndInNoOther) {
  const NamedPlace place = named_places(kOptions)[0];
  const OptionValues moved = with_place_at({1.5, -2, 0.25}, place, kOptions);
  EXPECT_EQ(moved,
            (OptionValues{{"frequency-by", {"distance:1.5,-2,0.25"}},
                          {"width-by", {"distance:1.5,-2,0.25"}},
                          {"with", {"a,b.vtp@#ffffff@1.5,-2,0.25", "b.vtp@striped", "c.vtp"}}}));
  OptionValues after = kOptions;
  for (const auto& [name, values] : moved) after[name] = values;
  EXPECT_EQ(named_places(after)[0].at, Eigen::Vector3d(1.5, -2, 0.25));
  EXPECT_EQ(named_places(after)[0].options, place.options);
}

}  // namespace
}  // namespace brindle::tool
