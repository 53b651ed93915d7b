#include "brindle/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <regex>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/memory.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/normals.h"
#include "brindle/shapes/implicit_shapes.h"
#include "brindle/shapes/isosurface.h"
#include "parametric_meshes.h"
#include "test_meshes.h"

namespace brindle {
namespace {

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = mesh.positions[a].cast<double>();
    sum += p.dot(mesh.positions[b].cast<double>().cross(mesh.positions[c].cast<double>())) / 6;
  }
  return sum;
}

double smallest_angle(const Mesh& mesh) {
  double smallest = 180;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 a = mesh.positions[t[(c + 1) % 3]] - mesh.positions[t[c]];
      const Vec3 b = mesh.positions[t[(c + 2) % 3]] - mesh.positions[t[c]];
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI);
    }
  }
  return smallest;
}

/// How many triangles each edge has, and how many edges have that number.
std::map<int, int> edge_valences(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, int> triangles;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) ++triangles[std::minmax({t[c], t[(c + 1) % 3]})];
  }
  std::map<int, int> count;
  for (const auto& [edge, number] : triangles) ++count[number];
  return count;
}

long euler_characteristic(const Mesh& mesh) {
  long edges = 0;
  for (const auto& [number, count] : edge_valences(mesh)) edges += count;
  return static_cast<long>(mesh.vertex_count()) - edges + static_cast<long>(mesh.triangle_count());
}

/// As from CAD programs: few triangles, of any form.
bool is_flat_part(const std::string& name) { return name == "bracket" || name == "gear"; }

TEST(Shapes, HaveSensibleSizeByDefault) {
  for (const std::string& name : shape_names()) {
    const Mesh mesh = make_shape(name);
    EXPECT_GE(mesh.vertex_count(), is_flat_part(name) ? 100u : 15000u) << name;
    EXPECT_LE(mesh.vertex_count(), is_flat_part(name) ? 1000u : 60000u) << name;
    const BoundingBox box = bounding_box(mesh);
    EXPECT_NEAR((box.upper - box.lower).maxCoeff(), 2, 0.2) << name;
    // The hemisphere keeps the centre of its sphere at the origin.
    EXPECT_LT(box.center().norm(), name == "hemisphere" ? 0.51f : 0.3f) << name;
    EXPECT_GT(smallest_angle(mesh), is_flat_part(name) ? 0 : 15) << name;
  }
}

TEST(Shapes, UseAllTheirVertices) {
  for (const auto& [name, mesh] : every_shape()) {
    std::vector<char> used(mesh.vertex_count(), 0);
    for (const Triangle& t : mesh.triangles) {
      for (const Index v : t) used[v] = 1;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0) << name;
  }
}

TEST(Shapes, ClosedOnesAreManifoldWoundOutwardsAndOfTheRightGenus) {
  const std::map<std::string, long> characteristic = {
      {"sphere", 2},   {"torus", 0}, {"trefoil", 0},  {"vessels", 2},
      {"molecule", 2}, {"box", 0},   {"bracket", -2}, {"gear", 0}};
  for (const auto& [name, expected] : characteristic) {
    const Mesh& mesh = every_shape().at(name);
    EXPECT_TRUE(manifold_twins(mesh).has_value()) << name;
    EXPECT_GT(volume(mesh), 0) << name;
    EXPECT_EQ(euler_characteristic(mesh), expected) << name;
  }
}

