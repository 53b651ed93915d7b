#include "window/dialogs/shape_dialog.h"

#include <gtest/gtest.h>

#include "brindle/shapes.h"

namespace brindle::tool {
namespace {

TEST(ShapeDialogTest, ListsAllShapesWithTheirParameters) {
  const std::vector<ShapeInfo> shapes = shape_catalogue();
  const std::vector<std::string> names = shape_names();
  ASSERT_EQ(shapes.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(shapes[i].name, names[i]);
    EXPECT_GE(shapes[i].parameters.size(), 3) << names[i];
    for (const ShapeParameter& parameter : shapes[i].parameters) {
      EXPECT_LE(parameter.lower, parameter.standard) << names[i] << " " << parameter.name;
      EXPECT_GE(parameter.upper, parameter.standard) << names[i] << " " << parameter.name;
      EXPECT_FALSE(parameter.help.empty());
    }
  }
}

TEST(ShapeDialogTest, NamesOnlyWhatIsNotAsUsual) {
  const auto shapes = shape_catalogue();
  const auto torus = std::ranges::find(shapes, "torus", &ShapeInfo::name);
  ASSERT_NE(torus, shapes.end());
  EXPECT_EQ(shape_text(*torus, {}), "shape:torus");
  EXPECT_EQ(shape_text(*torus, {{"major", "0.7"}, {"minor", "0.2"}}), "shape:torus,minor=0.2");
  const auto values = shape_values("shape:torus,minor=0.2,resolution=64");
  EXPECT_EQ(shape_values(shape_text(*torus, values)), values);
}

}  // namespace
}  // namespace brindle::tool
