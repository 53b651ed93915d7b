#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

struct PointIo : TestFolder {
  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  void expect_error(const fs::path& path, const std::string& part) const {
    try {
      read_points(path);
      FAIL() << path;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(part), std::string::npos) << message;
      EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
    }
  }
};

const std::string kPlyStart = "ply\nformat ascii 1.0\n";

TEST_F(PointIo, ReadsCsvWithAndWithoutNormals) {
  const PointCloud bare = read_points(file("a.csv", "x,y,z\n1,2,3\n# note\n4,5,6\n")).cloud;
  EXPECT_EQ(bare.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_TRUE(bare.normals.empty());
  const PointCloud full = read_points(file("b.csv", "1,2,3,0,0,2\n4,5,6,0,-1,0\n")).cloud;
  EXPECT_EQ(full.normals, (std::vector<Vec3>{{0, 0, 1}, {0, -1, 0}}));
}

TEST_F(PointIo, ReadsColumnsByTheirNamesAndTheOthersAsArrays) {
  const LoadedPoints loaded =
      read_points(file("a.csv",
                       "\"speed\",\"Points:1\",\"v:0\",\"v:1\",\"v:2\",\"Points:0\",\"Points:2\"\n"
                       "7,2,10,11,12,1,3\n8,5,13,14,15,4,6\n"));
  EXPECT_EQ(loaded.cloud.positions, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(loaded.arrays,
            (std::vector<DataArray>{
                make_data_array("speed", 1, std::vector<double>{7, 8}),
                make_data_array("v", 3, std::vector<double>{10, 11, 12, 13, 14, 15})}));
  const LoadedPoints named = read_points(file("b.csv", "nz,ny,nx,z,y,x\n2,0,0,3,2,1\n"));
  EXPECT_EQ(named.cloud.positions, (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(named.cloud.normals, (std::vector<Vec3>{{0, 0, 1}}));
}

TEST_F(PointIo, TakesNoOtherColumnsForNormals) {
  const std::string rows = "\n0,0,1,1,0,0\n0,1,0,0,0,1\n";
  for (const std::string names : {"x,y,z,u,v,w", "x,y,z,vel:0,vel:1,vel:2", "x,y,z,a_x,a_y,a_z"}) {
    const LoadedPoints loaded = read_points(file("a.csv", names + rows));
    EXPECT_TRUE(loaded.cloud.normals.empty()) << names;
    EXPECT_FALSE(loaded.arrays.empty()) << names;
  }
  EXPECT_EQ(read_points(file("b.csv", "x,y,z,nx,ny,nz" + rows)).cloud.normals,
            (std::vector<Vec3>{{1, 0, 0}, {0, 0, 1}}));
}

TEST_F(PointIo, ReadsPlyWithNormalsAmongOtherProperties) {
  const auto path = file("a.ply", kPlyStart +
                                      "element vertex 2\nproperty float nx\nproperty float x\n"
                                      "property uchar red\nproperty float y\nproperty float z\n"
                                      "property float ny\nproperty float nz\nend_header\n"
                                      "1 10 7 20 30 0 0\n0 11 8 21 31 0 -1\n");
  EXPECT_TRUE(is_point_file(path));
  const PointCloud cloud = read_points(path).cloud;
  EXPECT_EQ(cloud.positions, (std::vector<Vec3>{{10, 20, 30}, {11, 21, 31}}));
  EXPECT_EQ(cloud.normals, (std::vector<Vec3>{{1, 0, 0}, {0, 0, -1}}));
}

TEST_F(PointIo, ReadsNormalsByTheNamesOfOtherPrograms) {
  for (const std::string stem : {"n", "normal", "normal_"}) {
    std::string header = kPlyStart + "element vertex 1\n";
    for (const std::string& name : {std::string("x"), std::string("y"), std::string("z"),
                                    stem + "x", stem + "y", stem + "z"}) {
      header += "property float " + name + "\n";
    }
    const LoadedPoints ply = read_points(file("a.ply", header + "end_header\n1 2 3 0 1 0\n"));
    EXPECT_EQ(ply.cloud.normals, (std::vector<Vec3>{{0, 1, 0}})) << stem;
    const LoadedPoints csv = read_points(
        file("a.csv", "a,x,y,z," + stem + "x," + stem + "y," + stem + "z\n7,1,2,3,0,1,0\n"));
    EXPECT_EQ(csv.cloud.normals, (std::vector<Vec3>{{0, 1, 0}})) << stem;
  }
}

TEST_F(PointIo, ReadsObjWithAsManyNormalsAsPoints) {
  const std::string points = "v 0 0 0\nv 1 0 0\nvn 0 0 1\n";
  EXPECT_TRUE(read_points(file("a.obj", points)).cloud.normals.empty());
  const PointCloud cloud = read_points(file("b.obj", points + "vn 0 3 0\n")).cloud;
  EXPECT_EQ(cloud.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}}));
}

TEST_F(PointIo, TakesNoNormalsOfObjThatFacesGiveToOtherPoints) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\n";
  for (const std::string face :
       {"f 1//1 2//2 3//3\n", "f 1/7/1 2/8/2 3/9/3 # own\n", "f 1 2 3\n"}) {
    EXPECT_EQ(read_points(file("a.obj", points + face)).cloud.normals.size(), 3u) << face;
  }
  for (const std::string face : {"f 1//3 2//2 3//1\n", "f 1/1/1 2/2/1 3/3/3\n"}) {
    EXPECT_TRUE(read_points(file("b.obj", points + face)).cloud.normals.empty()) << face;
  }
}