TEST(Shapes, FlatPartsAreClosedAndExactlyFlat) {
  for (const std::string spec :
       {"bracket", "bracket,resolution=1", "bracket,resolution=50,hole=0.5,fillet=0.01",
        "bracket,length=0.9,depth=4,height=3,thickness=0.1,hole=0.2", "gear", "gear,teeth=3",
        "gear,teeth=200,bore=0.67", "gear,tooth=0.5,bore=0.4", "gear,resolution=20,width=0.01"}) {
    const Mesh mesh = make_shape(spec);
    EXPECT_TRUE(manifold_twins(mesh).has_value()) << spec;
    EXPECT_EQ(euler_characteristic(mesh), spec[0] == 'b' ? -2 : 0) << spec;
    const BoundingBox box = bounding_box(mesh);
    for (const Triangle& t : mesh.triangles) {
      const Vec3 normal = triangle_normal(mesh, t);
      EXPECT_FALSE(normal.isZero(0)) << spec;
      for (int axis = 0; axis < 3; ++axis) {
        const auto all_at = [&](float place) {
          return std::all_of(t.begin(), t.end(),
                             [&](Index v) { return mesh.positions[v][axis] == place; });
        };
        // Outer faces look outwards, none of their triangles is turned over.
        const bool lower = all_at(box.lower[axis]), upper = all_at(box.upper[axis]);
        if (!lower && !upper) continue;
        EXPECT_EQ(normal[axis], upper ? 1.0f : -1.0f) << spec;
      }
    }
  }
}

TEST(Shapes, OpenOnesHaveBordersAndNothingWorse) {
  for (const std::string name : {"plane", "cylinder", "hemisphere", "mobius"}) {
    const std::map<int, int> valences = edge_valences(every_shape().at(name));
    EXPECT_GT(valences.at(1), 0) << name;
    EXPECT_EQ(valences.rbegin()->first, 2) << name;
  }
}

TEST(Shapes, SheetsShareOneEdgeLine) {
  const std::map<int, int> valences = edge_valences(make_sheets({.count = 3, .resolution = 10}));
  EXPECT_EQ(valences.at(3), 20);
  EXPECT_EQ(valences.rbegin()->first, 3);
}

TEST(Shapes, MobiusStripHasNoConsistentWinding) {
  const Mesh mesh = make_mobius();
  EXPECT_EQ(euler_characteristic(mesh), 0);
  std::map<std::pair<Index, Index>, int> directed;
  for (const Triangle& t : mesh.triangles) {
    for (int c = 0; c < 3; ++c) ++directed[{t[c], t[(c + 1) % 3]}];
  }
  int conflicts = 0;
  for (const auto& [edge, count] : directed) conflicts += count > 1;
  EXPECT_EQ(conflicts, 56) << "one row of edges, where the strip is joined";
}

TEST(Shapes, PiecesAreUnconnected) {
  EXPECT_EQ(euler_characteristic(make_pieces({.count = 4})), 2 + 0 + 0 + 2);
}

TEST(Shapes, OpenCylinderIsWoundOutwards) {
  const Mesh mesh = make_cylinder();
  for (const Triangle& t : mesh.triangles) {
    const Vec3 p = mesh.positions[t[0]];
    EXPECT_GT(triangle_normal(mesh, t).dot(Vec3(p[0], p[1], 0)), 0);
  }
}

TEST(Shapes, LieOnTheirFormulas) {
  for (const Vec3& p : make_sphere().positions) EXPECT_NEAR(p.norm(), 1, 1e-6);
  for (const Vec3& p : make_torus().positions) {
    EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - 0.7, p[2]), 0.3, 1e-6);
  }
}

TEST(Shapes, SpecSetsParameters) {
  EXPECT_EQ(make_shape("sphere,resolution=3").vertex_count(), 92u);
  const BoundingBox box = bounding_box(make_shape("torus,resolution=300,minor=0.1"));
  EXPECT_NEAR(box.upper[2], 0.1, 1e-3);
}

TEST(Shapes, NoiseIsRepeatableAndBounded) {
  const Mesh smooth = make_shape("sphere,resolution=20");
  const Mesh rough = make_shape("sphere,resolution=20,noise=0.2");
  EXPECT_EQ(rough.positions, make_shape("sphere,resolution=20,noise=0.2").positions);
  EXPECT_NE(rough.positions, make_shape("sphere,resolution=20,noise=0.2,noise_seed=2").positions);
  double largest = 0;
  for (std::size_t v = 0; v < smooth.vertex_count(); ++v) {
    largest = std::max<double>(largest, (rough.positions[v] - smooth.positions[v]).norm());
  }
  const double edge = 0.06;  // of the mesh above, about
  EXPECT_LT(largest, 0.2 * 1.1 * edge);
  EXPECT_GT(largest, 0.2 * 0.9 * edge);
}

