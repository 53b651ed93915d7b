#include "gallery/gallery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "gallery/aneurysm.h"
#include "gallery/charges.h"
#include "gallery/flows.h"
#include "gallery/liver.h"
#include "gallery/rough_meshes.h"

namespace brindle {
namespace {

using Point = Eigen::Vector3d;

std::vector<double> numbers_of(const GalleryFile& file, std::string_view name) {
  const DataArray* array = find_array(file.arrays.points, name);
  if (array == nullptr) return {};
  std::vector<float> numbers(array->bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), array->bytes.data(), array->bytes.size());
  return {numbers.begin(), numbers.end()};
}

struct EveryItem : testing::TestWithParam<std::size_t> {
  const GalleryItem& item = gallery_items()[GetParam()];
};

std::string name_of_item(const testing::TestParamInfo<std::size_t>& item) {
  return gallery_items()[item.param].name;
}

INSTANTIATE_TEST_SUITE_P(Gallery, EveryItem, testing::Range<std::size_t>(0, gallery_items().size()),
                         name_of_item);

TEST_P(EveryItem, HasMeshesWithWholeArraysAndTheFilesThatItsPicturesName) {
  std::set<std::string> names;
  for (const GalleryFile& file : item.make(0.25, {})) {
    EXPECT_TRUE(names.insert(file.name).second) << file.name;
    if (!file.text.empty()) continue;
    Mesh mesh = file.mesh;
    EXPECT_FALSE(repair_mesh(mesh).changed()) << file.name;
    for (const DataArray& array : file.arrays.points) {
      EXPECT_EQ(array.rows(), file.mesh.vertex_count()) << array.name;
    }
  }
  ASSERT_FALSE(item.pictures.empty());
  for (const GalleryPicture& picture : item.pictures) {
    for (const std::string& word : filled_words(picture, {"data", "", "", ""})) {
      if (!word.starts_with("data/") || word.find('%') != std::string::npos) continue;
      const std::string name = word.substr(5, word.find('@') - 5);
      EXPECT_TRUE(names.contains(name)) << name;
    }
  }
}

TEST_P(EveryItem, TellsHowFarItsDataAreAndStopsWhenItIsTold) {
  std::vector<double> fractions;
  item.make(0.25, Progress([&](const ProgressReport& report) {
              fractions.push_back(report.fraction);
              return true;
            }));
  ASSERT_GT(fractions.size(), 8U);
  EXPECT_TRUE(std::ranges::is_sorted(fractions));
  EXPECT_GE(fractions.front(), 0);
  EXPECT_LE(fractions.back(), 1);
  std::size_t heard = 0;
  const Progress half([&](const ProgressReport&) { return ++heard < fractions.size() / 2; });
  EXPECT_THROW(item.make(0.25, half), Cancelled);
  EXPECT_EQ(heard, fractions.size() / 2);
}

TEST(GalleryPicture, TakesWhatUsersHaveInstead) {
  const GalleryPicture picture{
      "p", "",
      "stripe {surface=a.vtp} --with {file=b.vtp}@#fff --legend 'a b' --field {field=array:f}"};
  EXPECT_EQ(filled_words(picture, {"data", "", "", ""}),
            (std::vector<std::string>{"stripe", "data/a.vtp", "--with", "data/b.vtp@#fff",
                                      "--legend", "a b", "--field", "array:f"}));
  EXPECT_EQ(filled_words(picture, {"data", "own.ply", "smooth", ""}),
            (std::vector<std::string>{"stripe", "own.ply", "--with", "data/b.vtp@#fff", "--legend",
                                      "a b", "--field", "smooth"}));
  EXPECT_TRUE(has_place(picture, "surface"));
  EXPECT_FALSE(has_place(picture, "values"));
}

TEST(GalleryPicture, LeavesOutWhatBelongsToItsOwnData) {
  const GalleryPicture picture{"p", "",
                               "stripe {surface=a.vtp} --with {part=eyes.vtp}@#000 "
                               "--color-by {values=array:f}{own=@0..3} --legend {own=none} --flat"};
  EXPECT_EQ(filled_words(picture, {"data", "", "", ""}),
            (std::vector<std::string>{"stripe", "data/a.vtp", "--with", "data/eyes.vtp@#000",
                                      "--color-by", "array:f@0..3", "--legend", "none", "--flat"}));
  EXPECT_EQ(filled_words(picture, {"data", "own.ply", "", "height"}),
            (std::vector<std::string>{"stripe", "own.ply", "--color-by", "height", "--flat"}));
}

TEST(Aneurysm, WallsHoldThePressureEverywhere) {
  const GalleryFile wall = aneurysm_wall(0.5);
  const auto first = numbers_of(wall, "first"), second = numbers_of(wall, "second");
  const auto k1 = numbers_of(wall, "curvature_first"), k2 = numbers_of(wall, "curvature_second");
  const auto thickness = numbers_of(wall, "thickness"), stress = numbers_of(wall, "stress");
  ASSERT_EQ(first.size(), wall.mesh.vertex_count());
  std::size_t capped = 0;
  for (std::size_t v = 0; v < first.size(); ++v) {
    EXPECT_GE(first[v], second[v] * (1 - 1e-6));
    EXPECT_NEAR(stress[6 * v] + stress[6 * v + 1] + stress[6 * v + 2], first[v] + second[v],
                1e-4 * first[v]);
    if (k1[v] <= 0.2) {
      ++capped;
      continue;
    }
    const double held = first[v] * k1[v] + second[v] * k2[v];
    EXPECT_NEAR(held, kAneurysmPressure / thickness[v], 1e-4 * kAneurysmPressure / thickness[v]);
  }
  EXPECT_LT(capped, first.size() / 20);
}

TEST(ChargedMolecule, HasNoChargeAsAWholeAndThePotentialOfItsAtoms) {
  const std::vector<PointCharge> charges = charges_of_molecule();
  double sum = 0;
  for (const PointCharge& charge : charges) sum += charge.charge;
  EXPECT_NEAR(sum, 0, 1e-12);
  const GalleryFile file = charged_molecule(0.2);
  const auto potential = numbers_of(file, "potential");
  double lowest = 0, highest = 0;
  for (std::size_t v = 0; v < potential.size(); ++v) {
    const Point p = file.mesh.positions[v].cast<double>();
    double expected = 0;
    for (const PointCharge& c : charges) expected += 0.7 * c.charge / (p - c.at).norm();
    EXPECT_NEAR(potential[v], expected, 1e-5);
    lowest = std::min(lowest, expected);
    highest = std::max(highest, expected);
  }
  EXPECT_LT(lowest, -0.5);
  EXPECT_GT(highest, 0.5);
}

TEST(Liver, VesselsAndTumourLieInTheHullAndApart) {
  const ImplicitFunction hull = liver_hull(), tumour = liver_tumour();
  const std::vector<Capsule> vessels = liver_vessels();
  EXPECT_GT(vessels.size(), 300);
  std::size_t outside = 0;
  for (const Capsule& vessel : vessels) {
    outside += hull(vessel.b) > 0;
    EXPECT_GT(tumour(vessel.b), 0);
  }
  // The trunk comes from outside.
  EXPECT_LT(outside, 20);
  const Mesh lump = liver_tumour_mesh(0.3);
  for (const Vec3& p : lump.positions) EXPECT_LT(hull(p.cast<double>()), 0);
}

TEST(Liver, VesselsFollowMurraysLaw) {
  struct Fork {
    double cubes = 0, thinnest = 1e9;
  };
  const std::vector<Capsule> vessels = liver_vessels();
  const auto key = [](const Point& p) { return std::array{p.x(), p.y(), p.z()}; };
  std::map<std::array<double, 3>, Fork> forks;
  for (const Capsule& v : vessels) {
    Fork& fork = forks[key(v.a)];
    fork.cubes += std::pow(v.radius_a, 3);
    fork.thinnest = std::min(fork.thinnest, v.radius_a);
  }
  std::size_t checked = 0;
  for (const Capsule& v : vessels) {
    const auto fork = forks.find(key(v.b));
    if (fork == forks.end() || fork->second.thinnest < 0.96) continue;  // as thin as they may be
    EXPECT_NEAR(fork->second.cubes, std::pow(v.radius_b, 3), 1e-9);
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(Vortices, WhirlInOppositeSensesAndComeBack) {
  const auto first = vortex_cores(0), last = vortex_cores(kVortexSteps);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR((first[k] - last[k]).norm(), 0, 1e-9);
  const GalleryFile step = vortex_step(0, vortex_pebble(0.5));
  const Surface surface = make_surface(step.mesh);
  const auto velocity = numbers_of(step, "velocity"), core = numbers_of(step, "core");
  std::array<double, 2> circulation{};
  for (std::size_t v = 0; v < core.size(); ++v) {
    const Point u(velocity[3 * v], velocity[3 * v + 1], velocity[3 * v + 2]);
    const Point p = step.mesh.positions[v].cast<double>(), n = surface.normals[v].cast<double>();
    EXPECT_EQ(std::isnan(core[v]), !u.isZero(0));
    for (int k = 0; k < 2; ++k) {
      if ((p - first[k]).norm() < 0.3) circulation[k] += u.dot(n.cross(p - first[k]));
    }
  }
  EXPECT_GT(circulation[0], 0);
  EXPECT_LT(circulation[1], 0);
}

TEST(RoughMeshes, AreWhatTheyShouldNotBe) {
  const auto triangles_of_edges = [](const Mesh& mesh) {
    std::map<std::pair<Index, Index>, int> count;
    for (const Triangle& t : mesh.triangles) {
      for (int k = 0; k < 3; ++k) ++count[std::minmax(t[k], t[(k + 1) % 3])];
    }
    std::map<int, int> edges;  // by how many triangles they have
    for (const auto& [edge, triangles] : count) ++edges[triangles];
    return edges;
  };
  EXPECT_GT(triangles_of_edges(incomplete_mesh(0.5))[1], 50);
  EXPECT_GT(triangles_of_edges(non_manifold_mesh(0.5))[5], 5);
  EXPECT_GT(triangles_of_edges(segmented_mesh(1))[4], 0);
  EXPECT_EQ(triangles_of_edges(noisy_mesh(0.5)).size(), 1);
}

}  // namespace
}  // namespace brindle
