// Pieces that no rank has cut from a whole: made, numbered by place, subdivided.
#include <map>

#include <gtest/gtest.h>

#include "brindle/base/array_numbers.h"
#include "brindle/distributed/surface/partition.h"
#include "brindle/distributed/surface/shared_vertices.h"
#include "brindle/error.h"
#include "brindle/mesh_data.h"
#include "ranks.h"

namespace brindle {
namespace {

using namespace testing_support;

/// Expects that the pieces of all ranks together are the whole, to the bit.
void expect_pieces_of(const Mesh& whole, const SurfacePiece& piece) {
  ASSERT_EQ(piece.vertex_ids.size(), piece.mesh.vertex_count());
  std::vector<int> count(whole.vertex_count()), all(count.size());
  for (std::size_t v = 0; v < piece.vertex_ids.size(); ++v) {
    ASSERT_LT(piece.vertex_ids[v], whole.vertex_count());
    ASSERT_EQ(piece.mesh.positions[v], whole.positions[piece.vertex_ids[v]]);
    count[piece.vertex_ids[v]] = 1;
  }
  MPI_Allreduce(count.data(), all.data(), static_cast<int>(all.size()), MPI_INT, MPI_MAX,
                MPI_COMM_WORLD);
  EXPECT_EQ(all, std::vector<int>(all.size(), 1));
  std::map<std::array<std::uint64_t, 3>, std::size_t> number;
  for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
    const auto& [a, b, c] = whole.triangles[t];
    number[{a, b, c}] = t;
  }
  std::vector<int> mine(whole.triangle_count()), of_all(mine.size());
  for (const auto& [a, b, c] : piece.mesh.triangles) {
    const auto found = number.find({piece.vertex_ids[a], piece.vertex_ids[b], piece.vertex_ids[c]});
    ASSERT_NE(found, number.end());
    ++mine[found->second];
  }
  MPI_Allreduce(mine.data(), of_all.data(), static_cast<int>(mine.size()), MPI_INT, MPI_SUM,
                MPI_COMM_WORLD);
  EXPECT_EQ(of_all, std::vector<int>(of_all.size(), 1));
}

TEST(SubdividedPiece, IsThatOfTheWholeHoweverItIsCut) {
  Communicator ranks(MPI_COMM_WORLD);
  for (const char* shape : {"sheets,resolution=6", "sphere,resolution=5", "mobius,resolution=3"}) {
    const Mesh whole = make_shape(shape);
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(shape) + ", " + cut.name);
      const SurfacePiece piece = piece_of(whole, cut.rank_of_triangle(whole), rank());
      for (const int times : {0, 1, 3}) {
        expect_pieces_of(subdivide(whole, times), subdivided_piece(ranks, piece, times));
      }
    }
  }
}

TEST(SubdividedPiece, OfAShapeMadeInPartsIsThatOfTheShape) {
  Communicator ranks(MPI_COMM_WORLD);
  auto part = make_shape_part("torus,resolution=20", rank(), rank_count());
  ASSERT_TRUE(part);
  const SurfacePiece piece{std::move(part->mesh), std::move(part->vertex_ids), {}};
  expect_pieces_of(subdivide(make_shape("torus,resolution=20"), 2),
                   subdivided_piece(ranks, piece, 2));
}

/// Rows of the whole that the piece should have.
std::vector<Index> numbers(const std::vector<std::uint64_t>& ids) {
  return {ids.begin(), ids.end()};
}

/// Labels and numbers for every vertex and triangle, some of them not finite.
DataArrays arrays_of(const Mesh& mesh) {
  std::vector<int> labels;
  std::vector<double> loads;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    labels.push_back(static_cast<int>(7919 * v % 1009));
  }
  for (std::size_t t = 0; t < 3 * mesh.triangle_count(); ++t) {
    loads.push_back(t % 101 == 0 ? NAN : std::sin(static_cast<double>(t)));
  }
  return {{make_data_array("label", 1, labels), make_data_array("place", mesh.positions)},
          {make_data_array("load", 3, loads)}};
}

TEST(SubdividedPiece, HasTheArraysOfTheWhole) {
  Communicator ranks(MPI_COMM_WORLD);
  Mesh whole = make_shape("sheets,resolution=6");
  DataArrays expected = arrays_of(whole);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    Mesh finer = whole;
    DataArrays of_finer = expected;
    subdivide(finer, of_finer, 2);
    SurfacePiece piece = piece_of(whole, cut.rank_of_triangle(whole), rank());
    DataArrays arrays = {rows_of(expected.points, numbers(piece.vertex_ids)),
                         rows_of(expected.cells, numbers(piece.triangle_ids))};
    piece = subdivided_piece(ranks, std::move(piece), arrays, 2);
    EXPECT_EQ(arrays.points, rows_of(of_finer.points, numbers(piece.vertex_ids)));
    EXPECT_EQ(arrays.cells, rows_of(of_finer.cells, numbers(piece.triangle_ids)));
    for (std::size_t t = 0; t < piece.triangle_ids.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(piece.vertex_ids[piece.mesh.triangles[t][c]],
                  finer.triangles[piece.triangle_ids[t]][c]);
      }
    }
  }
}

