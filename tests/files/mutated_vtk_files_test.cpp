#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/files/vtk/vtk_file.h"
#include "vtk_surfaces.h"

namespace brindle {
namespace {

struct MutatedVtkFiles : VtkFile {};

/// A copy with something wrong in it.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
  };
  const std::size_t at = below(text.size());
  const std::size_t digit = text.find_first_of("0123456789", at);
  switch (below(7)) {
    case 0:
      text[at] = static_cast<char>(below(256));
      break;
    case 1:
      text.resize(at);
      break;
    case 2:
      text.erase(at, below(200));
      break;
    case 3:
      text.insert(at, text.substr(below(text.size()), below(200)));
      break;
    case 4:
      if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
      break;
    case 5:
      if (digit != std::string::npos) text.insert(digit, std::to_string(random()));
      break;
    default:
      for (int i = 0; i < 4; ++i) text[below(text.size())] = '\xff';
  }
  return text;
}

TEST_F(MutatedVtkFiles, MutatedFilesAreReadOrRefused) {
  std::vector<std::pair<std::string, std::string>> files;
  const DataArrays arrays = every_type();
#ifdef BRINDLE_HAS_VTK
  const Cells cells = {{0, 1, 4, 3, 0, 1, 3, 8, 1, 2, 4, 5}, {4, 8, 12}};
  for (const VtkXmlStyle& style :
       {VtkXmlStyle{}, VtkXmlStyle{"binary"}, VtkXmlStyle{"binary", true, true},
        VtkXmlStyle{"appended raw"}, VtkXmlStyle{"appended raw", true, false, true},
        VtkXmlStyle{"appended base64", false, true}, VtkXmlStyle{"appended base64", true}}) {
    files.emplace_back("a.vtp", poly_data(style, arrays));
    files.emplace_back("a.vtu", grid(style, cells, {9, 10, 8}));
  }
#endif
  for (const bool binary : {false, true}) {
    for (const int version : {4, 5}) files.emplace_back("a.vtk", legacy(binary, version, arrays));
  }
  std::mt19937 random(7);
  std::size_t refused = 0, count = 0;
  for (; count < 2600; ++count) {
    const auto& [name, text] = files[count % files.size()];
    const std::string damaged = mutated(mutated(text, random), random);
    try {
      const LoadedMesh loaded = read(name, damaged);
      for (const DataArray& array : loaded.arrays.points) {
        ASSERT_EQ(array.rows(), loaded.mesh.vertex_count());
        ASSERT_LT(array.bytes.size(), 1200 * text.size());
      }
      for (const DataArray& array : loaded.arrays.cells) {
        ASSERT_EQ(array.rows(), loaded.mesh.triangle_count());
      }
      for (const Triangle& t : loaded.mesh.triangles) {
        for (const Index v : t) ASSERT_LT(v, loaded.mesh.vertex_count());
      }
    } catch (const Error& error) {
      ++refused;
      ASSERT_TRUE(std::string(error.what()).find(name) != std::string::npos) << error.what();
    }
  }
  EXPECT_GT(refused, count / 4);
  EXPECT_LT(refused, count);
}

}  // namespace
}  // namespace brindle
