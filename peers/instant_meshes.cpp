// Instant Meshes' two fields, as its batch mode computes them: crosses (rosy 4) and positions
// (posy 4), with the triangles in which each is singular.
//
//     peer MESH.obj --spacing LENGTH --report FILE.json [--threads N] [--intrinsic yes]
//
// It refines a mesh that is too coarse for the spacing first; the extraction of quadrilaterals,
// which follows in its batch mode, is no part of what is measured.

#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <tbb/global_control.h>

#include "dedge.h"
#include "exchange.h"
#include "field.h"
#include "hierarchy.h"
#include "meshstats.h"
#include "normal.h"
#include "subdivide.h"

// Its sources ask for the number of threads by this name.
int nprocs = -1;

namespace {

struct Input {
  MatrixXu triangles;
  MatrixXf points;
};

Input input_of(const TriangleMesh& mesh) {
  Input input;
  input.triangles.resize(3, static_cast<Eigen::Index>(mesh.triangles.size()));
  input.points.resize(3, static_cast<Eigen::Index>(mesh.points.size()));
  for (Eigen::Index m = 0; m < 3; ++m) {
    for (Eigen::Index t = 0; t < input.triangles.cols(); ++t) {
      input.triangles(m, t) = static_cast<uint32_t>(mesh.triangles[t][m]);
    }
    for (Eigen::Index i = 0; i < input.points.cols(); ++i) {
      input.points(m, i) = static_cast<Float>(mesh.points[i][m]);
    }
  }
  return input;
}

// All that its optimizer needs, for edges of length `spacing`.
void prepare(MultiResolutionHierarchy& hierarchy, Input input, Float spacing) {
  const MeshStats stats = compute_mesh_stats(input.triangles, input.points);
  VectorXu first_edge, opposite_edge;
  VectorXb boundary, nonmanifold;
  const auto connect = [&] {
    build_dedge(input.triangles, input.points, first_edge, opposite_edge, boundary, nonmanifold);
  };
  connect();
  const Float average = static_cast<Float>(stats.mAverageEdgeLength);
  if (stats.mMaximumEdgeLength * 2 > spacing || stats.mMaximumEdgeLength > average * 2) {
    subdivide(input.triangles, input.points, first_edge, opposite_edge, boundary, nonmanifold,
              std::min(spacing / 2, average * 2));
    connect();
  }
  AdjacencyMatrix neighbours =
      generate_adjacency_matrix_uniform(input.triangles, first_edge, opposite_edge, nonmanifold);
  MatrixXf normals;
  generate_smooth_normals(input.triangles, input.points, first_edge, opposite_edge, nonmanifold,
                          normals);
  VectorXf areas;
  compute_dual_vertex_areas(input.triangles, input.points, first_edge, opposite_edge, nonmanifold,
                            areas);
  hierarchy.setE2E(std::move(opposite_edge));
  hierarchy.setAdj(std::move(neighbours));
  hierarchy.setF(std::move(input.triangles));
  hierarchy.setV(std::move(input.points));
  hierarchy.setA(std::move(areas));
  hierarchy.setN(std::move(normals));
  hierarchy.setScale(spacing);
  hierarchy.build();
  hierarchy.resetSolution();
}

struct Fields {
  double orientation_ms = 0, position_ms = 0;
  std::size_t orientation_singularities = 0, position_singularities = 0;
};

Fields optimize(MultiResolutionHierarchy& hierarchy, bool extrinsic) {
  constexpr int kSymmetry = 4;
  Optimizer optimizer(hierarchy, false);
  optimizer.setRoSy(kSymmetry);
  optimizer.setPoSy(kSymmetry);
  optimizer.setExtrinsic(extrinsic);
  Fields fields;
  Stopwatch watch;
  optimizer.optimizeOrientations(-1);
  optimizer.notify();
  optimizer.wait();
  fields.orientation_ms = watch.lap();
  std::map<uint32_t, uint32_t> turning;
  compute_orientation_singularities(hierarchy, turning, extrinsic, kSymmetry);
  watch.lap();
  optimizer.optimizePositions(-1);
  optimizer.notify();
  optimizer.wait();
  fields.position_ms = watch.lap();
  optimizer.shutdown();
  // Those of positions are counted where the orientation is not singular.
  std::map<uint32_t, Vector2i> shifting;
  compute_position_singularities(hierarchy, turning, shifting, extrinsic, kSymmetry, kSymmetry);
  fields.orientation_singularities = turning.size();
  fields.position_singularities = shifting.size();
  return fields;
}

void drive(const std::vector<std::string>& words) {
  const TriangleMesh mesh = read_obj(words[0]);
  const Float spacing = static_cast<Float>(number_option(words, "spacing", 0));
  if (!(spacing > 0)) throw std::runtime_error("--spacing must be above 0");
  const auto threads = static_cast<std::size_t>(number_option(words, "threads", 0));
  std::unique_ptr<tbb::global_control> limit;
  if (threads > 0) {
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  threads);
  }
  // It tells of its progress on stdout.
  std::ostringstream unheard;
  std::streambuf* const heard = cout.rdbuf(unheard.rdbuf());
  Input input = input_of(mesh);
  Metrics metrics;
  Stopwatch watch;
  MultiResolutionHierarchy hierarchy;
  prepare(hierarchy, std::move(input), spacing);
  metrics.add("prepare_ms", watch.lap());
  const Fields fields = optimize(hierarchy, option(words, "intrinsic", "no") != "yes");
  cout.rdbuf(heard);
  metrics.add("field_ms", fields.orientation_ms);
  metrics.add("pattern_ms", fields.position_ms);
  metrics.add("vertices", static_cast<double>(hierarchy.size()));
  metrics.add("field_singularities", static_cast<double>(fields.orientation_singularities));
  metrics.add("branches_beyond", static_cast<double>(fields.position_singularities));
  metrics.write(option(words, "report", "/dev/stdout"));
}

}  // namespace

int main(int count, char** words) {
  return run_driver(count, words,
                    "MESH.obj --spacing LENGTH --report FILE.json [--threads N] [--intrinsic yes]",
                    drive);
}
