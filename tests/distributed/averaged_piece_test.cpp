#include "brindle/distributed/averaged_piece.h"

#include <optional>

#include <gtest/gtest.h>

#include "brindle/carried_field.h"
#include "brindle/distributed/distributed_field.h"
#include "brindle/field_index.h"
#include "brindle/pipeline/fields/averaged_normals.h"
#include "brindle/smooth_field.h"
#include "brindle/surface.h"
#include "brindle/threads.h"
#include "ranks.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using namespace testing_support;

/// Levels that rank 0 plans and ranks share, that it has alone, and that ranks grow.
const HierarchyBounds kPlanned = {300, 262144}, kGathered = {}, kGrown = {300, 0};

float share_of_size(const Mesh& mesh, float share) { return share * bounding_box(mesh).diagonal(); }

/// Of the owners, on all ranks. Others have the same bits.
std::vector<Vec3> gathered(const Parts& parts, const DistributedSurface& surface,
                           const std::vector<Vec3>& of_piece) {
  const std::vector<Vec3> all = parts.gathered(std::span<const Vec3>(of_piece), surface.is_own());
  EXPECT_EQ(of_piece, parts.of_piece(all));
  return all;
}

// Shapes with boundaries, of one side, and whose triangles share an edge by threes.
TEST(AveragedPiece, HasTheNormalsOfTheWholeHoweverItIsCut) {
  for (const char* shape :
       {"vessels,resolution=20", "mobius,resolution=16", "sheets,resolution=16"}) {
    const WavySurface wavy = wavy_surface(shape, kAxis, 20);
    const Surface whole = make_surface(wavy.mesh);
    const std::vector<float> radii = {share_of_size(wavy.mesh, 0.02f),
                                      share_of_size(wavy.mesh, 0.08f)};
    const auto expected = averaged_normals(whole, radii);
    ASSERT_NE(expected[0], whole.normals);
    for (const Cut& cut : kCuts) {
      SCOPED_TRACE(std::string(cut.name) + " " + shape);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      const RankSurface& own = surface.rank_surface();
      const auto all = [&](const std::vector<Vec3>& by_vertex) {
        return gathered(parts, surface, own.to_piece(std::span<const Vec3>(by_vertex)));
      };
      const auto alike = averaged_normals(own, radii), same = averaged_on_first(own, radii);
      for (std::size_t r = 0; r < radii.size(); ++r) {
        EXPECT_EQ(all(same[r]), expected[r]);
        const std::vector<Vec3> found = all(alike[r]);
        for (std::size_t v = 0; v < found.size(); ++v) {
          ASSERT_LT((found[v] - expected[r][v]).norm(), 0.02f) << v;
        }
        if (rank_count() == 1) {
          EXPECT_EQ(found, expected[r]);
        }
      }
    }
  }
}

/// Of two line fields.
double mean_angle_deg(const DirectionField& a, const DirectionField& b) {
  return field_step(a, b, 2).mean_deg;
}

/// A field of averaged normals with all that may draw it.
std::vector<SmoothFieldOptions> seen_fields(const Mesh& mesh) {
  SmoothFieldOptions plain;
  plain.normal_radius = share_of_size(mesh, 0.02f);
  SmoothFieldOptions curved = plain, sharp = plain, beside = plain;
  curved.curvature_anchor = 0.1f;
  sharp.feature_anchor = beside.feature_anchor = 2;
  beside.feature_radius = share_of_size(mesh, 0.03f);
  return {plain, curved, sharp, beside};
}

// Rank 0 averages, and all solve with the couplings of one process.
TEST(SeenFromAfar, FieldsOfSmallSurfacesAreThoseOfOneProcessHoweverTheyAreCut) {
  for (const char* shape : {"vessels,resolution=20", "mobius,resolution=12"}) {
    const WavySurface wavy = wavy_surface(shape, kAxis, 20);
    const Surface whole = make_surface(wavy.mesh);
    for (const SmoothFieldOptions& options : seen_fields(wavy.mesh)) {
      const DirectionField expected = smooth_direction_field(whole, options);
      SmoothFieldOptions other = options;
      other.normal_radius = 0;
      ASSERT_NE(expected, smooth_direction_field(whole, other));
      for (const Cut& cut : kCuts) {
        SCOPED_TRACE(std::string(cut.name) + " " + shape);
        const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
        const DistributedSurface surface = parts.surface();
        for (const HierarchyBounds bounds : {kPlanned, kGathered}) {
          const auto all =
              gathered(parts, surface, smooth_direction_field(surface, options, bounds));
          if (options.curvature_anchor + options.feature_anchor == 0) {
            EXPECT_EQ(all, expected);
          } else {  // what draws them is summed in another order at borders
            EXPECT_LT(mean_angle_deg(all, expected), 0.01);
          }
        }
      }
    }
  }
}

