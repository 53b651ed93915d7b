#include "brindle/files/vtp_file.h"

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace brindle {
namespace {

struct WrittenVtp {
  std::string text;

  /// The numbers of an array, found as a reader finds them: by its offset.
  template <class Number>
  std::vector<Number> array(const std::string& element, const std::string& name) const {
    const std::size_t section = text.find("<" + element);
    const std::size_t tag = text.find("Name=\"" + name + "\"", section);
    const std::size_t offset = text.find("offset=\"", tag) + 8;
    const std::size_t begin = text.find("<AppendedData encoding=\"raw\">\n_") + 31;
    const char* block = text.data() + begin + std::stoul(text.substr(offset, 20));
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, block, sizeof bytes);
    std::vector<Number> numbers(bytes / sizeof(Number));
    if (bytes > 0) std::memcpy(numbers.data(), block + sizeof bytes, bytes);
    return numbers;
  }
};

WrittenVtp written(const PolyData& data) {
  std::ostringstream out;
  write_vtp(out, data);
  return {out.str()};
}

const std::vector<Vec3> kPoints = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(VtpFile, HoldsPointsLinesAndTriangles) {
  const std::vector<Index> single = {3}, offsets = {0, 2, 5}, along = {0, 1, 2, 3, 0};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const WrittenVtp file = written({kPoints, single, offsets, along, triangles});
  EXPECT_NE(file.text.find("NumberOfPoints=\"4\" NumberOfVerts=\"1\" NumberOfLines=\"2\" "
                           "NumberOfStrips=\"0\" NumberOfPolys=\"2\""),
            std::string::npos);
  using Numbers = std::vector<std::int64_t>;
  EXPECT_EQ(file.array<float>("Points", "Points"),
            (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(file.array<std::int64_t>("Verts", "connectivity"), (Numbers{3}));
  EXPECT_EQ(file.array<std::int64_t>("Verts", "offsets"), (Numbers{1}));
  EXPECT_EQ(file.array<std::int64_t>("Lines", "connectivity"), (Numbers{0, 1, 2, 3, 0}));
  EXPECT_EQ(file.array<std::int64_t>("Lines", "offsets"), (Numbers{2, 5}));
  EXPECT_EQ(file.array<std::int64_t>("Polys", "connectivity"), (Numbers{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(file.array<std::int64_t>("Polys", "offsets"), (Numbers{3, 6}));
}

TEST(VtpFile, HoldsPointsWithAnOriginAsDoubles) {
  const Eigen::Vector3d origin(500000.125, 5800000.125, 1);
  const std::vector<Vec3> points = {{0.5f, 0, 0}, {0, 0.25f, -1}};
  const WrittenVtp file = written({.points = points, .origin = origin});
  EXPECT_EQ(file.array<double>("Points", "Points"),
            (std::vector<double>{500000.625, 5800000.125, 1, 500000.125, 5800000.375, 0}));
}

TEST(VtpFile, HoldsAttributesOfPointsAndCells) {
  const std::vector<Index> single = {0};
  const std::vector<VertexAttribute> of_points = {
      {"phase", 1, {1, 2, 3, 4}}, {"color", 3, {0, 0.5f, 1, -1, 2, 0, 0, 0, 0, 1, 1, 1}}};
  const std::vector<VertexAttribute> of_cells = {{"normal", 3, {0, 0, 1}}};
  const WrittenVtp file = written({.points = kPoints,
                                   .single_points = single,
                                   .point_attributes = of_points,
                                   .cell_attributes = of_cells});
  EXPECT_EQ(file.array<float>("PointData", "phase"), (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(file.array<std::uint8_t>("PointData", "color"),
            (std::vector<std::uint8_t>{0, 128, 255, 0, 255, 0, 0, 0, 0, 255, 255, 255}));
  EXPECT_EQ(file.array<float>("CellData", "normal"), (std::vector<float>{0, 0, 1}));
  EXPECT_NE(file.text.find("<CellData Normals=\"normal\">"), std::string::npos);
}

TEST(VtpFile, NothingIsAFileToo) {
  const WrittenVtp file = written({});
  EXPECT_TRUE(file.array<float>("Points", "Points").empty());
  EXPECT_TRUE(file.array<std::int64_t>("Lines", "offsets").empty());
  EXPECT_TRUE(file.text.ends_with("</VTKFile>\n"));
}

}  // namespace
}  // namespace brindle
