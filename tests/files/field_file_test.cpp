#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct FieldCsv : TestFolder {
  fs::path path = folder / "field.csv";

  FieldFile read(const std::string& text, std::size_t vertices,
                 const std::vector<Index>& vertex_of_row = {}) {
    std::ofstream(path) << text;
    return read_field_csv(path, vertices, vertex_of_row);
  }
  std::string error(const std::string& text, std::size_t vertices,
                    const std::vector<Index>& vertex_of_row = {}) {
    try {
      read(text, vertices, vertex_of_row);
    } catch (const Error& failure) {
      return failure.what();
    }
    return "no error";
  }
};

TEST_F(FieldCsv, ReadsThreeColumns) {
  const FieldFile field = read("x,y,z\n1,2,3\n# note\n\n -4.5e-1 , +5 , 6\r\n", 2);
  ASSERT_EQ(field.vectors.size(), 2u);
  EXPECT_EQ(field.vectors[0], Vec3(1, 2, 3));
  EXPECT_EQ(field.vectors[1], Vec3(-0.45f, 5, 6));
  EXPECT_TRUE(field.frequencies.empty());
}

TEST_F(FieldCsv, ReadsTheFrequencyFromTheFourthColumn) {
  EXPECT_EQ(read("1,0,0,12.5\n0,1,0,3\n", 2).frequencies, (std::vector<float>{12.5f, 3}));
}

TEST_F(FieldCsv, ColumnsAreTakenByTheirNames) {
  for (const std::string text :
       {"z,y,x\n3,2,1\n6,5,4\n", "p;Z;\"Y\";q;X;r\n0;3;2;0;1;0\n0;6;5;0;4;0\n",
        "name,x,y,z,a,b\nleft,1,2,3,0,0\nright,4,5,6,0,0\n"}) {
    const FieldFile field = read(text, 2);
    EXPECT_EQ(field.vectors, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}})) << text;
    EXPECT_TRUE(field.frequencies.empty()) << text;
  }
  const FieldFile field = read("frequency_v,x,y,z,frequency\n8,1,2,3,7\n", 1);
  EXPECT_EQ(field.vectors[0], Vec3(1, 2, 3));
  EXPECT_EQ(field.frequencies, (std::vector<float>{7}));
  EXPECT_EQ(field.frequencies_v, (std::vector<float>{8}));
}

TEST_F(FieldCsv, OtherNamesBehindXYZAreFrequenciesAsWithoutNames) {
  const FieldFile field = read("x,y,z,f,g\n1,2,3,4,5\n", 1);
  EXPECT_EQ(field.frequencies, (std::vector<float>{4}));
  EXPECT_EQ(field.frequencies_v, (std::vector<float>{5}));
}

TEST_F(FieldCsv, NamedColumnsNameTheirErrors) {
  EXPECT_NE(error("z,y,x\n1,2,3\n1,b,3\n", 2).find("line 3: column 'y'"), std::string::npos);
  EXPECT_NE(error("z,y,x\n1,b,3\n", 1).find("column 'y'"), std::string::npos);
  EXPECT_NE(error("frequency,x,y,z\n0,1,2,3\n", 1).find("line 2"), std::string::npos);
}

TEST_F(FieldCsv, NanMeansNoWave) {
  EXPECT_TRUE(std::isnan(read("nan,nan,nan\n", 1).vectors[0].x()));
}

TEST_F(FieldCsv, OfVectorsTheDirectionAloneCounts) {
  const FieldFile field = read("3e300,4e300,0\n3e-60,4e-60,0\n0,0,0\n1e-60,1,0\n", 4);
  for (const int i : {0, 1}) {
    EXPECT_LT((field.vectors[i].normalized() - Vec3(0.6f, 0.8f, 0)).norm(), 1e-6) << i;
  }
  EXPECT_EQ(field.vectors[2], Vec3(0, 0, 0));
  EXPECT_EQ(field.vectors[3], Vec3(0, 1, 0));
  EXPECT_NE(error("1,0,0,1e39\n", 1).find("line 1: the frequency"), std::string::npos);
  EXPECT_NE(error("1,0,0,1e-60\n", 1).find("line 1: the frequency"), std::string::npos);
}

TEST_F(FieldCsv, RowsMayStandForTheVerticesOfTheFile) {
  const std::vector<Index> vertex_of_row = {1, 0, 1, 1, 0};
  const FieldFile field = read("0,3,0,4\n1,0,0,8\n0,-1,0,4\n0,5,0,4\n1,0,0,8\n", 2, vertex_of_row);
  EXPECT_EQ(field.vectors, (std::vector<Vec3>{{1, 0, 0}, {0, 3, 0}})) << "the mean of lengths";
  EXPECT_EQ(field.frequencies, (std::vector<float>{8, 4}));
  // As many as the mesh has, too.
  EXPECT_EQ(read("1,0,0\n0,1,0\n", 2, vertex_of_row).vectors,
            (std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}}));
  const std::string message = error("1,0,0\n0,1,0\n0,1,0\n", 2, vertex_of_row);
  EXPECT_NE(message.find("3 rows, but the mesh has 2, or 5"), std::string::npos) << message;
}

TEST_F(FieldCsv, RowsThatDifferAreAveragedUpToSign) {
  const FieldFile field = read("1,0.1,0,1\n-1,0.1,0,3\nnan,0,0,2\n0,0,0,2\n", 1, {0, 0, 0, 0});
  ASSERT_EQ(field.vectors.size(), 1u);
  EXPECT_LT((field.vectors[0].normalized() - Vec3(1, 0, 0)).norm(), 1e-6);
  EXPECT_EQ(field.frequencies, std::vector<float>{2});
  EXPECT_EQ(read("nan,0,0\n0,0,0\n", 1, {0, 0}).vectors, std::vector<Vec3>{Vec3::Zero()});
}

TEST_F(FieldCsv, VerticesThatKeepTheirNumbersHaveTheirOwnRows) {
  EXPECT_EQ(read("1,0,0\n0,1,0\n0,0,1\n", 3, {0, 1, 1}).vectors,
            (std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}

TEST_F(FieldCsv, NamesFileLineAndRemedy) {
  const std::string too_few = error("1,0,0\n", 2);
  EXPECT_NE(too_few.find(path.string()), std::string::npos);
  EXPECT_NE(too_few.find("has 1 rows, but the mesh has 2 vertices"), std::string::npos) << too_few;
  EXPECT_NE(error("1,0,0\n1,zero,0\n", 2).find("line 2"), std::string::npos);
  EXPECT_NE(error("1,0,0\n1,0\n", 2).find("line 2: 2 columns"), std::string::npos);
  EXPECT_NE(error("1,0,0\n1,0,0,4\n", 2).find("line 2"), std::string::npos);
  EXPECT_NE(error("1,0,0\n1,0,0\n1,0,0\n", 2).find("line 3: more rows"), std::string::npos);
  for (const char* frequency : {"0", "-1", "inf", "nan"}) {
    EXPECT_NE(error(std::string("1,0,0,") + frequency + "\n", 1).find("line 1: the frequency"),
              std::string::npos)
        << frequency;
  }
  EXPECT_NE(error("", 1).find("0 rows"), std::string::npos);
}

TEST(FieldCsvFile, MissingFileAndFolderAreNamed) {
  EXPECT_THROW(read_field_csv("/no/such/field.csv", 1), Error);
  EXPECT_THROW(read_field_csv(testing::TempDir(), 1), Error);
}

}  // namespace
}  // namespace brindle