TEST(Shapes, HelpNamesEveryShapeAndParameter) {
  for (const std::string& name : shape_names()) {
    EXPECT_NE(shape_help().find(name + ":"), std::string::npos);
  }
  EXPECT_NE(shape_help().find("fillet=0.15"), std::string::npos);
}

std::string message_of(const std::string& spec) {
  try {
    make_shape(spec);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Shapes, UnknownNamesListWhatIsKnown) {
  EXPECT_NE(message_of("donut").find("torus"), std::string::npos);
  EXPECT_NE(message_of("").find("torus"), std::string::npos);
  EXPECT_NE(message_of("torus,radius=1").find("minor"), std::string::npos);
}

TEST(Shapes, AbsurdValuesAreRefused) {
  for (const std::string spec : {"sphere,resolution=0",
                                 "sphere,resolution=-3",
                                 "sphere,resolution=1e9",
                                 "sphere,resolution=2.5",
                                 "sphere,radius=nan",
                                 "sphere,radius=inf",
                                 "sphere,radius=0",
                                 "sphere,radius",
                                 "sphere,radius=",
                                 "sphere,radius=1x",
                                 "torus,minor=0.7",
                                 "torus,minor=2",
                                 "box,fillet=0.5",
                                 "box,hole=0.9",
                                 "bracket,hole=0.6",
                                 "bracket,thickness=1.4",
                                 "gear,tooth=0.6",
                                 "gear,bore=0.7",
                                 "mobius,width=2",
                                 "plane,noise=-1",
                                 "plane,width=0.001,height=1000",
                                 "mobius,width=0.001,radius=1000",
                                 "vessels,noise=1e9"}) {
    EXPECT_NE(message_of(spec), "") << spec;
  }
}

TEST(Isosurface, OfASphereIsASphere) {
  const auto sphere = [](const Eigen::Vector3d& p) { return p.norm() - 0.5; };
  const Mesh mesh = isosurface(sphere, {Vec3::Constant(-0.5f), Vec3::Constant(0.5f)}, 0.03f);
  ASSERT_TRUE(manifold_twins(mesh).has_value());
  EXPECT_NEAR(volume(mesh), 4 * M_PI / 3 / 8, 2e-3);
  for (const Vec3& p : mesh.positions) EXPECT_NEAR(p.norm(), 0.5, 1e-6);
  double total = 0;
  for (const Triangle& t : mesh.triangles) {
    total += (mesh.positions[t[0]] - mesh.positions[t[1]]).norm();
  }
  EXPECT_NEAR(total / static_cast<double>(mesh.triangle_count()), 0.03, 0.003);
}

TEST(Isosurface, StaysClosedWhereItIsHardlyResolved) {
  for (int resolution = 5; resolution < 30; resolution += 4) {
    const Mesh mesh = make_molecule({.atoms = 20, .resolution = resolution});
    EXPECT_TRUE(manifold_twins(mesh).has_value()) << resolution;
  }
}

TEST(Isosurface, OutsideOfItsBoxIsAnError) {
  const auto plane = [](const Eigen::Vector3d& p) { return p[2]; };
  EXPECT_THROW(isosurface(plane, {Vec3::Constant(-1), Vec3::Constant(1)}, 0.2f), Error);
}

TEST(Isosurface, IsTheSameWithOneThreadAndMany) {
  const Mesh many = make_shape("molecule,resolution=30");
  const ThreadLimit limit(1);
  const Mesh one = make_shape("molecule,resolution=30");
  EXPECT_EQ(one.positions, many.positions);
  EXPECT_EQ(one.triangles, many.triangles);
}

/// Expects that the parts, one after the other, are the whole, to the bit.
void expect_parts_of(const std::string& spec, int parts) {
  SCOPED_TRACE(spec + " in " + std::to_string(parts) + " parts");
  const Mesh whole = make_shape(spec);
  std::vector<std::array<std::uint64_t, 3>> triangles;
  std::vector<std::uint8_t> seen(whole.vertex_count());
  std::size_t most = 0;
  for (int part = 0; part < parts; ++part) {
    const auto made = make_shape_part(spec, part, parts);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->vertex_ids.size(), made->mesh.vertex_count());
    EXPECT_TRUE(std::ranges::is_sorted(made->vertex_ids, std::less_equal()));
    std::vector<std::uint8_t> used(made->mesh.vertex_count());
    for (const auto& [a, b, c] : made->mesh.triangles) {
      used[a] = used[b] = used[c] = 1;
      triangles.push_back({made->vertex_ids[a], made->vertex_ids[b], made->vertex_ids[c]});
    }
    EXPECT_EQ(std::ranges::count(used, 0), 0);
    most = std::max(most, made->mesh.triangle_count());
    for (std::size_t v = 0; v < made->vertex_ids.size(); ++v) {
      const std::uint64_t id = made->vertex_ids[v];
      ASSERT_LT(id, whole.vertex_count());
      seen[id] = 1;
      ASSERT_EQ(made->mesh.positions[v], whole.positions[id]);
    }
  }
  EXPECT_EQ(std::ranges::count(seen, 0), 0);
  ASSERT_EQ(triangles.size(), whole.triangle_count());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(triangles[t][c], whole.triangles[t][c]);
  }
  EXPECT_LT(most, 2 * whole.triangle_count() / static_cast<std::size_t>(parts) + 1000);
}

