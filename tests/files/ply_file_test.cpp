#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/mesh_formats.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Strip = std::vector<int>;

struct PlyFile : TestFolder {
  fs::path path = folder / "mesh.ply";

  const fs::path& save(const std::string& content) const {
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
};

/// Writes numbers as text, or as bytes of either order.
struct Writer {
  std::string format;
  std::string content;

  template <class Number>
  void put(Number number) {
    if (format == "ascii") {
      content += std::to_string(number) + ' ';
      return;
    }
    std::array<char, sizeof number> bytes{};
    std::memcpy(bytes.data(), &number, sizeof number);
    if (format == "binary_big_endian") std::reverse(bytes.begin(), bytes.end());
    content.append(bytes.data(), bytes.size());
  }
  void end_row() {
    if (format == "ascii") content += '\n';
  }
};

const std::vector<std::string> kFormats = {"ascii", "binary_little_endian", "binary_big_endian"};

/// Vertices in a zigzag, (0, 0), (0, 1), (1, 0), (1, 1), ...
std::string zigzag(const std::string& format, int vertices, const std::vector<Strip>& lists) {
  Writer file{format, "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
                          "\nproperty float x\nproperty float y\nproperty float z\n"
                          "element tristrips " +
                          std::to_string(lists.size()) +
                          "\nproperty list int int vertex_indices\nend_header\n"};
  for (int v = 0; v < vertices; ++v) {
    for (const int coordinate : {v / 2, v % 2, 0}) file.put(static_cast<float>(coordinate));
    file.end_row();
  }
  for (const Strip& list : lists) {
    file.put(static_cast<std::int32_t>(list.size()));
    for (const int entry : list) file.put(static_cast<std::int32_t>(entry));
    file.end_row();
  }
  return file.content;
}

TEST_F(PlyFile, ReadsTriangleStripsOfEveryEncoding) {
  for (const std::string& format : kFormats) {
    save(zigzag(format, 7, {{0, 1, 2, 3, 4, -1, 4, 5, 6, -1}}));
    EXPECT_FALSE(is_point_file(path)) << format;
    const LoadedMesh loaded = read_mesh(path);
    EXPECT_EQ(loaded.mesh.triangles,
              (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 5, 6}}))
        << format;
    EXPECT_EQ(loaded.repair, MeshRepair{}) << format;
  }
}

TEST_F(PlyFile, ReadsSeveralListsAndPassesOverCornersThatRepeat) {
  // The repeated 2 turns the strip around: the triangle behind it is wound as it would be without
  // the two empty ones.
  save(zigzag("ascii", 6, {{0, 1, 2, 2, 3, 4}, {-1, -1, 3, 4}, {}, {3, 5, 4}}));
  EXPECT_EQ(read_mesh(path).mesh.triangles,
            (std::vector<Triangle>{{0, 1, 2}, {3, 2, 4}, {3, 5, 4}}));
}

TEST_F(PlyFile, StripsWithCornersThatDoNotExistAreAnError) {
  for (const Strip& strip : {Strip{0, 1, 9}, Strip{0, 1, -2}, Strip{0, 1, 2, 7, -1}}) {
    for (const std::string& format : kFormats) {
      EXPECT_THROW(read_mesh(save(zigzag(format, 5, {strip}))), Error);
    }
  }
}

TEST_F(PlyFile, ReadsDoublesFarFromZero) {
  std::string header =
      "1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const std::string& format : kFormats) {
    Writer file{format, "ply\nformat " + format + ' ' + header};
    for (const std::array<double, 2> p :
         {std::array{500000.25, 5800000.25}, {500000.5, 5800000.25}, {500000.25, 5800000.5}}) {
      for (const double coordinate : {p[0], p[1], 3.0}) file.put(coordinate);
      file.end_row();
    }
    if (format == "ascii") {
      file.content += "3 0 1 2\n";
    } else {
      file.content += '\3';
      for (const std::int32_t corner : {0, 1, 2}) file.put(corner);
    }
    const Mesh mesh = read_mesh(save(file.content)).mesh;
    EXPECT_EQ(mesh.origin, Eigen::Vector3d(500000.375, 5800000.375, 3)) << format;
    EXPECT_EQ(
        mesh.positions,
        (std::vector<Vec3>{{-0.125f, -0.125f, 0}, {0.125f, -0.125f, 0}, {-0.125f, 0.125f, 0}}))
        << format;
  }
}

