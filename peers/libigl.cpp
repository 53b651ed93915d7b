// Principal directions by libigl, whose stripes Brindle then lays.
//
//     peer MESH.obj --report FILE.json --write-field FILE.csv

#include <Eigen/Core>

#include "exchange.h"
#include "igl/principal_curvature.h"

namespace {

void drive(const std::vector<std::string>& words) {
  const TriangleMesh input = read_obj(words[0]);
  Eigen::MatrixXd points(input.points.size(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index m = 0; m < 3; ++m) points(i, m) = input.points[i][m];
  }
  Eigen::MatrixXi triangles(input.triangles.size(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    for (Eigen::Index m = 0; m < 3; ++m) {
      triangles(t, m) = static_cast<int>(input.triangles[t][m]);
    }
  }
  Metrics metrics;
  Stopwatch watch;
  Eigen::MatrixXd larger, smaller;
  Eigen::VectorXd larger_value, smaller_value;
  igl::principal_curvature(points, triangles, larger, smaller, larger_value, smaller_value);
  metrics.add("field_ms", watch.lap());
  metrics.add("vertices", static_cast<double>(points.rows()));
  std::vector<Point> vectors;
  for (Eigen::Index i = 0; i < larger.rows(); ++i) {
    vectors.push_back({larger(i, 0), larger(i, 1), larger(i, 2)});
  }
  const std::string field_file = option(words, "write-field", "");
  if (!field_file.empty()) write_vectors(field_file, vectors);
  metrics.write(option(words, "report", "/dev/stdout"));
}

}  // namespace

int main(int count, char** words) {
  return run_driver(count, words, "MESH.obj --report FILE.json --write-field FILE.csv", drive);
}
