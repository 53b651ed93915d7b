// Stripe patterns by geometry-central: its smoothest line field, or one that is given, and
// computeStripePattern along it.
//
//     peer MESH.obj --frequency F --report FILE.json [--write-field FILE.csv]
//
// Its phases are linear in every triangle. Their angle to the field is measured as Brindle's is:
// the gradient against the mean of the corners' directions in the triangle's plane, weighted by
// area, over triangles without a branch or a singularity.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "exchange.h"
#include "geometrycentral/surface/direction_fields.h"
#include "geometrycentral/surface/manifold_surface_mesh.h"
#include "geometrycentral/surface/stripe_patterns.h"
#include "geometrycentral/surface/vertex_position_geometry.h"

namespace {

using namespace geometrycentral;
using namespace geometrycentral::surface;

struct Surface {
  std::unique_ptr<ManifoldSurfaceMesh> mesh;
  std::unique_ptr<VertexPositionGeometry> geometry;
  std::vector<std::size_t> numbers;  // of its vertices in the file
};

// Connectivity, and what both the field and the stripes need of the geometry. Vertices that no
// triangle uses are left out, as geometry-central wants it.
Surface surface_of(const TriangleMesh& input) {
  Surface surface;
  std::vector<std::size_t> own(input.points.size(), 0);
  for (const auto& triangle : input.triangles) {
    for (const std::size_t vertex : triangle) own[vertex] = 1;
  }
  for (std::size_t vertex = 0; vertex < own.size(); ++vertex) {
    if (own[vertex] == 0) continue;
    own[vertex] = surface.numbers.size();
    surface.numbers.push_back(vertex);
  }
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& t : input.triangles) polygons.push_back({own[t[0]], own[t[1]], own[t[2]]});
  surface.mesh = std::make_unique<ManifoldSurfaceMesh>(polygons);
  surface.geometry = std::make_unique<VertexPositionGeometry>(*surface.mesh);
  for (std::size_t i = 0; i < surface.numbers.size(); ++i) {
    const Point& p = input.points[surface.numbers[i]];
    surface.geometry->vertexPositions[surface.mesh->vertex(i)] = {p[0], p[1], p[2]};
  }
  surface.geometry->requireTransportVectorsAlongHalfedge();
  surface.geometry->requireHalfedgeCotanWeights();
  surface.geometry->requireVertexDualAreas();
  return surface;
}

// One of the two vectors of the line at every vertex.
std::vector<Point> vectors_of(Surface& surface, const VertexData<Vector2>& field) {
  surface.geometry->requireVertexTangentBasis();
  std::vector<Point> vectors;
  for (const Vertex v : surface.mesh->vertices()) {
    const Vector2 half = Vector2::fromAngle(field[v].arg() / 2);
    const auto& basis = surface.geometry->vertexTangentBasis[v];
    const Vector3 along = half.x * basis[0] + half.y * basis[1];
    vectors.push_back({along.x, along.y, along.z});
  }
  return vectors;
}

struct Stripes {
  CornerData<double> phases;
  FaceData<int> branches;
  FaceData<int> singularities;
};

Stripes stripes_along(Surface& surface, const VertexData<Vector2>& field, double frequency) {
  const VertexData<double> frequencies(*surface.mesh, frequency);
  Stripes stripes;
  std::tie(stripes.phases, stripes.branches, stripes.singularities) =
      computeStripePattern(*surface.geometry, frequencies, field);
  return stripes;
}

Vector3 vector(const Point& p) { return {p[0], p[1], p[2]}; }

struct Errors {
  double area = 0, angle = 0, spacing = 0;
};

void add_triangle(Errors& errors, Surface& surface, const Stripes& stripes,
                  const std::vector<Point>& field, Face face, double frequency) {
  Vector3 corners[3], direction = Vector3::zero(), first = Vector3::zero();
  double phases[3];
  std::size_t m = 0;
  for (const Halfedge edge : face.adjacentHalfedges()) {
    corners[m] = surface.geometry->vertexPositions[edge.vertex()];
    phases[m++] = stripes.phases[edge.corner()];
  }
  const Vector3 twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area = twice.norm() / 2;
  if (area == 0) return;
  const Vector3 normal = twice / (2 * area);
  // Directions of a line field have no sign: all are turned like the first.
  for (const Halfedge edge : face.adjacentHalfedges()) {
    Vector3 along = vector(field[edge.vertex().getIndex()]);
    along -= dot(along, normal) * normal;
    along = along.norm() > 0 ? along.normalize() : along;
    if (first.norm() == 0) first = along;
    direction += dot(along, first) < 0 ? -along : along;
  }
  Vector3 gradient = Vector3::zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 opposite = corners[(i + 2) % 3] - corners[(i + 1) % 3];
    gradient += phases[i] * cross(normal, opposite) / (2 * area);
  }
  const double cosine = dot(direction, gradient) / (direction.norm() * gradient.norm());
  if (!std::isfinite(cosine)) return;
  errors.area += area;
  // Phases of corners begin at the triangle's first: its line may point either way.
  errors.angle += area * std::acos(std::min(1.0, std::abs(cosine)));
  const double wanted = 2 * std::numbers::pi * frequency;
  errors.spacing += area * std::abs(gradient.norm() / wanted - 1);
}

void measure(Metrics& metrics, Surface& surface, const Stripes& stripes,
             const std::vector<Point>& field, double frequency) {
  std::size_t branches = 0, singularities = 0;
  Errors errors;
  for (const Face face : surface.mesh->faces()) {
    if (stripes.singularities[face] != 0) {
      ++singularities;
    } else if (stripes.branches[face] != 0) {
      ++branches;
    } else {
      add_triangle(errors, surface, stripes, field, face, frequency);
    }
  }
  metrics.add("field_singularities", static_cast<double>(singularities));
  metrics.add("branches_beyond", static_cast<double>(branches));
  metrics.add("angle_error_mean_deg", errors.angle / errors.area * 180 / std::numbers::pi);
  metrics.add("spacing_error_mean", errors.spacing / errors.area);
}

void drive(const std::vector<std::string>& words) {
  const TriangleMesh input = read_obj(words[0]);
  const double frequency = number_option(words, "frequency", 1);
  Metrics metrics;
  Stopwatch watch;
  Surface surface = surface_of(input);
  metrics.add("prepare_ms", watch.lap());
  const VertexData<Vector2> field = computeSmoothestVertexDirectionField(*surface.geometry, 2);
  metrics.add("field_ms", watch.lap());
  const Stripes stripes = stripes_along(surface, field, frequency);
  metrics.add("pattern_ms", watch.lap());
  const std::vector<Point> vectors = vectors_of(surface, field);
  const std::string field_file = option(words, "write-field", "");
  if (!field_file.empty()) {
    std::vector<Point> rows(input.points.size(), Point{});
    for (std::size_t i = 0; i < vectors.size(); ++i) rows[surface.numbers[i]] = vectors[i];
    write_vectors(field_file, rows);
  }
  metrics.add("vertices", static_cast<double>(surface.mesh->nVertices()));
  measure(metrics, surface, stripes, vectors, frequency);
#ifdef GC_HAVE_SUITESPARSE
  metrics.add("solver", "SuiteSparse");
#else
  metrics.add("solver", "Eigen");
#endif
  metrics.write(option(words, "report", "/dev/stdout"));
}

}  // namespace

int main(int count, char** words) {
  return run_driver(count, words,
                    "MESH.obj --frequency F --report FILE.json [--write-field FILE.csv]", drive);
}
