#include "brindle/files/csv_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

namespace fs = std::filesystem;

using Rows = std::vector<std::vector<double>>;

struct CsvFile : testing::Test {
  fs::path path =
      fs::path(testing::TempDir()) /
      (std::string("csv_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  void TearDown() override { fs::remove(path); }

  Rows read(const std::string& text) const {
    std::ofstream(path, std::ios::binary) << text;
    Rows rows;
    read_csv(path, {"field", "x,y,z"}, [&](std::size_t, std::span<const double> values) {
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

}  // namespace
}  // namespace brindle
