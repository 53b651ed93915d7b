#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "test_folder.h"

namespace brindle {
namespace {

struct BranchPenaltyCsv : TestFolder {
  std::filesystem::path path = folder / "avoid.csv";

  std::vector<float> read(const std::string& text, std::size_t vertices,
                          const std::vector<Index>& vertex_of_row = {}) {
    std::ofstream(path) << text;
    return read_branch_penalty_csv(path, vertices, vertex_of_row);
  }
  void expect_refused(const std::string& text, const std::string& why,
                      const std::vector<Index>& vertex_of_row = {}) {
    try {
      read(text, 3, vertex_of_row);
      ADD_FAILURE() << "taken: " << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("avoid.csv"), std::string::npos) << error.what();
    }
  }
};

TEST_F(BranchPenaltyCsv, IsANumberARowOrAColumnOfThatName) {
  const std::vector<float> wanted = {0, 0.5f, 1};
  EXPECT_EQ(read("0\n0.5\n1\n", 3), wanted);
  EXPECT_EQ(read("avoid_branches\n0\n0.5\n1\n", 3), wanted);
  EXPECT_EQ(read("x,Avoid_Branches,note\n9,0,a\n9,0.5,b\n9,1,c\n", 3), wanted);
}

TEST_F(BranchPenaltyCsv, OfRowsOfOneVertexTheGreatestCounts) {
  EXPECT_EQ(read("0\n0.5\n1\n0.25\n", 3, {0, 1, 0, 2}), (std::vector<float>{1, 0.5f, 0.25f}));
  // As many rows as vertices are those of the mesh.
  EXPECT_EQ(read("0\n0.5\n1\n", 3, {0, 1, 0, 2}), (std::vector<float>{0, 0.5f, 1}));
}

TEST_F(BranchPenaltyCsv, NamesTheLineAndTheRemedy) {
  expect_refused("0\n1.5\n1\n", "line 2: avoid_branches is 1.5; give a number from 0 to 1");
  expect_refused("0\nnan\n1\n", "line 2: avoid_branches is nan");
  expect_refused("0\n0\n", "ends at line 2 after 2 rows, but the mesh has 3 vertices");
  expect_refused("0\n0\n", "3, or 4 in its file, vertices", {0, 1, 0, 2});
  expect_refused("0,1\n0,1\n0,1\n", "line 1: 2 columns");
  expect_refused("x,y\n0,1\n0,1\n0,1\n", "no column of numbers named avoid_branches");
}

TEST_F(BranchPenaltyCsv, ColumnsOfAFileAreToldByItsFirstRow) {
  std::ofstream(path) << "v:0,v:1,v:2,avoid_branches\nno,numbers,are,read\n";
  const std::vector<DataArray> columns = csv_columns(path);
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(columns[0], make_data_array("v", 3, std::vector<double>{0, 1, 2}));
  EXPECT_EQ(columns[1], make_data_array("avoid_branches", 1, std::vector<double>{3}));
}

}  // namespace
}  // namespace brindle
