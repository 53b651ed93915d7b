#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/files.h"
#include "session/picking.h"
#include "test_folder.h"

namespace brindle::tool {
namespace {

/// Stripes along x on two triangles, with arrays.
struct PickedValues : TestFolder {
  LivePattern pattern;

  void SetUp() override {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<DataArray> points = {
        make_data_array("speed", 1, std::vector<float>{0, 8, 8, 0}),
        make_data_array("at", 3, std::vector<float>{0, 0, 0, 4, 0, 0, 4, 1, 0, 0, 1, 0})};
    const std::vector<DataArray> cells = {make_data_array("part", 1, std::vector<int>{7, 9})};
    write_mesh(folder / "plate.vtp", mesh, points, cells);
    SessionDocument document;
    document.mesh = (folder / "plate.vtp").string();
    document.options["direction"] = {"1,0,0"};
    document.options["frequency"] = {"0.25"};
    pattern.update(document, Follow::afresh);
  }

  std::string value(const Vec3& barycentric, std::size_t triangle, const std::string& name) const {
    const LiveState& state = *pattern.state();
    PickedPoint point{};
    point.place.setZero();
    point.triangle = triangle;
    point.barycentric = barycentric;
    const Mesh& mesh = state.job->surface->mesh;
    for (int m = 0; m < 3; ++m) {
      point.place += static_cast<double>(barycentric[m]) *
                     mesh.positions[mesh.triangles[triangle][m]].cast<double>();
    }
    const auto values = values_at(state, point);
    const auto found = std::ranges::find(values, name, &PickedValue::name);
    return found == values.end() ? "not there" : found->text;
  }
};

TEST_F(PickedValues, AreThoseOfThePlace) {
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 0, "place"), "2, 0.25, 0");
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 0, "speed"), "4");
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 0, "at"), "2, 0.25, 0");
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 0, "part"), "7");
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 1, "part"), "9");
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 0, "frequency"), "0.25");
  EXPECT_EQ(value({0.5f, 0.25f, 0.25f}, 0, "of nothing"), "not there");
}

TEST_F(PickedValues, SineIsOneInTheMiddleOfAStripe) {
  // A period is as long as the plate: half of one from it to the middle of the gap.
  const auto sine = [&](float x) {
    return std::stod(value({1 - x / 4, x / 4, 0}, 0, "sine of the phase"));
  };
  double highest = -1, lowest = 1;
  for (float x = 0; x <= 4; x += 0.125f) {
    highest = std::max(highest, sine(x));
    lowest = std::min(lowest, sine(x));
    EXPECT_NEAR(sine(x), -sine(std::fmod(x + 2, 4.0f)), 0.02) << x;
  }
  EXPECT_GT(highest, 0.98);
  EXPECT_LT(lowest, -0.98);
}

}  // namespace
}  // namespace brindle::tool