TEST_F(PointIo, SetsAsideWhatIsNoNumberInAnyFormat) {
  const LoadedPoints loaded = read_points(file("a.off", "OFF\n3 0 0\n0 0 0\nnan 0 0\n0 2 0\n"));
  EXPECT_EQ(loaded.repair.not_finite, 1u);
  EXPECT_EQ(loaded.cloud.used, (std::vector<Index>{0, 2}));
}

TEST_F(PointIo, KnowsTheFirstOfAllPointsAtOnePlace) {
  const LoadedPoints loaded = read_points(file("a.csv", "0,0,0\n1,0,0\n0,0,0\nnan,0,0\n1,0,0\n"));
  EXPECT_EQ(loaded.first_at_place, (std::vector<Index>{0, 1, 0, 3, 1}));
  EXPECT_TRUE(read_points(file("b.csv", "0,0,0\n1,0,0\n")).first_at_place.empty());
}

TEST_F(PointIo, PointsFarFromZeroKeepTheirDistances) {
  for (const auto& [name, text] :
       {std::pair{"a.csv", "500000.125,5800000.25,1\n500000.25,5800000.25,1\n"},
        {"a.obj", "v 500000.125 5800000.25 1\nv 500000.25 5800000.25 1\n"}}) {
    const PointCloud cloud = read_points(file(name, text)).cloud;
    EXPECT_EQ(cloud.origin, Eigen::Vector3d(500000.1875, 5800000.25, 1)) << name;
    EXPECT_EQ(cloud.positions, (std::vector<Vec3>{{-0.0625f, 0, 0}, {0.0625f, 0, 0}})) << name;
  }
}

TEST_F(PointIo, ReadsWhatWriteMeshWrote) {
  const Mesh mesh{{{0, 1, 2}, {3, 4, 5}, {6, 7, 9}}, {}};
  const fs::path path = folder / "points.ply";
  write_mesh(
      path, mesh,
      std::vector{make_data_array("normal", 3, std::vector<float>{0, 0, 1, 0, 1, 0, 1, 0, 0}),
                  make_data_array("phase", 1, std::vector<float>{1, 2, 3})});
  EXPECT_TRUE(is_point_file(path));
  const PointCloud cloud = read_points(path).cloud;
  EXPECT_EQ(cloud.positions, mesh.positions);
  EXPECT_EQ(cloud.normals, (std::vector<Vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}));
}

TEST_F(PointIo, TellsPointsFromMeshes) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_TRUE(is_point_file(file("a.obj", triangle)));
  EXPECT_FALSE(is_point_file(file("b.obj", triangle + "f 1 2 3\n")));
  EXPECT_EQ(read_points(folder / "b.obj").cloud.positions.size(), 3u);
  EXPECT_TRUE(is_point_file("any.csv"));
  EXPECT_FALSE(is_point_file(folder / "none.ply"));
  EXPECT_FALSE(is_point_file(file("bad.ply", "nonsense")));
  EXPECT_FALSE(is_point_file(file("a.xyz", triangle)));
}

TEST_F(PointIo, SaysWhatIsWrongAndWhere) {
  expect_error(file("a.csv", "1,2,3\n1,2\n"), "line 2");
  expect_error(file("b.csv", "1,2,3\n1,2,3,0,0,1\n"), "line 2");
  expect_error(file("c.csv", "1,2,3\n1,two,3\n"), "line 2");
  expect_error(file("d.csv", ""), "no point");
  expect_error(file("e.csv", "nan,1,2\n"), "no point");
  expect_error(folder / "none.csv", "no such file");
  expect_error(file("f.ply", kPlyStart + "element vertex 5\nproperty float x\nproperty float y\n"
                                         "property float z\nend_header\n1 2 3\n"),
               "truncated");
  expect_error(file("g.obj", "v 1 2\n"), "three numbers");
}

}  // namespace
}  // namespace brindle
