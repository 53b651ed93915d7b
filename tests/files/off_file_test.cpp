#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"

namespace brindle {
namespace {

struct OffFile : TestFolder {
  Mesh read(const std::string& content) const {
    std::ofstream(folder / "a.off", std::ios::binary) << content;
    return read_mesh(folder / "a.off").mesh;
  }
  std::string error_of(const std::string& content) const {
    try {
      read(content);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

const std::vector<Vec3> kCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5f, 0.5f, 1}};

void expect_pyramid(const Mesh& mesh, const std::string& what) {
  EXPECT_EQ(mesh.positions, kCorners) << what;
  EXPECT_EQ(mesh.triangle_count(), 6u) << what;
  EXPECT_EQ(mesh.triangles.at(0), (Triangle{0, 1, 4})) << what;
}

TEST_F(OffFile, IsAStreamOfWords) {
  const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 1\n";
  const std::string faces = "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n4 3 2 1 0\n";
  for (const std::string& text :
       {"OFF\n5 5 8\n" + vertices + faces,
        "OFF\n5 5 8\n" + vertices + "3 0\n1\n4\n3 1 2 # a comment\n4\n3 2 3 4 3 3 0 4 4 3 2 1 0\n",
        "OFF\n5 5 8\n" + vertices + "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n4 3\n2\n1\n0\n",
        "OFF\n5 5 8\n" + vertices +
            "3 0 1 4 255 0 0\n3 1\n2 4 0 255 0\n3 2 3 4\n3 3 0 4\n4 3 2 1 0\n",
        std::string("OFF\n5 5 8\n0 0 0 1 0 0\n1 1 0 0 1 0\n.5 .5 1\n") + faces,
        std::string("OFF\n5 5 8\n0 0\n0 1\n0 0 1 1 0\n0 1 0 .5 .5\n1\n") + faces,
        "OFF5 5 8 #\n" + vertices + faces, "OFF 5\n5\n8\n" + vertices + faces,
        std::string("OFF 5 5 8 0 0 0 1 0 0 1 1 0 0 1 0 .5 .5 1 3 0 1 4 3 1 2 4 3 2 3 4 3 3 0 4 4 3 "
                    "2 1 0")}) {
    expect_pyramid(read(text), text);
  }
}

TEST_F(OffFile, HasMoreNumbersPerVertexIfItSaysSo) {
  const std::string words = "OFF 3 1 0 0 0 0 9 9 9 1 0 0 9 9 9 0 1 0 9 9 9 3 0 1 2";
  EXPECT_EQ(read("N" + words).positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_NE(error_of(words), "");
}

std::string big(std::initializer_list<std::uint32_t> words) {
  std::string bytes;
  for (const std::uint32_t word : words) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 255);
  }
  return bytes;
}

TEST_F(OffFile, MayBeBinary) {
  constexpr std::uint32_t kOne = 0x3f800000, kHalf = 0x3f000000;
  const std::string faces = big({3, 0, 1, 4, 0, 3, 1, 2, 4, 3, kOne, 0, kHalf, 3, 2,
                                 3, 4, 0, 3, 3, 0, 4, 1, 7, 4, 3,    2, 1,     0, 0});
  const std::string plain =
      big({5, 5, 8, 0, 0, 0, kOne, 0, 0, kOne, kOne, 0, 0, kOne, 0, kHalf, kHalf, kOne}) + faces;
  expect_pyramid(read("OFF BINARY\n" + plain), "plain");
  std::string with_normals = big({5, 5, 8});
  for (std::size_t v = 0; v < 5; ++v)
    with_normals += plain.substr(12 + 12 * v, 12) + big({1, 2, 3});
  expect_pyramid(read("NOFF BINARY\n" + with_normals + faces), "normals");
  for (std::size_t size = 0; size < plain.size(); size += 3) {
    EXPECT_NE(error_of("OFF BINARY\n" + plain.substr(0, size)), "") << size;
  }
  EXPECT_NE(error_of("OFF BINARY\n" + big({0xffffffff, 1, 0, 0, 0, 0})), "");
  EXPECT_NE(error_of("OFF BINARY\n" + big({1, 1, 0, 0, 0, 0, 0xffffffff, 0})), "");
  EXPECT_NE(error_of("OFF BINARY\n" + big({1, 1, 0, 0, 0, 0, 3, 0, 0, 7, 0})), "");
}

TEST_F(OffFile, OfOtherDimensionsIsRefusedWithTheRemedy) {
  for (const char* header : {"4OFF\n", "nOFF 2\n", "SOUP\n"}) {
    EXPECT_NE(error_of(std::string(header) + "1 1 1\n").find("convert"), std::string::npos);
  }
}

// What makes sense word by word must be whole: nothing lacks, and nothing is left over.
TEST_F(OffFile, TruncatedIsAnErrorWhereverItIsCut) {
  const std::string whole = "OFF 4 4 0 0 0 0 1 0 0 0 1 0 0 0 1 3 0 1 2 3 0 2 3 3 0 3 1 3 3 2 1";
  EXPECT_EQ(read(whole).triangle_count(), 4u);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(error_of(whole.substr(0, size)), "") << whole.substr(0, size);
  }
  EXPECT_NE(error_of(whole + " 1"), "");
}

}  // namespace
}  // namespace brindle