TEST(Shapes, PartsMakeUpTheWhole) {
  for (const char* spec :
       {"plane,resolution=31", "cylinder,resolution=40", "tube,resolution=30,bend=0",
        "sphere,resolution=1", "sphere,resolution=2", "sphere,resolution=17", "torus,resolution=44",
        "trefoil,resolution=12", "hemisphere,resolution=21", "mobius,resolution=9",
        "sheets,count=4,resolution=11", "pieces,count=5,resolution=6"}) {
    for (const int parts : {1, 2, 3, 8, 1000}) expect_parts_of(spec, parts);
  }
}

TEST(Shapes, HaveNoPartsWhereTheyAreMadeWholeAlone) {
  for (const char* spec : {"molecule", "vessels", "box", "torus,noise=0.1"}) {
    EXPECT_FALSE(make_shape_part(spec, 0, 2)) << spec;
  }
  EXPECT_THROW(make_shape_part("torus", 2, 2), Error);
  EXPECT_THROW(make_shape_part("torus", -1, 2), Error);
  EXPECT_THROW(make_shape_part("torus", 0, 0), Error);
  EXPECT_THROW(make_shape_part("tours", 0, 2), Error);
}

// The resolution that a refusal names is one that would do.
TEST(Shapes, AResolutionThatMemoryDoesNotHoldIsRefusedByName) {
  for (const char* name : {"torus", "sphere", "plane", "vessels", "molecule", "box"}) {
    const std::string spec = std::string(name) + ",resolution=400";
    const AssumedMemory little(4e6);
    try {
      make_shape(spec);
      FAIL() << name;
    } catch (const TooLarge& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("shape '" + std::string(name) + "': resolution=400 is too fine"),
                std::string::npos)
          << message;
      std::smatch found;
      ASSERT_TRUE(std::regex_search(message, found, std::regex("as with resolution=([0-9]+)$")))
          << message;
      const int lower = std::stoi(found[1].str());
      EXPECT_LT(lower, 400) << message;
      EXPECT_GT(lower, 4) << message;
    }
  }
}

// What is told to fit does so within what is assumed, but not with much more of it left than half.
TEST(Shapes, ImplicitShapesAreRefusedAboutWhereTheyDoNotFit) {
  for (const std::string name : {"vessels", "molecule", "box"}) {
    const std::size_t vertices = make_shape(name + ",resolution=60").vertex_count();
    const double most = 2 * 560 * static_cast<double>(vertices);
    const AssumedMemory ample(1.5 * most);
    EXPECT_NO_THROW(make_shape(name + ",resolution=60")) << name;
    const AssumedMemory little(most / 3);
    EXPECT_THROW(make_shape(name + ",resolution=60"), TooLarge) << name;
  }
}

}  // namespace
}  // namespace brindle
