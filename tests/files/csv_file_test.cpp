#include "brindle/files/text/csv_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/point_output.h"
#include "test_folder.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Rows = std::vector<std::vector<double>>;

struct CsvFile : TestFolder {
  fs::path path = folder / "rows.csv";

  Rows read(const std::string& text) const {
    std::ofstream(path, std::ios::binary) << text;
    Rows rows;
    brindle::CsvFile file(path, {"field", "x,y,z"});
    file.read([&](std::size_t, std::span<const double> values) {
      rows.emplace_back(values.begin(), values.end());
    });
    return rows;
  }
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

const Rows kRows = {{1, 2, 3}, {-4, 5.5, 6}};

TEST_F(CsvFile, MayBeSeparatedInAnyUsualWay) {
  for (const std::string text :
       {"1,2,3\n-4,5.5,6\n", "1;2;3\n-4;5.5;6", "1\t2\t3\r\n-4\t5.5\t6\r\n",
        "  1 2  3\n-4   5.5 6 \n", "1, 2, 3\n-4 , 5.5,6\n", "\"1\",\"2\",\"3\"\n-4,5.5,6\n"}) {
    EXPECT_EQ(read(text), kRows) << text;
  }
}

// If each of them were followed to the row's end, this would take minutes.
TEST_F(CsvFile, MarksThatNothingClosesTakeNoLongerThanTheirNumber) {
  std::string row;
  for (int cell = 0; cell < 300000; ++cell) row += "\"a,";
  EXPECT_NE(error_of("1,2,3\n" + row + '\n'), "");
  EXPECT_NE(error_of("1,2,3\n\"a,\"\"b,\"c\"d,\"4\n"), "");
}

TEST_F(CsvFile, MayHaveAHeaderAndAByteOrderMark) {
  for (const std::string header :
       {"x,y,z\n", "\"x\";\"y\";\"z\"\n", "x1 y1 z1\n", "# of hand\n\nX [m],Y [m],Z [m]\n",
        "//X Y Z\n", "\xef\xbb\xbf", "\xef\xbb\xbfx,y,z\r\n", "\xef\xbb\xbf# x\n"}) {
    EXPECT_EQ(read(header + "1,2,3\n-4,5.5,6\n"), kRows) << header;
  }
}

TEST_F(CsvFile, MayHaveNumbersOfAnySize) {
  EXPECT_EQ(read("1e-60,1e300,1e39\n"), (Rows{{1e-60, 1e300, 1e39}}));
  EXPECT_EQ(read("1e-999,1e999,-1e999\n"), (Rows{{0, HUGE_VAL, -HUGE_VAL}}));
}

TEST_F(CsvFile, NamesTheLineOfWhatIsNoNumber) {
  for (const std::string row : {"1,two,3", "1,,3", "1,2,", "one,two,three", "1 2 x", "1;2;x"}) {
    EXPECT_NE(error_of("1,2,3\n" + row + "\n").find("line 2: '" + row + "'"), std::string::npos)
        << error_of("1,2,3\n" + row + "\n");
  }
  // Half a header is a damaged row.
  EXPECT_NE(error_of("1,two,3\n").find("line 1"), std::string::npos);
  EXPECT_NE(error_of("x,y,z\nx,y,z\n").find("line 2"), std::string::npos);
}

TEST_F(CsvFile, NamesTheRemedyForDecimalCommas) {
  for (const std::string row : {"1,5;2,5;3,5", "1,5\t2,5\t3,5", "1,5 2,5 3,5"}) {
    EXPECT_NE(error_of(row + "\n").find("decimal points"), std::string::npos) << error_of(row);
  }
  EXPECT_EQ(error_of("1,x,2\n").find("decimal"), std::string::npos);
}

TEST_F(CsvFile, ShowsNoBytesThatATerminalObeys) {
  const std::string message = error_of("1,2,3\n\x1b[2J\xff," + std::string(100000, 'x') + "\n");
  EXPECT_NE(message.find("\\x1b[2J\\xff"), std::string::npos) << message;
  EXPECT_LT(message.size(), 500u);
}

struct CsvArrays : CsvFile {
  std::vector<DataArray> arrays(const std::string& text) const {
    std::ofstream(path, std::ios::binary) << text;
    return read_csv_arrays(path);
  }
  std::string error_of_arrays(const std::string& text) const {
    try {
      arrays(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

DataArray doubles(const std::string& name, int components, const std::vector<double>& numbers) {
  return make_data_array(name, components, numbers);
}

TEST_F(CsvArrays, ColumnsOfOneArrayComeTogetherInAnyOrder) {
  const std::vector<DataArray> expected = {
      doubles("velocity", 3, {1, 2, 3, 4, 5, 6}), doubles("p", 1, {7, 8}),
      doubles("Points", 3, {9, 10, 11, 12, 13, 14}), doubles("flow", 3, {1, 2, 3, 4, 5, 6}),
      doubles("pair", 2, {1, 2, 3, 4})};
  const std::string names[] = {"velocity:1", "velocity:0", "p",      "velocity:2",
                               "Points_2",   "Points_0",   "flow_y", "Points_1",
                               "flow_X",     "flow_z",     "pair_0", "pair_1"};
  const std::string rows[2][12] = {{"2", "1", "7", "3", "11", "9", "2", "10", "1", "3", "1", "2"},
                                   {"5", "4", "8", "6", "14", "12", "5", "13", "4", "6", "3", "4"}};
  for (const std::string separator : {",", ";", "\t", " ; "}) {
    for (const std::string quote : {"", "\""}) {
      std::string text;
      for (const std::string& name : names) text += quote + name + quote + separator;
      text.resize(text.size() - separator.size());
      for (const auto& row : rows) {
        text += '\n';
        for (const std::string& cell : row) text += quote + cell + quote + separator;
        text.resize(text.size() - separator.size());
      }
      EXPECT_EQ(arrays(text + "\n"), expected) << text;
    }
  }
}

TEST_F(CsvArrays, TensorsHaveTheOrderOfVtk) {
  EXPECT_EQ(arrays("s_XZ,s_XX,s_YY,s_ZZ,s_XY,s_YZ\n6,1,2,3,4,5\n"),
            (std::vector<DataArray>{doubles("s", 6, {1, 2, 3, 4, 5, 6})}));
  EXPECT_EQ(arrays("t:xx,t:xy,t:xz,t:yx,t:yy,t:yz,t:zx,t:zy,t:zz\n1,2,3,4,5,6,7,8,9\n"),
            (std::vector<DataArray>{doubles("t", 9, {1, 2, 3, 4, 5, 6, 7, 8, 9})}));
}

TEST_F(CsvArrays, VectorsNeedNoSeparator) {
  EXPECT_EQ(arrays("x,y,z,Vz,Vx,Vy,sxx,sxy,sxz,wx,wy\n1,2,3,6,4,5,7,8,9,10,11\n"),
            (std::vector<DataArray>{
                doubles("x", 1, {1}), doubles("y", 1, {2}), doubles("z", 1, {3}),
                doubles("V", 3, {4, 5, 6}), doubles("sxx", 1, {7}), doubles("sxy", 1, {8}),
                doubles("sxz", 1, {9}), doubles("wx", 1, {10}), doubles("wy", 1, {11})}));
}

TEST_F(CsvArrays, WhatIsNoWholeArrayStaysApart) {
  EXPECT_EQ(arrays("v:0,v:2,w_x,w_y,u:0,x,y,z\n1,2,3,4,5,6,7,8\n"),
            (std::vector<DataArray>{doubles("v:0", 1, {1}), doubles("v:2", 1, {2}),
                                    doubles("w_x", 1, {3}), doubles("w_y", 1, {4}),
                                    doubles("u:0", 1, {5}), doubles("x", 1, {6}),
                                    doubles("y", 1, {7}), doubles("z", 1, {8})}));
}

TEST_F(CsvArrays, NamesMayHoldSeparatorsAndWordsFormNoArray) {
  EXPECT_EQ(arrays("\"a,b\",\"say \"\"c\"\"\",block\n1,2,left\n3,4,\"5\"\n"),
            (std::vector<DataArray>{doubles("a,b", 1, {1, 3}), doubles("say \"c\"", 1, {2, 4})}));
}

/// Between quotation marks a name may be anything, and those that Brindle writes are.
TEST_F(CsvArrays, NamesMayLookLikeNumbers) {
  for (const std::string name : {"2024", "nan", "-1", "1e3", "a;b", "a\tb", "3 d", ";"}) {
    const std::string text = "x," + csv_name(name) + ",y\n1,2,3\n4,5,6\n";
    EXPECT_EQ(arrays(text),
              (std::vector<DataArray>{doubles("x", 1, {1, 4}), doubles(name, 1, {2, 5}),
                                      doubles("y", 1, {3, 6})}))
        << text;
  }
  EXPECT_NE(error_of("x,2024\n1,2\n").find("between quotation marks"), std::string::npos);
  // Rows of numbers may stand between them, too.
  EXPECT_EQ(read("\"1\",\"2\",\"3\"\n\"-4\",\"5.5\",\"6\"\n"), kRows);
}

TEST_F(CsvArrays, NumbersAreTheNearestDoublesAndEmptyCellsNaN) {
  // As a float this would be rounded up.
  EXPECT_EQ(arrays("a\n1.00000005960464484\n"),
            (std::vector<DataArray>{doubles("a", 1, {1.00000005960464484})}));
  const std::vector<DataArray> read = arrays("a,b\n1,\n,2\n");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(measure_array(read[0]).rows_nan, 1u);
  EXPECT_EQ(measure_array(read[1]).rows_nan, 1u);
}

TEST_F(CsvArrays, ErrorsNameTheLineAndTheColumn) {
  const std::string message = error_of_arrays("a,v:0\n1,2\n# note\n3,four\n");
  EXPECT_NE(message.find("line 4"), std::string::npos) << message;
  EXPECT_NE(message.find("column 'v:0' has 'four'"), std::string::npos) << message;
  EXPECT_NE(error_of_arrays("a;b\n1;2\n1,5;2\n").find("decimal points"), std::string::npos);
  EXPECT_NE(error_of_arrays("a,b\n1,2\n\"1,234\",2\n").find("thousands"), std::string::npos);
  EXPECT_NE(error_of_arrays("a,b\n1,2\n1,2,3\n").find("line 3: 3 cells"), std::string::npos);
  EXPECT_NE(error_of_arrays("1,2\n3,4\n").find("name"), std::string::npos);
  EXPECT_NE(error_of_arrays("a,b\n").find("no numbers"), std::string::npos);
}

}  // namespace
}  // namespace brindle
