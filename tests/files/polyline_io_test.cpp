#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"
#include "written_vtp.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct PolylineIo : TestFolder {
  Polylines u, v;

  void SetUp() override {
    u.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    u.normals.assign(3, Vec3(0, 0, 1));
    u.offsets = {0, 3};
    u.closed = {1};
    v.points = {{0, 0, 1}, {1, 0, 1}};
    v.normals.assign(2, Vec3(0, 0, 1));
    v.offsets = {0, 2};
    v.closed = {0};
  }

  std::string written(const std::string& name) const {
    const std::vector<NamedLines> kinds = {{"u", u}, {"v", v}};
    write_polylines(folder / name, kinds);
    std::ifstream in(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(PolylineIo, ObjHasLinesInGroups) {
  EXPECT_EQ(written("a.obj"),
            "# written by brindle\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\n"
            "g u\nl 1 2 3 1\ng v\nl 4 5\n");
}

TEST_F(PolylineIo, CsvHasARowPerPoint) {
  EXPECT_EQ(written("a.CSV"),
            "kind,curve,closed,x,y,z,nx,ny,nz\nu,0,1,0,0,0,0,0,1\nu,0,1,1,0,0,0,0,1\n"
            "u,0,1,1,1,0,0,0,1\nv,1,0,0,0,1,0,0,1\nv,1,0,1,0,1,0,0,1\n");
}

TEST_F(PolylineIo, PlyHasEdges) {
  const std::string file = written("a.ply");
  EXPECT_NE(file.find("element vertex 5\n"), std::string::npos);
  EXPECT_NE(file.find("element edge 4\nproperty int vertex1\nproperty int vertex2\n"),
            std::string::npos);
  const std::size_t body = file.find("end_header\n") + 11;
  ASSERT_EQ(file.size() - body, 5 * (6 * 4 + 4 + 1) + 4 * 8u);
  const auto* edges = reinterpret_cast<const unsigned char*>(file.data() + body + 5 * 29);
  const std::vector<int> expected = {0, 1, 1, 2, 2, 0, 3, 4};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(edges[4 * i], expected[i]);
}

TEST_F(PolylineIo, VtpHasLinesWithTheirKind) {
  const std::string file = written("a.vtp");
  EXPECT_NE(file.find("NumberOfPoints=\"5\" NumberOfVerts=\"0\" NumberOfLines=\"2\""),
            std::string::npos);
  for (const char* name : {"normal", "kind", "closed", "length"}) {
    EXPECT_NE(file.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  }
}

struct PolylineArrays : PolylineIo {
  std::vector<DataArray> of_u = {
      make_data_array("id", 1, std::vector<std::int64_t>{7, 8, 9}),
      make_data_array("my, \"v\"", 3, std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9}),
      make_data_array("kind", 2, std::vector<double>(6))};
  std::vector<DataArray> of_v = {
      make_data_array("id", 1, std::vector<std::int64_t>{10, 11}),
      make_data_array("my, \"v\"", 3, std::vector<float>{0.5f, 0, 0, 0, 0, 1}),
      make_data_array("kind", 2, std::vector<double>{0, 0, 0, 0.25})};

  std::string with_arrays(const std::string& name) const {
    write_polylines(folder / name, std::vector<NamedLines>{{"u", u, of_u}, {"v", v, of_v}});
    std::ifstream in(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(PolylineArrays, AreColumnsInCsv) {
  const std::string file = with_arrays("a.csv");
  EXPECT_EQ(file.substr(0, file.find('\n')),
            "kind,curve,closed,x,y,z,nx,ny,nz,id,\"my, \"\"v\"\"_x\",\"my, \"\"v\"\"_y\","
            "\"my, \"\"v\"\"_z\",kind_0,kind_1");
  EXPECT_NE(file.find("u,0,1,1,0,0,0,0,1,8,4,5,6,0,0\n"), std::string::npos) << file;
  EXPECT_NE(file.find("v,1,0,1,0,1,0,0,1,11,0,0,1,0,0.25\n"), std::string::npos) << file;
}

TEST_F(PolylineArrays, AreKeptOfAllKindsInVtp) {
  const WrittenVtp file{with_arrays("a.vtp")};
  EXPECT_EQ(file.array<std::int64_t>("PointData", "id"),
            (std::vector<std::int64_t>{7, 8, 9, 10, 11}));
  EXPECT_EQ(file.array<double>("PointData", "kind_").back(), 0.25);
  EXPECT_EQ(file.array<float>("PointData", "my, &quot;v&quot;").size(), 15u);
  EXPECT_EQ(file.array<float>("CellData", "kind"), (std::vector<float>{0, 1}));
}

TEST_F(PolylineArrays, ArePropertiesInPly) {
  const std::string file = with_arrays("a.ply");
  EXPECT_NE(file.find("property uchar kind\nproperty int id\nproperty float my___v__x\n"),
            std::string::npos)
      << file.substr(0, 600);
  EXPECT_EQ(file.size() - file.find("end_header\n") - 11, 5 * (29 + 4 + 12 + 16) + 4 * 8u);
}

TEST_F(PolylineArrays, MustBeTheSameOfAllKinds) {
  of_v.pop_back();
  EXPECT_THROW(with_arrays("a.vtp"), Error);
  of_v = of_u;  // of three points
  EXPECT_THROW(with_arrays("b.vtp"), Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(PolylineIo, LinesFarFromZeroAreWrittenWhereTheyAre) {
  u.origin = v.origin = Eigen::Vector3d(500000.125, 5800000.25, 7);
  EXPECT_NE(written("a.obj").find("v 500001.125 5800001.25 7\n"), std::string::npos);
  EXPECT_NE(written("a.csv").find("v,1,0,500001.125,5800000.25,8,0,0,1\n"), std::string::npos);
  const std::string ply = written("a.ply");
  EXPECT_NE(ply.find("property double x\nproperty double y\nproperty double z\nproperty float nx"),
            std::string::npos);
  EXPECT_EQ(ply.size() - ply.find("end_header\n") - 11, 5 * (3 * 8 + 3 * 4 + 4 + 1) + 4 * 8u);
  std::array<double, 3> first{};
  std::memcpy(first.data(), ply.data() + ply.find("end_header\n") + 11, sizeof first);
  EXPECT_EQ(first, (std::array<double, 3>{500000.125, 5800000.25, 7}));
  EXPECT_NE(written("a.vtp").find("Float64"), std::string::npos);
  // Changed lines stay there.
  EXPECT_EQ(simplified(u, 0.1f).origin, u.origin);
  EXPECT_EQ(resampled(u, 0.5f).origin, u.origin);
}

TEST_F(PolylineIo, OtherFormatsAreRefusedWithAnother) {
  try {
    written("a.stl");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(".vtp"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_FALSE(is_polyline_format("a.stl"));
  EXPECT_TRUE(is_polyline_format("a.OBJ"));
}

}  // namespace
}  // namespace brindle