TEST(SeenFromAfar, FieldsOfOneRankHaveTheBitsOfTheLibrary) {
  if (rank_count() > 1) GTEST_SKIP() << "with several ranks";
  const Parts parts(wavy_surface("molecule,resolution=30", kAxis, 20));
  const Surface whole = make_surface(parts.whole.mesh);
  for (const SmoothFieldOptions& options : seen_fields(whole.mesh)) {
    EXPECT_EQ(smooth_direction_field(parts.surface(), options),
              smooth_direction_field(whole, options));
  }
}

// Ranks that grow levels find another of many fields that are about as good.
TEST(SeenFromAfar, FieldsOfLargeSurfacesHaveAboutAsFewSingularities) {
  double plain = 0, expected = 0, found = 0;
  for (const char* shape : {"molecule", "vessels"}) {
    const WavySurface wavy = wavy_surface(shape, kAxis, 20);
    const Surface whole = make_surface(wavy.mesh);
    const auto count = [&](const DirectionField& field) {
      return static_cast<double>(count_singularities(whole.mesh, field, 4));
    };
    plain += count(smooth_direction_field(whole, {.symmetry = 4}));
    const SmoothFieldOptions options = {.symmetry = 4,
                                        .normal_radius = share_of_size(wavy.mesh, 0.01f)};
    expected += count(smooth_direction_field(whole, options));
    const Parts parts(wavy);
    const DistributedSurface surface = parts.surface();
    const auto field = gathered(parts, surface, smooth_direction_field(surface, options, kGrown));
    for (Index v = 0; v < field.size(); ++v) {
      ASSERT_NEAR(field[v].norm(), 1, 1e-5);
      ASSERT_NEAR(field[v].dot(whole.normals[v]), 0, 1e-4);
    }
    found += count(field);
  }
  EXPECT_LT(found, 0.75 * plain);
  EXPECT_NEAR(found, expected, 0.15 * expected);
}

// On any number of threads.
TEST(SeenFromAfar, FieldsHaveTheSameBitsInEveryRun) {
  const Parts parts(wavy_surface("vessels,resolution=30", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  const SmoothFieldOptions options = seen_fields(parts.whole.mesh)[1];
  for (const HierarchyBounds bounds : {kPlanned, kGrown}) {
    const DirectionField field = smooth_direction_field(surface, options, bounds);
    for (const int threads : {1, 2}) {
      const ThreadLimit limit(threads);
      EXPECT_EQ(smooth_direction_field(surface, options, bounds), field) << threads;
    }
  }
}

// Normals that point to the other side say the same of how a surface bends.
TEST(SeenFromAfar, FieldsOfTheOtherSideAreTheSame) {
  WavySurface wavy = wavy_surface("vessels,resolution=24", kAxis, 20);
  const SmoothFieldOptions options = seen_fields(wavy.mesh)[1];
  for (const HierarchyBounds bounds : {kPlanned, kGrown}) {
    const auto field_of = [&] {
      const Parts parts(wavy);
      const DistributedSurface surface = parts.surface();
      return gathered(parts, surface, smooth_direction_field(surface, options, bounds));
    };
    const std::vector<Vec3> field = field_of();
    for (Triangle& t : wavy.mesh.triangles) std::swap(t[1], t[2]);
    EXPECT_LT(mean_angle_deg(field_of(), field), 0.1);
  }
}

// The surface widens and narrows step by step.
TEST(SeenFromAfar, FieldsFollowTheOneBefore) {
  for (const HierarchyBounds bounds : {kPlanned, kGrown}) {
    std::optional<Surface> last;
    std::vector<Vec3> before;
    for (int step = 0; step < 3; ++step) {
      WavySurface wavy = wavy_surface("vessels,resolution=30", kAxis, 20);
      const float wider = 1 + 0.02f * static_cast<float>(step);
      for (Vec3& p : wavy.mesh.positions) p = {wider * p.x(), p.y() / wider, p.z()};
      const Surface whole = make_surface(wavy.mesh);
      const Parts parts(wavy);
      const DistributedSurface surface = parts.surface();
      SmoothFieldOptions options;
      options.normal_radius = share_of_size(wavy.mesh, 0.02f);
      std::vector<Vec3> carried;
      if (last) carried = matched_directions({last->mesh, last->normals, before}, whole);
      if (last) options.last.directions = parts.of_piece(carried);
      before = gathered(parts, surface, smooth_direction_field(surface, options, bounds));
      if (last) {
        EXPECT_LT(mean_angle_deg(before, carried), 6);
      }
      last = whole;
    }
  }
}

}  // namespace
}  // namespace brindle
