#include "brindle/shapes/parametric_shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace brindle {
namespace {

constexpr double kPi = std::numbers::pi;
/// Distance of the rows of a lattice of equilateral triangles, over the length of their edges.
const double kRowHeight = std::sqrt(0.75);

Vec3 point(double x, double y, double z) { return Eigen::Vector3d(x, y, z).cast<float>(); }

int row_count(double height, double spacing) {
  return std::max(2, static_cast<int>(std::lround(height / (spacing * kRowHeight))));
}

/// One row of a lattice: its vertices, and where along the row each one stands.
struct Row {
  std::vector<double> at;  ///< ascending, from 0 to 1
  std::vector<Index> vertices;
};

/// Where the vertices of row `number` stand: odd rows are shifted by half an edge, but all reach
/// from border to border.
std::vector<double> row_places(int edges, int number) {
  std::vector<double> at;
  if (number % 2 == 0) {
    for (int i = 0; i <= edges; ++i) at.push_back(static_cast<double>(i) / edges);
    return at;
  }
  at.push_back(0);
  for (int i = 0; i < edges; ++i) at.push_back((i + 0.5) / edges);
  at.push_back(1);
  return at;
}

/// Triangles between two open rows; `upper` lies to the left of `lower`.
void connect_rows(const Row& lower, const Row& upper, std::vector<Triangle>& triangles) {
  std::size_t a = 0, b = 0;
  while (a + 1 < lower.at.size() || b + 1 < upper.at.size()) {
    // The shorter of the two possible diagonals.
    const bool advance_lower =
        b + 1 == upper.at.size() ||
        (a + 1 < lower.at.size() &&
         std::abs(lower.at[a + 1] - upper.at[b]) <= std::abs(upper.at[b + 1] - lower.at[a]));
    if (advance_lower) {
      triangles.push_back({lower.vertices[a], lower.vertices[a + 1], upper.vertices[b]});
      ++a;
    } else {
      triangles.push_back({lower.vertices[a], upper.vertices[b + 1], upper.vertices[b]});
      ++b;
    }
  }
}

template <class Position>
Row add_row(Mesh& mesh, int edges, int number, const Position& position) {
  Row row{row_places(edges, number), {}};
  for (const double at : row.at) {
    row.vertices.push_back(static_cast<Index>(mesh.positions.size()));
    mesh.positions.push_back(position(at));
  }
  return row;
}

/// A lattice that closes around rows: `ring` has as many vertices in every row, odd ones half an
/// edge ahead. `position(u, v)` takes u in [0, 1) around a row and v in [0, 1] across rows. With
/// `closed`, the last row is joined to the first; `rows` is then even.
template <class Position>
Mesh ring_lattice(int around, int rows, bool closed, const Position& position) {
  Mesh mesh;
  const int row_vertices = closed ? rows : rows + 1;
  for (int row = 0; row < row_vertices; ++row) {
    for (int i = 0; i < around; ++i) {
      const double u = (i + (row % 2 == 0 ? 0.0 : 0.5)) / around;
      mesh.positions.push_back(position(u, static_cast<double>(row) / rows));
    }
  }
  const auto vertex = [&](int row, int i) {
    return static_cast<Index>((row % row_vertices) * around + (i % around));
  };
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < around; ++i) {
      const bool even = row % 2 == 0;
      const Index lower = vertex(row, i), lower_next = vertex(row, i + 1);
      const Index upper = vertex(row + 1, i), upper_next = vertex(row + 1, i + 1);
      if (even) {
        mesh.triangles.push_back({lower, lower_next, upper});
        mesh.triangles.push_back({lower_next, upper_next, upper});
      } else {
        mesh.triangles.push_back({lower, upper_next, upper});
        mesh.triangles.push_back({lower, lower_next, upper_next});
      }
    }
  }
  return mesh;
}