/// Also at borders, where several ranks have the triangles around a vertex.
TEST(PieceData, MovesRowsOfTrianglesToVerticesAsInTheWhole) {
  Communicator ranks(MPI_COMM_WORLD);
  for (const char* shape : {"sheets,resolution=8", "box,resolution=10"}) {
    const Mesh whole = make_shape(shape);
    const DataArray cells = arrays_of(whole).cells[0];
    const DataArray expected = cells_to_points(whole, cells);
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(shape) + ", " + cut.name);
      const SurfacePiece piece = piece_of(whole, cut.rank_of_triangle(whole), rank());
      const DataArray own = rows_of(cells, numbers(piece.triangle_ids));
      EXPECT_EQ(cells_to_points(ranks, piece, own), rows_of(expected, numbers(piece.vertex_ids)));
      // A ghost repeats a triangle.
      SurfacePiece with_ghost = piece;
      if (!piece.mesh.triangles.empty()) {
        with_ghost.mesh.triangles.push_back(piece.mesh.triangles[0]);
        with_ghost.triangle_ids.push_back(piece.triangle_ids[0]);
        with_ghost.ghost_triangles.assign(with_ghost.triangle_ids.size(), 0);
        with_ghost.ghost_triangles.back() = 1;
      }
      const DataArray with_rows = rows_of(cells, numbers(with_ghost.triangle_ids));
      EXPECT_EQ(cells_to_points(ranks, with_ghost, with_rows),
                rows_of(expected, numbers(piece.vertex_ids)));
      SurfacePiece without_numbers = piece;
      without_numbers.triangle_ids.clear();
      const auto near = doubles_of(cells_to_points(ranks, without_numbers, own).view());
      const auto exact = doubles_of(rows_of(expected, numbers(piece.vertex_ids)).view());
      for (std::size_t i = 0; i < exact.size(); ++i) {
        if (std::isnan(exact[i])) {
          EXPECT_TRUE(std::isnan(near[i]));
        } else {
          EXPECT_NEAR(near[i], exact[i], 1e-12);
        }
      }
    }
  }
}

TEST(PieceData, RefusesRowsThatDoNotFitOnOneRank) {
  Communicator ranks(MPI_COMM_WORLD);
  const Mesh whole = make_shape("sphere,resolution=4");
  const SurfacePiece piece = piece_of(whole, partition_by_curve(whole, rank_count()), rank());
  std::vector<float> rows(piece.mesh.triangle_count() + (rank() == rank_count() - 1 ? 1 : 0));
  EXPECT_THROW(cells_to_points(ranks, piece, make_data_array("load", 1, rows)), Error);
}

TEST(SubdividedPiece, RefusesWhatCannotBeNumbered) {
  Communicator ranks(MPI_COMM_WORLD);
  const Mesh whole = make_shape("sphere,resolution=2");
  SurfacePiece piece = piece_of(whole, partition_by_curve(whole, rank_count()), rank());
  EXPECT_THROW(subdivided_piece(ranks, piece, 30), Error);
  EXPECT_THROW(subdivided_piece(ranks, piece, -1), Error);
  if (rank() == rank_count() - 1) piece.vertex_ids.back() = ~std::uint64_t{0};
  EXPECT_THROW(subdivided_piece(ranks, piece, 1), Error);
}

