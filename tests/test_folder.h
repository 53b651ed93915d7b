/// Folders for the files of tests.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace brindle {

/// A test with an empty folder of its own, because tests run side by side; it is gone afterwards.
struct TestFolder : testing::Test {
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name();

  TestFolder() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~TestFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }

 private:
  static std::string name() {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("brindle_") + test.test_suite_name() + '_' + test.name();
    std::replace(name.begin(), name.end(), '/', '_');  // of tests with parameters
    return name;
  }
};

}  // namespace brindle