TEST_F(PlyFile, PropertiesBecomeArraysOfTheirTypes) {
  for (const std::string& format : kFormats) {
    Writer file{format, "ply\nformat " + format +
                            " 1.0\nelement vertex 4\nproperty int id\nproperty float x\n"
                            "property uchar green\nproperty float y\nproperty float z\n"
                            "property uchar red\nproperty uchar blue\nproperty double v_z\n"
                            "property double v_x\nproperty list uchar int tags\n"
                            "property double v_y\nproperty float nx\nproperty float ny\n"
                            "element face 2\nproperty ushort part\n"
                            "property list uchar int vertex_indices\nproperty short q_1\n"
                            "property short q_0\nend_header\n"};
    for (int v = 0; v < 4; ++v) {
      const auto number = static_cast<double>(v);
      file.put(std::int32_t{-2000000000 + v});
      file.put(static_cast<float>(v / 2));
      file.put(static_cast<std::uint8_t>(v));
      file.put(static_cast<float>(v % 2));
      file.put(0.0f);
      file.put(static_cast<std::uint8_t>(255));
      file.put(static_cast<std::uint8_t>(7));
      file.put(number + 0.25);
      file.put(number);
      file.put(static_cast<std::uint8_t>(2));
      file.put(std::int32_t{1});
      file.put(std::int32_t{2});
      file.put(number + 0.125);
      file.put(1.0f);
      file.put(0.5f);
      file.end_row();
    }
    // A quadrangle, and a triangle without area, which is dropped.
    for (const std::vector<std::int32_t>& face : {std::vector{1, 1, 0}, std::vector{0, 2, 3, 1}}) {
      file.put(static_cast<std::uint16_t>(60000 + face.size()));
      file.put(static_cast<std::uint8_t>(face.size()));
      for (const std::int32_t corner : face) file.put(corner);
      file.put(std::int16_t{-30000});
      file.put(std::int16_t{5});
      file.end_row();
    }
    const LoadedMesh loaded = read_mesh(save(file.content));
    const std::vector<std::int32_t> ids = {-2000000000, -1999999999, -1999999998, -1999999997};
    EXPECT_EQ(
        loaded.arrays.points,
        (std::vector<DataArray>{
            make_data_array("id", 1, ids),
            make_data_array("color", 3,
                            std::vector<std::uint8_t>{255, 0, 7, 255, 1, 7, 255, 2, 7, 255, 3, 7}),
            make_data_array("v", 3,
                            std::vector<double>{0, 0.125, 0.25, 1, 1.125, 1.25, 2, 2.125, 2.25, 3,
                                                3.125, 3.25}),
            make_data_array("nx", 1, std::vector<float>(4, 1)),
            make_data_array("ny", 1, std::vector<float>(4, 0.5f))}))
        << format;
    EXPECT_EQ(loaded.arrays.cells,
              (std::vector<DataArray>{
                  make_data_array("part", 1, std::vector<std::uint16_t>{60004, 60004}),
                  make_data_array("q", 2, std::vector<std::int16_t>{5, -30000, 5, -30000})}))
        << format;
    EXPECT_EQ(loaded.repair.triangles_degenerate, 1u);
    EXPECT_NE(loaded.left_out.find("'tags'"), std::string::npos);
  }
}

TEST_F(PlyFile, NumbersInTextMustFitTheirType) {
  save(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar level\nend_header\n0 0 0 256\n");
  EXPECT_THROW(read_points(path), Error);
}

}  // namespace
}  // namespace brindle
