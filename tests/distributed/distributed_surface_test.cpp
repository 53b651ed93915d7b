#include "brindle/distributed_surface.h"

#include <functional>

#include <gtest/gtest.h>

#include "brindle/distributed_waves.h"
#include "brindle/error.h"
#include "brindle/geometry/measures.h"
#include "brindle/geometry/topology.h"
#include "brindle/smooth_field.h"
#include "brindle/surface.h"
#include "ranks.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using namespace testing_support;

TEST(DistributedSurface, IsThatOfTheWholeHoweverItIsCut) {
  const auto whole = wavy_surface("box,resolution=20", kAxis, 20);
  for (const Cut& cut : cuts()) {
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

TEST(DistributedSurface, TurnsTheTrianglesThatTheWholeTurns) {
  for (const Mesh& mesh : {make_shape("torus,resolution=30"), make_shape("mobius,resolution=12")}) {
    const auto whole = wavy_surface(with_turned_triangles(mesh), kAxis, 20);
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(cut.name);
      const Parts parts(whole, cut.rank_of_triangle(whole.mesh));
      const DistributedSurface surface = parts.surface();
      for (std::size_t v = 0; v < parts.ids.size(); ++v) {
        EXPECT_EQ(surface.normals()[v], whole.normals[parts.ids[v]]);
      }
      EXPECT_EQ(PieceSurface(surface, parts.piece.mesh).opposite_edges(),
                WholeSurface(make_surface(whole.mesh)).opposite_edges());
    }
  }
}

/// Sheets have edges of three triangles, and no part of a gear that is cut by chance has a chain.
TEST(DistributedSurface, IsSplitAtTheCreasesOfTheWholeHoweverItIsCut) {
  for (const Mesh& mesh : {make_shape("gear"), with_turned_triangles(make_shape("bracket")),
                           make_shape("sheets,resolution=12")}) {
    Mesh split = mesh;
    const Creases creases = split_at_creases(split);
    ASSERT_FALSE(creases.empty());
    const Surface whole = make_surface(split, creases);
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(cut.name);
      Parts parts(wavy_surface(mesh, kAxis, 20), cut.rank_of_triangle(mesh));
      const auto copied = split_at_creases(parts.surface(), parts.piece);
      ASSERT_TRUE(copied);
      const DistributedSurface surface = parts.surface();
      EXPECT_EQ(surface.vertex_count(), whole.mesh.vertex_count());
      EXPECT_EQ(surface.own_vertex_count(), mesh.vertex_count());
      EXPECT_EQ(surface.edge_count(), whole.own_edge_count());
      const SurfacePiece& piece = parts.piece;
      ASSERT_EQ(parts.ids.size() + copied->size(), piece.vertex_ids.size());
      for (const Index vertex : *copied) parts.ids.push_back(parts.ids[vertex]);
      for (std::size_t v = 0; v < piece.vertex_ids.size(); ++v) {
        const auto id = static_cast<Index>(piece.vertex_ids[v]);
        EXPECT_EQ(parts.ids[v], whole.creases.original(id, whole.mesh.vertex_count()));
        EXPECT_EQ(piece.mesh.positions[v], whole.mesh.positions[id]);
        EXPECT_EQ(surface.normals()[v], whole.normals[id]);
      }
      for (std::size_t t = 0; t < piece.mesh.triangle_count(); ++t) {
        for (int c = 0; c < 3; ++c) {
          EXPECT_EQ(piece.vertex_ids[piece.mesh.triangles[t][c]],
                    split.triangles[piece.triangle_ids[t]][c]);
        }
      }
    }
  }
}

TEST(DistributedSurface, IsNotSplitWithoutCreases) {
  Parts parts(wavy_surface("torus,resolution=30", kAxis, 20));
  EXPECT_FALSE(split_at_creases(parts.surface(), parts.piece));
  Parts box(wavy_surface("box,resolution=5", kAxis, 20));
  EXPECT_FALSE(split_at_creases(box.surface(), box.piece, 180));
  EXPECT_THROW(split_at_creases(box.surface(), box.piece, 181), Error);
  EXPECT_EQ(box.piece.vertex_ids, box.ids);
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

}  // namespace
}  // namespace brindle
