#include "brindle/files/vtk/vtp_file.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "written_vtp.h"

namespace brindle {
namespace {

WrittenVtp written(const PolyData& data) {
  std::string text;
  OutputStream out(text);
  write_vtp(out, data);
  return {text};
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
  const std::vector<std::uint8_t> colors = {0, 128, 255, 0, 255, 0, 0, 0, 0, 255, 255, 255};
  const std::vector<DataArray> of_points = {
      make_data_array("phase", 1, std::vector<float>{1, 2, 3, 4}),
      make_data_array("color", 3, colors)};
  const std::vector<DataArray> of_cells = {
      make_data_array("normal", 3, std::vector<float>{0, 0, 1})};
  const WrittenVtp file = written({.points = kPoints,
                                   .single_points = single,
                                   .point_arrays = of_points,
                                   .cell_arrays = of_cells});
  EXPECT_EQ(file.array<float>("PointData", "phase"), (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(file.array<std::uint8_t>("PointData", "color"), colors);
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
