#include "brindle/pattern_buffers.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

struct SmallPattern {
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Vec3> normals{{0, 0, 1}, {0, 0.6f, 0.8f}, {0, 0, 1}};
  std::vector<Vec3> directions{{1, 0, 0}, {0, 0, 0}, {0.6f, 0.8f, 0}};
  std::vector<float> frequencies{2, 3, 4};
  std::vector<Complex> z{{1, 0}, {0, 0}, {0.6f, -0.8f}};

  PatternArrays arrays() const { return {positions, normals, directions, frequencies, z}; }
};

TEST(PatternBuffers, AreWhatShadersRead) {
  const SmallPattern pattern;
  const std::vector<Triangle> triangles{{0, 1, 2}, {2, 1, 0}};
  std::vector<CornerPhases> corners(2);
  corners[0].kind = TriangleKind::no_wave;
  corners[1].kind = TriangleKind::branch;
  const PatternBuffers buffers = pattern_buffers(pattern.arrays(), triangles, corners);
  ASSERT_EQ(buffers.vertices.size(), 3u);
  float numbers[12];
  std::memcpy(numbers, &buffers.vertices[2], sizeof numbers);
  const float expected[12] = {0, 1, 0, 4, 0.6f, 0.8f, 0, 0.6f, 0, 0, 1, -0.8f};
  for (int i = 0; i < 12; ++i) EXPECT_EQ(numbers[i], expected[i]) << i;
  ASSERT_EQ(buffers.triangles.size(), 2u);
  std::uint32_t words[4];
  std::memcpy(words, &buffers.triangles[1], sizeof words);
  const std::uint32_t expected_words[4] = {2, 1, 0, 1};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(words[i], expected_words[i]) << i;
  EXPECT_EQ(buffers.triangles[0].kind, 3u);
  EXPECT_EQ(pattern_buffers(pattern.arrays(), triangles).triangles[1].kind, 0u);
}

std::string refusal(const PatternArrays& arrays, const std::vector<Triangle>& triangles,
                    const std::vector<CornerPhases>& corners = {}) {
  try {
    pattern_buffers(arrays, triangles, corners);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PatternBuffers, RefuseWhatDoesNotFitByName) {
  const SmallPattern pattern;
  const std::vector<Triangle> triangles{{0, 1, 2}};
  EXPECT_EQ(refusal(pattern.arrays(), triangles), "");
  PatternArrays arrays = pattern.arrays();
  arrays.directions = arrays.directions.first(2);
  EXPECT_NE(refusal(arrays, triangles).find("2 directions for 3 vertices"), std::string::npos);
  EXPECT_NE(refusal(pattern.arrays(), {{0, 1, 3}}).find("corner 3"), std::string::npos);
  EXPECT_NE(refusal(pattern.arrays(), triangles, std::vector<CornerPhases>(2)).find("2 kinds"),
            std::string::npos);
  std::vector<PatternVertex> two(2);
  EXPECT_THROW(fill_pattern_vertices(pattern.arrays(), two), Error);
}

}  // namespace
}  // namespace brindle
