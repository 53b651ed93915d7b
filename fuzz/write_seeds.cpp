/// write_seeds FOLDER: inputs to begin with, in a folder for each target; prints their names.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "brindle/error.h"
#include "targets.h"

int main(int count, char** arguments) {
  using namespace brindle::fuzz;
  if (count != 2) {
    std::fputs("usage: write_seeds FOLDER\n", stderr);
    return 2;
  }
  try {
    for (const Target& target : targets()) {
      const auto folder = std::filesystem::path(arguments[1]) / target.name;
      std::filesystem::create_directories(folder);
      int number = 0;
      for (const std::string& seed : seeds(target)) {
        std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed;
      }
      std::printf("%s\n", std::string(target.name).c_str());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_seeds: %s\n", error.what());
    return 1;
  }
}