/// Of triangles that ranks have several times one is left: the lowest rank's.
TEST(RepeatedTriangles, LeaveOneOfEach) {
  const Mesh whole = make_shape("sheets,resolution=8");
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const std::vector<int> rank_of = cut.rank_of_triangle(whole);
    std::vector<int> more = rank_of;  // where some triangles stand as well
    for (std::size_t t = 0; t < more.size(); ++t) {
      if (t % 3 == 0) more[t] = static_cast<int>((t / 3) % static_cast<std::size_t>(rank_count()));
    }
    SurfacePiece piece = piece_of(whole, rank_of, rank());
    const SurfacePiece added = piece_of(whole, more, rank());
    std::map<std::uint64_t, Index> number;
    for (Index v = 0; v < piece.vertex_ids.size(); ++v) number[piece.vertex_ids[v]] = v;
    for (std::size_t t = 0; t < added.mesh.triangle_count(); ++t) {
      if (added.triangle_ids[t] % 3 != 0) continue;
      Triangle corners = added.mesh.triangles[t];
      std::ranges::reverse(corners);
      for (Index& v : corners) {
        const auto next = static_cast<Index>(piece.vertex_ids.size());
        const auto [place, is_new] = number.emplace(added.vertex_ids[v], next);
        if (is_new) {
          piece.vertex_ids.push_back(added.vertex_ids[v]);
          piece.mesh.positions.push_back(added.mesh.positions[v]);
        }
        v = place->second;
      }
      piece.mesh.triangles.push_back(corners);
      piece.triangle_ids.push_back(added.triangle_ids[t]);
    }
    const std::vector<std::uint8_t> repeated = repeated_triangles(piece, MPI_COMM_WORLD);
    ASSERT_EQ(repeated.size(), piece.mesh.triangle_count());
    std::vector<int> lowest(whole.triangle_count(), rank_count()), left(lowest.size()), all(left);
    for (std::size_t t = 0; t < lowest.size(); ++t) {
      lowest[t] = std::min(rank_of[t], t % 3 == 0 ? more[t] : rank_of[t]);
    }
    for (std::size_t t = 0; t < repeated.size(); ++t) {
      if (repeated[t] != 0) continue;
      EXPECT_EQ(lowest[piece.triangle_ids[t]], rank());
      ++left[piece.triangle_ids[t]];
    }
    MPI_Allreduce(left.data(), all.data(), static_cast<int>(all.size()), MPI_INT, MPI_SUM,
                  MPI_COMM_WORLD);
    EXPECT_EQ(all, std::vector<int>(all.size(), 1));
    piece.ghost_triangles.assign(repeated.size(), 1);
    EXPECT_EQ(repeated_triangles(piece, MPI_COMM_WORLD), std::vector<std::uint8_t>(repeated.size()))
        << "ghosts do not count";
    if (rank() == rank_count() - 1) piece.vertex_ids.push_back(0);
    EXPECT_THROW(repeated_triangles(piece, MPI_COMM_WORLD), Error);
  }
}

/// Rows without numbers get those that they have in all ranks' rows, one after the other.
TEST(SharedPlaces, NumberVerticesByWhereTheyStand) {
  Communicator ranks(MPI_COMM_WORLD);
  const Mesh whole = make_shape("box,resolution=12");
  std::vector<Vec3> rows;
  std::vector<std::uint64_t> first_rows;
  for (int r = 0; r < rank_count(); ++r) {
    first_rows.push_back(rows.size());
    const SurfacePiece piece = piece_of(whole, partition_by_curve(whole, rank_count()), r);
    rows.insert(rows.end(), piece.mesh.positions.begin(), piece.mesh.positions.end());
    rows.emplace_back(0.0f, NAN, 0.0f);
    rows.emplace_back(r % 2 == 0 ? 0.0f : -0.0f, 7.0f, 0.0f);
  }
  first_rows.push_back(rows.size());
  const std::vector<Index> expected = first_at_each_place(rows);
  const std::uint64_t begin = first_rows[static_cast<std::size_t>(rank())],
                      end = first_rows[static_cast<std::size_t>(rank()) + 1];
  const auto numbers = numbers_by_place(ranks, std::span(rows).subspan(begin, end - begin));
  ASSERT_EQ(numbers.size(), end - begin);
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], expected[begin + i]);
}

TEST(SharedPlaces, FindVerticesThatAreTorn) {
  Communicator ranks(MPI_COMM_WORLD);
  const std::vector<std::uint64_t> ids = {5, 9, 1000};
  std::vector<Vec3> positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(NAN, 0, 0)};
  const std::vector<std::uint32_t> labels(3, static_cast<std::uint32_t>(rank()));
  EXPECT_FALSE(find_torn_vertex(ranks, ids, positions, labels, 0));
  if (rank_count() == 1) return;
  if (rank() == rank_count() - 1) positions[1].x() = 1.5f;
  EXPECT_FALSE(find_torn_vertex(ranks, ids, positions, labels, 0.6f));
  const auto torn = find_torn_vertex(ranks, ids, positions, labels, 0.4f);
  ASSERT_TRUE(torn);
  EXPECT_EQ(torn->id, 9u);
  EXPECT_EQ(torn->label, 0u);
  EXPECT_EQ(torn->other_label, static_cast<std::uint32_t>(rank_count() - 1));
}

}  // namespace
}  // namespace brindle