int even_row_count(double height, double spacing) {
  return std::max(4, 2 * static_cast<int>(std::lround(height / (spacing * kRowHeight) / 2)));
}

/// The point that divides the great circle from a to b (unit vectors) at t.
Eigen::Vector3d slerp(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) {
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  if (angle < 1e-12) return a;
  return (std::sin((1 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

constexpr double kGolden = 1.6180339887498949;
const std::array<Eigen::Vector3d, 12> kIcosahedronVertices = {{{-1, kGolden, 0},
                                                               {1, kGolden, 0},
                                                               {-1, -kGolden, 0},
                                                               {1, -kGolden, 0},
                                                               {0, -1, kGolden},
                                                               {0, 1, kGolden},
                                                               {0, -1, -kGolden},
                                                               {0, 1, -kGolden},
                                                               {kGolden, 0, -1},
                                                               {kGolden, 0, 1},
                                                               {-kGolden, 0, -1},
                                                               {-kGolden, 0, 1}}};
constexpr std::array<Triangle, 20> kIcosahedronFaces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

/// Builds the vertices of an icosphere, each once, whatever face asks for it.
class Icosphere {
 public:
  explicit Icosphere(const SphereShape& shape) : shape_(shape) {
    for (const Eigen::Vector3d& corner : kIcosahedronVertices) add(corner.normalized());
  }

  void add_face(const Triangle& face) {
    const int n = shape_.resolution;
    std::vector<Index> previous{face[0]};
    for (int row = 1; row <= n; ++row) {
      std::vector<Index> current;
      for (int i = 0; i <= row; ++i) current.push_back(vertex(face, row, i));
      for (int i = 0; i < row; ++i) {
        mesh.triangles.push_back({previous[i], current[i], current[i + 1]});
        if (i + 1 < row) mesh.triangles.push_back({previous[i], current[i + 1], previous[i + 1]});
      }
      previous = std::move(current);
    }
  }

  Mesh mesh;

 private:
  Index add(const Eigen::Vector3d& direction) {
    mesh.positions.push_back((shape_.radius * direction).cast<float>());
    return static_cast<Index>(mesh.positions.size() - 1);
  }

  /// Vertex i of row `row`, counted from corner 0 towards the edge from corner 1 to corner 2.
  Index vertex(const Triangle& face, int row, int i) {
    const int n = shape_.resolution;
    if (i == 0) return edge_vertex(face[0], face[1], row);
    if (i == row) return edge_vertex(face[0], face[2], row);
    if (row == n) return edge_vertex(face[1], face[2], i);
    const auto corner = [&](int c) { return kIcosahedronVertices[face[c]].normalized(); };
    // The mean over the three ways to reach the point along great circles: symmetric in the
    // corners.
    const auto reach = [&](int a, int b, int c, int wb, int wc) {
      const double t = static_cast<double>(wb + wc) / n;
      return slerp(slerp(corner(a), corner(b), t), slerp(corner(a), corner(c), t),
                   static_cast<double>(wc) / (wb + wc));
    };
    const int w0 = n - row, w1 = row - i, w2 = i;
    return add(
        (reach(0, 1, 2, w1, w2) + reach(1, 2, 0, w2, w0) + reach(2, 0, 1, w0, w1)).normalized());
  }

  Index edge_vertex(Index a, Index b, int step) {
    const int n = shape_.resolution;
    if (step == 0) return a;
    if (step == n) return b;
    if (a > b) {
      std::swap(a, b);
      step = n - step;
    }
    auto& vertices = edges_[{a, b}];
    if (vertices.empty()) {
      for (int i = 1; i < n; ++i) {
        vertices.push_back(
            add(slerp(kIcosahedronVertices[a].normalized(), kIcosahedronVertices[b].normalized(),
                      static_cast<double>(i) / n)));
      }
    }
    return vertices[step - 1];
  }

  SphereShape shape_;
  std::map<std::pair<Index, Index>, std::vector<Index>> edges_;
};

/// Point and derivative of the trefoil knot, about two units wide.
constexpr double kTrefoilScale = 1.0 / 3.2;
Eigen::Vector3d trefoil_point(double t) {
  // Shifted so that the middle of the bounding box is at the origin.
  return kTrefoilScale * Eigen::Vector3d(std::sin(t) + 2 * std::sin(2 * t),
                                         std::cos(t) - 2 * std::cos(2 * t) + 0.46,
                                         -std::sin(3 * t));
}
Eigen::Vector3d trefoil_tangent(double t) {
  return Eigen::Vector3d(std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t),
                         -3 * std::cos(3 * t))
      .normalized();
}

/// A closed curve's points at equal arc length, with frames that turn as little as possible.
struct Tube {
  std::vector<Eigen::Vector3d> center, normal, binormal;
};

std::vector<double> equal_arc_parameters(double& length, int& rows, double spacing) {
  constexpr int kFine = 20000;
  std::vector<double> arc(kFine + 1, 0.0);
  for (int i = 0; i < kFine; ++i) {
    const double t = 2 * kPi * i / kFine, next = 2 * kPi * (i + 1) / kFine;
    arc[i + 1] = arc[i] + (trefoil_point(next) - trefoil_point(t)).norm();
  }
  length = arc.back();
  rows = even_row_count(length, spacing);
  std::vector<double> parameters;
  for (int row = 0; row < rows; ++row) {
    const double s = length * row / rows;
    const auto above = std::upper_bound(arc.begin(), arc.end(), s);
    const auto i = static_cast<std::size_t>(above - arc.begin()) - 1;
    parameters.push_back(2 * kPi * (static_cast<double>(i) + (s - arc[i]) / (arc[i + 1] - arc[i])) /
                         kFine);
  }
  return parameters;
}

Tube trefoil_frames(double spacing) {
  double length = 0;
  int rows = 0;
  const std::vector<double> parameters = equal_arc_parameters(length, rows, spacing);
  Tube tube;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  const auto transport = [&](double t) {
    const Eigen::Vector3d tangent = trefoil_tangent(t);
    normal = (normal - normal.dot(tangent) * tangent).normalized();
    return tangent;
  };
  for (const double t : parameters) {
    const Eigen::Vector3d tangent = transport(t);
    tube.center.push_back(trefoil_point(t));
    tube.normal.push_back(normal);
    tube.binormal.push_back(tangent.cross(normal));
  }
  // What the frame has turned by after one round is spread evenly over the rows.
  transport(parameters[0]);
  const double turn = std::atan2(normal.dot(tube.binormal[0]), normal.dot(tube.normal[0]));
  for (int row = 0; row < rows; ++row) {
    const double angle = -turn * row / rows;
    const Eigen::Vector3d n = tube.normal[row], b = tube.binormal[row];
    tube.normal[row] = std::cos(angle) * n + std::sin(angle) * b;
    tube.binormal[row] = std::cos(angle) * b - std::sin(angle) * n;
  }
  return tube;
}

void append(Mesh& mesh, const Mesh& part, const Vec3& offset) {
  const auto first = static_cast<Index>(mesh.positions.size());
  for (const Vec3& position : part.positions) mesh.positions.push_back(position + offset);
  for (const Triangle& t : part.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

}  // namespace

Mesh make_plane(const PlaneShape& shape) {
  const double spacing = static_cast<double>(shape.width) / shape.resolution;
  const int rows = row_count(shape.height, spacing);
  Mesh mesh;
  Row previous;
  for (int row = 0; row <= rows; ++row) {
    Row current = add_row(mesh, shape.resolution, row, [&](double at) {
      return point((at - 0.5) * shape.width, (static_cast<double>(row) / rows - 0.5) * shape.height,
                   0);
    });
    if (row > 0) connect_rows(previous, current, mesh.triangles);
    previous = std::move(current);
  }
  return mesh;
}

Mesh make_cylinder(const CylinderShape& shape) {
  const double spacing = 2 * kPi * shape.radius / shape.resolution;
  return ring_lattice(
      shape.resolution, row_count(shape.height, spacing), false, [&](double u, double v) {
        return point(shape.radius * std::cos(2 * kPi * u), shape.radius * std::sin(2 * kPi * u),
                     (v - 0.5) * shape.height);
      });
}

Mesh make_tube(const TubeShape& shape) {
  const double spacing = 2 * kPi * shape.radius / shape.resolution;
  const double turn = shape.bend_deg * kPi / 180;
  const double straight = turn > 1e-9 ? shape.length / turn : 0;  // the arc's radius
  return ring_lattice(
      shape.resolution, row_count(shape.length, spacing), false, [&](double u, double v) {
        const double r =
            shape.radius * (1 + shape.bulge * std::sin(2 * kPi * v)) * (1 + (shape.taper - 1) * v);
        const double out = r * std::cos(2 * kPi * u), aside = r * std::sin(2 * kPi * u);
        if (straight == 0) return point(out, aside, (v - 0.5) * shape.length);
        const double a = (v - 0.5) * turn;
        return point((straight + out) * std::cos(a) - straight, aside,
                     (straight + out) * std::sin(a));
      });
}

Mesh make_sphere(const SphereShape& shape) {
  Icosphere sphere(shape);
  for (const Triangle& face : kIcosahedronFaces) sphere.add_face(face);
  return std::move(sphere.mesh);
}

Mesh make_torus(const TorusShape& shape) {
  const double R = shape.major, r = shape.minor;
  // psi is conformal to the angle along the major circle: d psi = r d theta / (R + r cos theta).
  const double period = 2 * kPi * r / std::sqrt(R * R - r * r);
  const double spacing = 2 * kPi / shape.resolution;
  return ring_lattice(shape.resolution, even_row_count(period, spacing), true,
                      [&](double u, double v) {
                        const double theta = 2 * std::atan2(std::sqrt(R + r) * std::sin(kPi * v),
                                                            std::sqrt(R - r) * std::cos(kPi * v));
                        const double distance = R + r * std::cos(theta);
                        return point(distance * std::cos(2 * kPi * u),
                                     distance * std::sin(2 * kPi * u), r * std::sin(theta));
                      });
}

Mesh make_trefoil(const TrefoilShape& shape) {
  const Tube tube = trefoil_frames(2 * kPi * shape.radius / shape.resolution);
  const auto rows = static_cast<int>(tube.center.size());
  return ring_lattice(shape.resolution, rows, true, [&](double u, double v) {
    const auto row = static_cast<std::size_t>(std::lround(v * rows));
    const double angle = 2 * kPi * u;
    return Vec3((tube.center[row] + shape.radius * (std::cos(angle) * tube.normal[row] +
                                                    std::sin(angle) * tube.binormal[row]))
                    .cast<float>());
  });
}

Mesh make_hemisphere(const HemisphereShape& shape) {
  // Ring k has 4k vertices: along the rim edges are as long as the rings are apart.
  Mesh mesh;
  mesh.positions.push_back(point(0, 0, shape.radius));
  const int rings = shape.resolution;
  for (int ring = 1; ring <= rings; ++ring) {
    const double polar = 0.5 * kPi * ring / rings;
    const auto first = static_cast<Index>(mesh.positions.size());
    const Index inner_first = first - std::max(1, 4 * (ring - 1));
    for (int i = 0; i < 4 * ring; ++i) {
      const double azimuth = 2 * kPi * i / (4 * ring);
      mesh.positions.push_back(point(shape.radius * std::sin(polar) * std::cos(azimuth),
                                     shape.radius * std::sin(polar) * std::sin(azimuth),
                                     ring == rings ? 0.0 : shape.radius * std::cos(polar)));
    }
    const auto outer = [&](int i) { return first + static_cast<Index>(i % (4 * ring)); };
    const auto inner = [&](int i) {
      return inner_first + static_cast<Index>(i % std::max(1, 4 * (ring - 1)));
    };
    for (int quarter = 0; quarter < 4; ++quarter) {
      for (int i = 0; i < ring; ++i) {
        const int o = quarter * ring + i, n = quarter * (ring - 1) + i;
        mesh.triangles.push_back({inner(n), outer(o), outer(o + 1)});
        if (i + 1 < ring) mesh.triangles.push_back({inner(n), outer(o + 1), inner(n + 1)});
      }
    }
  }
  return mesh;
}

Mesh make_mobius(const MobiusShape& shape) {
  const double spacing = static_cast<double>(shape.width) / shape.resolution;
  const int rows = even_row_count(2 * kPi * shape.radius, spacing);
  Mesh mesh;
  Row first, previous;
  for (int row = 0; row < rows; ++row) {
    const double angle = 2 * kPi * row / rows;
    Row current = add_row(mesh, shape.resolution, row, [&](double at) {
      const double across = (at - 0.5) * shape.width;
      const double distance = shape.radius + across * std::cos(angle / 2);
      return point(distance * std::cos(angle), distance * std::sin(angle),
                   across * std::sin(angle / 2));
    });
    if (row == 0) {
      first = current;
    } else {
      connect_rows(previous, current, mesh.triangles);
    }
    previous = std::move(current);
  }
  // After the half turn the first row comes back reversed.
  std::reverse(first.vertices.begin(), first.vertices.end());
  connect_rows(previous, first, mesh.triangles);
  return mesh;
}

Mesh make_sheets(const SheetsShape& shape) {
  const double spacing = static_cast<double>(shape.width) / shape.resolution;
  const int edges = std::max(1, static_cast<int>(std::lround(shape.height / spacing)));
  const int rows = row_count(shape.width, spacing);
  const auto height = [&](double at) { return (at - 0.5) * shape.height; };
  Mesh mesh;
  const Row axis = add_row(mesh, edges, 0, [&](double at) { return point(0, 0, height(at)); });
  for (int sheet = 0; sheet < shape.count; ++sheet) {
    const double angle = 2 * kPi * sheet / shape.count;
    Row previous = axis;
    for (int row = 1; row <= rows; ++row) {
      const double distance = shape.width * static_cast<double>(row) / rows;
      Row current = add_row(mesh, edges, row, [&](double at) {
        return point(distance * std::cos(angle), distance * std::sin(angle), height(at));
      });
      connect_rows(previous, current, mesh.triangles);
      previous = std::move(current);
    }
  }
  return mesh;
}

Mesh make_pieces(const PiecesShape& shape) {
  // Neighbours on a circle of radius 1 - size leave a gap of half their size.
  const double half = std::sin(kPi / std::max(2, shape.count));
  const double size = shape.count < 2 ? 1.0 : std::min(0.5, half / (1.25 + half));
  const auto radius = static_cast<float>(size);
  const std::array<Mesh, 3> kinds = {
      make_sphere({.radius = radius, .resolution = shape.resolution}),
      make_torus({.major = 0.7f * radius,
                  .minor = 0.3f * radius,
                  .resolution = std::max(8, 4 * shape.resolution)}),
      make_cylinder({.radius = 0.6f * radius,
                     .height = 1.5f * radius,
                     .resolution = std::max(8, 4 * shape.resolution)})};
  Mesh mesh;
  for (int i = 0; i < shape.count; ++i) {
    const double angle = 2 * kPi * i / shape.count;
    const double distance = shape.count < 2 ? 0.0 : 1 - size;
    append(mesh, kinds[static_cast<std::size_t>(i % 3)],
           point(distance * std::cos(angle), distance * std::sin(angle), 0));
  }
  return mesh;
}

}  // namespace brindle
