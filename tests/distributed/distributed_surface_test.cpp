#include "brindle/distributed_surface.h"

#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "brindle/carried_field.h"
#include "brindle/distributed/distributed_field.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/smooth_field.h"
#include "brindle/surface.h"
#include "ranks.h"

namespace brindle {
namespace {

using namespace testing_support;

TEST(DistributedSurface, IsThatOfTheWholeHoweverItIsCut) {
  const auto whole = wavy_surface("box,resolution=20", kAxis, 20);
  for (const Cut& cut : kCuts) {
    SCOPED_TRACE(cut.name);
    const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
    const DistributedSurface surface = parts.surface();
    EXPECT_EQ(surface.vertex_count(), whole.mesh.vertex_count());
    EXPECT_EQ(surface.triangle_count(), whole.mesh.triangle_count());
    EXPECT_EQ(surface.edge_count(), whole.neighborhood->edge_count());
    EXPECT_FLOAT_EQ(static_cast<float>(surface.diagonal()), bounding_box(whole.mesh).diagonal());
    // Every vertex has one owner, and all who have it know its normal.
    std::vector<int> own(whole.mesh.vertex_count()), owners(own.size());
    for (std::size_t v = 0; v < parts.ids.size(); ++v) own[parts.ids[v]] = surface.is_own()[v];
    MPI_Allreduce(own.data(), owners.data(), static_cast<int>(own.size()), MPI_INT, MPI_SUM,
                  MPI_COMM_WORLD);
    EXPECT_EQ(owners, std::vector<int>(own.size(), 1));
    ASSERT_EQ(surface.normals().size(), parts.ids.size());
    for (std::size_t v = 0; v < parts.ids.size(); ++v) {
      EXPECT_EQ(surface.normals()[v], whole.normals[parts.ids[v]]);
    }
  }
}

TEST(DistributedSurface, NeedsNoGhostsAndMindsNone) {
  const Parts parts(wavy_surface("torus,resolution=30", kAxis, 20));
  const DistributedSurface plain = parts.surface();
  // All triangles of the others as ghosts.
  const std::vector<int> ranks = partition_by_curve(parts.whole.mesh, rank_count());
  SurfacePiece piece;
  piece.mesh = parts.whole.mesh;
  for (std::size_t v = 0; v < piece.mesh.vertex_count(); ++v) piece.vertex_ids.push_back(v);
  for (const int r : ranks) {
    piece.triangle_ids.push_back(piece.triangle_ids.size());
    piece.ghost_triangles.push_back(r == rank() ? 0 : 1);
  }
  const DistributedSurface ghosts(piece, MPI_COMM_WORLD);
  EXPECT_EQ(ghosts.vertex_count(), plain.vertex_count());
  EXPECT_EQ(ghosts.triangle_count(), plain.triangle_count());
  EXPECT_EQ(ghosts.edge_count(), plain.edge_count());
  for (std::size_t v = 0; v < parts.ids.size(); ++v) {
    EXPECT_EQ(ghosts.is_own()[parts.ids[v]], plain.is_own()[v]);
    EXPECT_EQ(ghosts.normals()[parts.ids[v]], plain.normals()[v]);
  }
}

void expect_refused(const std::function<void()>& work, const std::string& message) {
  try {
    work();
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(DistributedSurface, RefusesOnAllRanksPiecesThatDoNotFit) {
  const Parts parts(wavy_surface("torus,resolution=20", kAxis, 20));
  const bool is_wrong = rank() == rank_count() - 1;
  const auto refuses = [](const SurfacePiece& piece, const std::string& message) {
    expect_refused([&] { const DistributedSurface surface(piece, MPI_COMM_WORLD); }, message);
  };
  // What is wrong with a piece by itself is so whatever is asked of it.
  const auto both_refuse = [&](const SurfacePiece& piece, const std::string& message) {
    refuses(piece, message);
    expect_refused([&] { repeated_triangles(piece, MPI_COMM_WORLD); }, message);
  };
  SurfacePiece piece = parts.piece;
  if (is_wrong) piece.vertex_ids[1] = piece.vertex_ids[0];
  both_refuse(piece, "two vertices");
  piece = parts.piece;
  if (is_wrong) piece.vertex_ids.pop_back();
  both_refuse(piece, "vertex numbers");
  piece = parts.piece;
  if (is_wrong) piece.mesh.positions[0].x() = INFINITY;
  both_refuse(piece, "not finite");
  piece = parts.piece;
  if (is_wrong) piece.mesh.triangles[0][0] = 1u << 30;
  both_refuse(piece, "triangle 0");
  piece = parts.piece;
  if (is_wrong) piece.ghost_triangles = {1};
  both_refuse(piece, "ghosts");
  piece = parts.piece;
  if (is_wrong) piece.triangle_ids.pop_back();
  both_refuse(piece, "triangle numbers");
  if (rank_count() == 1) return;
  piece = parts.piece;
  if (is_wrong) piece.mesh.origin.x() = 1;
  refuses(piece, "origins");
  piece = parts.piece;
  if (is_wrong) piece.triangle_ids.clear();
  refuses(piece, "some have none");
}

TEST(DistributedField, OfOneRankHasTheBitsOfTheLibrary) {
  if (rank_count() > 1) GTEST_SKIP() << "with several ranks";
  const Parts parts(wavy_surface("molecule,resolution=40", kAxis, 20));
  const Surface whole = make_surface(parts.whole.mesh);
  for (const float anchor : {0.0f, 0.1f}) {
    SmoothFieldOptions options;
    options.curvature_anchor = anchor;
    const DirectionField field = smooth_direction_field(parts.surface(), options);
    const DirectionField expected = smooth_direction_field(whole, options);
    EXPECT_TRUE(same_bits(std::span<const Vec3>(field), std::span<const Vec3>(expected)));
  }
}

/// The smoothness energy of line fields: 1 - cos 2 angle between neighbours, on average.
double roughness(const Surface& surface, const std::vector<Vec3>& field) {
  double sum = 0;
  std::size_t count = 0;
  for (Index v = 0; v < field.size(); ++v) {
    for (const Index other : surface.neighborhood->of(v)) {
      const double cosine = field[v].dot(field[other]);
      sum += 1 - cosine * cosine;
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

TEST(DistributedField, OfASmallSurfaceIsThatOfOneProcessHoweverItIsCut) {
  for (const Cut& cut : kCuts) {
    for (const char* shape : {"vessels,resolution=24", "sphere,resolution=30", "mobius"}) {
      SCOPED_TRACE(std::string(cut.name) + " " + shape);
      const WavySurface wavy = wavy_surface(shape, kAxis, 20);
      const Surface whole = make_surface(wavy.mesh);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      SmoothFieldOptions options;
      const DirectionField field = smooth_direction_field(surface, options, {300, 262144});
      EXPECT_EQ(parts.gathered(std::span<const Vec3>(field), surface.is_own()),
                smooth_direction_field(whole, options));
      // Curvatures at borders are sums in another order.
      options.curvature_anchor = 0.1f;
      const DirectionField drawn = smooth_direction_field(surface, options, {300, 262144});
      const std::vector<Vec3> all = parts.gathered(std::span<const Vec3>(drawn), surface.is_own());
      const DirectionField expected = smooth_direction_field(whole, options);
      double difference = 0;
      for (std::size_t v = 0; v < all.size(); ++v) {
        difference += static_cast<double>((all[v] - expected[v]).norm());
      }
      EXPECT_LT(difference / static_cast<double>(all.size()), 1e-4);
    }
  }
}

TEST(DistributedField, IsAsSmoothAsThatOfOneRank) {
  const Parts parts(wavy_surface("vessels", kAxis, 20));
  const Surface whole = make_surface(parts.whole.mesh);
  const DistributedSurface surface = parts.surface();
  for (const float anchor : {0.0f, 0.1f}) {
    SmoothFieldOptions options;
    options.curvature_anchor = anchor;
    const DirectionField field = smooth_direction_field(surface, options, {300, 0});
    const double expected = roughness(whole, smooth_direction_field(whole, options));
    const std::vector<Vec3> all = parts.gathered(std::span<const Vec3>(field), surface.is_own());
    for (Index v = 0; v < all.size(); ++v) {
      ASSERT_NEAR(all[v].norm(), 1, 1e-5);
      ASSERT_NEAR(all[v].dot(whole.normals[v]), 0, 1e-4);
    }
    EXPECT_LT(roughness(whole, all), 1.05 * expected);
  }
}

/// The angles between two line fields, in degrees, ascending.
std::vector<double> angles_deg(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<double> angles;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const double cosine = std::min(1.0, static_cast<double>(std::abs(a[v].dot(b[v]))));
    angles.push_back(std::acos(cosine) * 180 / std::numbers::pi);
  }
  std::ranges::sort(angles);
  return angles;
}

/// A surface of vessels that widens and narrows, at one of its steps.
WavySurface beating(int step) {
  WavySurface wavy = wavy_surface("vessels,resolution=30", kAxis, 20);
  const float wider = 1 + 0.02f * static_cast<float>(step);
  for (Vec3& p : wavy.mesh.positions) p = {wider * p.x(), p.y() / wider, p.z()};
  return wavy;
}

/// Of moving surfaces in pieces, with planned levels and without them.
TEST(DistributedField, FollowsTheFieldBeforeIt) {
  for (const HierarchyBounds bounds : {HierarchyBounds{300, 262144}, HierarchyBounds{300, 0}}) {
    SCOPED_TRACE(bounds.plan_below);
    std::vector<Vec3> before;
    for (int step = 0; step < 4; ++step) {
      const WavySurface wavy = beating(step);
      const Surface whole = make_surface(wavy.mesh);
      const Parts parts(wavy);
      const DistributedSurface surface = parts.surface();
      SmoothFieldOptions options, of_whole;
      if (step > 0) {
        const Surface last = make_surface(beating(step - 1).mesh);
        of_whole.last.directions = matched_directions({last.mesh, last.normals, before}, whole);
        options.last.directions = parts.of_piece(of_whole.last.directions);
      }
      const DirectionField field = smooth_direction_field(surface, options, bounds);
      const std::vector<Vec3> all = parts.gathered(std::span<const Vec3>(field), surface.is_own());
      if (step > 0) {
        EXPECT_LT(field_step(all, of_whole.last.directions, 2).mean_deg, 3) << step;
        EXPECT_LT(roughness(whole, all), 1.1 * roughness(whole, smooth_direction_field(whole)));
      }
      before = all;
    }
  }
}

/// Fields that nothing draws anywhere are free to turn as a whole, and have many minima: without
/// planned levels, too, all ranks end in the one that a single rank with all triangles ends in. On
/// vessels a pair of singularities may stand elsewhere, which no more than 3 vertices in 100 can
/// show.
TEST(DistributedField, HasTheSameMinimumHoweverItIsCut) {
  for (const char* shape : {"torus,resolution=90", "vessels", "sphere,resolution=48", "mobius"}) {
    SCOPED_TRACE(shape);
    const WavySurface wavy = wavy_surface(shape, kAxis, 20);
    const Surface whole = make_surface(wavy.mesh);
    std::vector<Vec3> first;
    for (const Cut& cut : kCuts) {
      SCOPED_TRACE(cut.name);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      const DirectionField field = smooth_direction_field(surface, {}, {300, 0});
      const std::vector<Vec3> all = parts.gathered(std::span<const Vec3>(field), surface.is_own());
      if (first.empty()) first = all;
      const std::vector<double> angles = angles_deg(all, first);
      EXPECT_LT(angles[angles.size() / 2], 1);
      EXPECT_LT(angles[angles.size() * 97 / 100], 5);
      EXPECT_NEAR(roughness(whole, all), roughness(whole, first), 0.01 * roughness(whole, first));
    }
  }
}

TEST(DistributedField, FollowsCurvature) {
  const Parts parts(wavy_surface("torus,resolution=40", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  const DirectionField field = curvature_direction_field(surface, CurvatureDirection::maximum);
  const Surface whole = make_surface(parts.whole.mesh);
  const DirectionField expected = curvature_direction_field(
      principal_curvatures(whole.mesh.positions, whole.normals, *whole.neighborhood),
      CurvatureDirection::maximum);
  for (std::size_t v = 0; v < field.size(); ++v) {
    EXPECT_GT(std::abs(field[v].dot(expected[parts.ids[v]])), 0.999f);
  }
}

/// A plane that is folded by 90 degrees along its middle.
Mesh roof() {
  Mesh mesh = make_shape("plane,resolution=24");
  const Vec3 size = bounding_box(mesh).upper - bounding_box(mesh).lower;
  Eigen::Index flat = 0, across = 0;
  size.minCoeff(&flat);
  size.maxCoeff(&across);
  const float middle = (bounding_box(mesh).upper + bounding_box(mesh).lower)[across] / 2;
  for (Vec3& p : mesh.positions) p[flat] -= std::abs(p[across] - middle);
  return mesh;
}

/// Where there are sharp edges, however a surface is cut; nowhere on a torus, whose pieces all have
/// boundaries.
TEST(DistributedField, IsDrawnToFeaturesOfTheWhole) {
  SmoothFieldOptions options, drawn;
  drawn.feature_anchor = 100;
  const WavySurface folded = wavy_surface(roof(), kAxis, 20);
  const Surface whole = make_surface(folded.mesh);
  const DirectionField expected = smooth_direction_field(whole, drawn);
  ASSERT_NE(expected, smooth_direction_field(whole, options));
  std::vector<std::uint8_t> is_sharp(folded.mesh.vertex_count());
  for (const auto& [a, b] :
       feature_edges(folded.mesh, mesh_edges(folded.mesh, *folded.neighborhood), 40)) {
    is_sharp[a] = is_sharp[b] = 1;
  }
  // The fold and the boundary.
  ASSERT_GE(std::ranges::count(is_sharp, 1), 5 * 24 - 2);
  for (const Cut& cut : kCuts) {
    SCOPED_TRACE(cut.name);
    const Parts parts(folded, cut.rank_of_triangle(folded.mesh));
    const DistributedSurface surface = parts.surface();
    for (const HierarchyBounds bounds : {HierarchyBounds{}, HierarchyBounds{100, 0}}) {
      const DirectionField field = smooth_direction_field(surface, drawn, bounds);
      std::size_t sharp = 0, along = 0;
      for (std::size_t v = 0; v < field.size(); ++v) {
        const float cosine = std::abs(field[v].dot(expected[parts.ids[v]]));
        if (bounds.plan_below > 0) {
          EXPECT_GT(cosine, 0.9999f);
        }
        if (!is_sharp[parts.ids[v]]) continue;
        ++sharp;
        along += cosine > 0.999f;
      }
      // Where edges meet they cancel.
      EXPECT_GE(along + 6, sharp);
    }
  }
}

TEST(DistributedField, IsDrawnToNothingWhereThereIsNoFeature) {
  SmoothFieldOptions options, drawn;
  drawn.feature_anchor = 100;
  const Parts round(wavy_surface("torus,resolution=24", kAxis, 20));
  const DistributedSurface torus = round.surface();
  const DirectionField plain = smooth_direction_field(torus, options);
  const DirectionField same = smooth_direction_field(torus, drawn);
  EXPECT_TRUE(same_bits(std::span<const Vec3>(plain), std::span<const Vec3>(same)));
}

}  // namespace
}  // namespace brindle
