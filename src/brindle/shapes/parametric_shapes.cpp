#include "brindle/shapes/parametric_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

constexpr double kPi = std::numbers::pi;
/// The distance of rows in a lattice of equilateral triangles, relative to the edge length.
const double kRowHeight = std::sqrt(0.75);

Vec3 point(double x, double y, double z) { return Eigen::Vector3d(x, y, z).cast<float>(); }

int row_count(double height, double spacing) {
  return std::max(2, static_cast<int>(std::lround(height / (spacing * kRowHeight))));
}

/// A row of a lattice: its vertices, and their positions along the row.
struct Row {
  std::vector<double> at;  ///< ascending, from 0 to 1
  std::vector<Index> vertices;
};

/// Odd rows are shifted by half an edge, but all rows span the full width.
Index row_size(int edges, std::size_t number) {
  return static_cast<Index>(edges) + (number % 2 == 0 ? 1 : 2);
}

/// The position of vertex i in row `number`.
double row_place(int edges, std::size_t number, Index i) {
  if (number % 2 == 0) return static_cast<double>(i) / edges;
  if (i == 0) return 0;
  return i > static_cast<Index>(edges) ? 1 : (static_cast<double>(i - 1) + 0.5) / edges;
}

/// Row `number`, with vertices from `first` on.
Row make_row(int edges, std::size_t number, Index first) {
  Row row;
  for (Index i = 0; i < row_size(edges, number); ++i) {
    row.at.push_back(row_place(edges, number, i));
    row.vertices.push_back(first + i);
  }
  return row;
}

/// Triangles between two open rows; `upper` is to the left of `lower`.
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

/// An open lattice: strip s is between the rows `rows_of(s)`, which are the shape's blocks.
/// `number_of(row)` is a row's number within its lattice, `position(row, at)` the position of a
/// vertex.
template <class Position, class Number, class Rows>
StripShape open_lattice(int edges, std::size_t rows, std::size_t strips, const Number& number_of,
                        const Rows& rows_of, const Position& position) {
  StripShape shape;
  for (std::size_t row = 0; row < rows; ++row) {
    shape.block_sizes.push_back(row_size(edges, number_of(row)));
  }
  shape.position = [=](std::size_t row, Index i) {
    return position(row, row_place(edges, number_of(row), i));
  };
  shape.strips = strips;
  shape.triangles_of = [=](std::size_t strip) {
    const auto [lower, upper] = rows_of(strip);
    return std::size_t{row_size(edges, number_of(lower))} + row_size(edges, number_of(upper)) - 2;
  };
  shape.blocks_of = [=](std::size_t strip) {
    const auto [lower, upper] = rows_of(strip);
    return std::vector<std::size_t>{lower, upper};
  };
  shape.add_strip = [=](std::size_t strip, std::span<const Index> first,
                        std::vector<Triangle>& triangles) {
    const auto [lower, upper] = rows_of(strip);
    Row next = make_row(edges, number_of(upper), first[1]);
    // Back at the first row, after a half turn.
    if (upper < lower) ranges::reverse(next.vertices);
    connect_rows(make_row(edges, number_of(lower), first[0]), next, triangles);
  };
  return shape;
}

/// A lattice that is periodic along rows of `ring` vertices; odd rows are shifted by half an edge.
/// `position(u, v)` takes u in [0, 1) along a row and v in [0, 1] across rows. If `closed`, the
/// last row is joined to the first, and `rows` is even.
template <class Position>
StripShape ring_lattice(int around, int rows, bool closed, const Position& position) {
  const auto row_vertices = static_cast<std::size_t>(closed ? rows : rows + 1);
  const auto ring = static_cast<Index>(around);
  StripShape shape;
  shape.block_sizes.assign(row_vertices, ring);
  shape.position = [=](std::size_t row, Index i) {
    const double u = (i + (row % 2 == 0 ? 0.0 : 0.5)) / around;
    return position(u, static_cast<double>(row) / rows);
  };
  shape.strips = static_cast<std::size_t>(rows);
  shape.triangles_of = [=](std::size_t) { return std::size_t{2} * ring; };
  shape.blocks_of = [=](std::size_t row) {
    return std::vector<std::size_t>{row, (row + 1) % row_vertices};
  };
  shape.add_strip = [=](std::size_t row, std::span<const Index> first,
                        std::vector<Triangle>& triangles) {
    for (Index i = 0; i < ring; ++i) {
      const Index next = (i + 1) % ring;
      const Index lower = first[0] + i, lower_next = first[0] + next;
      const Index upper = first[1] + i, upper_next = first[1] + next;
      if (row % 2 == 0) {
        triangles.push_back({lower, lower_next, upper});
        triangles.push_back({lower_next, upper_next, upper});
      } else {
        triangles.push_back({lower, upper_next, upper});
        triangles.push_back({lower, lower_next, upper_next});
      }
    }
  };
  return shape;
}

int even_row_count(double height, double spacing) {
  return std::max(4, 2 * static_cast<int>(std::lround(height / (spacing * kRowHeight) / 2)));
}

/// Interpolates along the great circle from a to b (unit vectors).
Eigen::Vector3d slerp(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) {
  const double angle = elementary::atan2(a.cross(b).norm(), a.dot(b));
  if (angle < 1e-12) return a;
  return (elementary::sin((1 - t) * angle) * a + elementary::sin(t * angle) * b) /
         elementary::sin(angle);
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

Eigen::Vector3d icosahedron_corner(Index c) { return kIcosahedronVertices[c].normalized(); }

/// The blocks of an icosphere: corners, then, face by face, edges that no earlier face has, and
/// rows.
class Icosphere {
 public:
  explicit Icosphere(const SphereShape& shape)
      : shape_(shape), n_(static_cast<Index>(shape.resolution)) {
    for (Index c = 0; c < kIcosahedronVertices.size(); ++c)
      blocks_.push_back({.corner = c, .size = 1});
    for (const Triangle& face : kIcosahedronFaces) {
      FaceBlocks& of_face = faces_.emplace_back();
      of_face.edges[0] = edge_block(face[0], face[1]);
      of_face.edges[1] = edge_block(face[0], face[2]);
      of_face.first_row = blocks_.size();
      for (Index row = 2; row < n_; ++row) {
        blocks_.push_back(
            {.face = static_cast<Index>(faces_.size() - 1), .row = row, .size = row - 1});
      }
      of_face.edges[2] = edge_block(face[1], face[2]);
    }
  }

  std::vector<Index> block_sizes() const {
    std::vector<Index> sizes;
    for (const Block& block : blocks_) sizes.push_back(block.size);
    return sizes;
  }

  Vec3 position(std::size_t number, Index i) const {
    const Block& block = blocks_[number];
    Eigen::Vector3d direction;
    if (block.row > 0) {
      direction = inner(kIcosahedronFaces[block.face], static_cast<int>(block.row),
                        static_cast<int>(i) + 1);
    } else if (block.is_edge) {
      direction = slerp(icosahedron_corner(block.ends[0]), icosahedron_corner(block.ends[1]),
                        static_cast<double>(i + 1) / n_);
    } else {
      direction = icosahedron_corner(block.corner);
    }
    return (shape_.radius * direction).cast<float>();
  }

  std::size_t strips() const { return faces_.size() * n_; }
  std::size_t triangles_of(std::size_t strip) const { return 2 * row_of(strip) - 1; }

  /// The three corners and edges of the face, and the rows beside the strip.
  std::vector<std::size_t> blocks_of(std::size_t strip) const {
    const Triangle& face = kIcosahedronFaces[strip / n_];
    const FaceBlocks& of_face = faces_[strip / n_];
    std::vector<std::size_t> blocks(face.begin(), face.end());
    blocks.insert(blocks.end(), of_face.edges.begin(), of_face.edges.end());
    for (const Index row : {row_of(strip) - 1, row_of(strip)}) {
      const bool has_inner = row >= 2 && row < n_;
      blocks.push_back(has_inner ? of_face.first_row + row - 2 : blocks.front());
    }
    return blocks;
  }

  /// Between rows row - 1 and row of a face, counted from its corner 0.
  void add_strip(std::size_t strip, std::span<const Index> first,
                 std::vector<Triangle>& triangles) const {
    const Triangle& face = kIcosahedronFaces[strip / n_];
    const Index row = row_of(strip);
    const auto above = [&](Index i) { return vertex(face, first, row - 1, i, first[6]); };
    const auto below = [&](Index i) { return vertex(face, first, row, i, first[7]); };
    for (Index i = 0; i < row; ++i) {
      triangles.push_back({above(i), below(i), below(i + 1)});
      if (i + 1 < row) triangles.push_back({above(i), below(i + 1), above(i + 1)});
    }
  }

 private:
  struct Block {
    Index corner = 0;
    std::array<Index, 2> ends{};  ///< of an edge, the lower number first
    bool is_edge = false;
    Index face = 0, row = 0;  ///< of a row within a face
    Index size = 0;
  };
  struct FaceBlocks {
    std::array<std::size_t, 3> edges{};  ///< from corner 0 to 1, 0 to 2 and 1 to 2
    std::size_t first_row = 0;           ///< row 2
  };

  Index row_of(std::size_t strip) const { return static_cast<Index>(strip % n_) + 1; }

  std::size_t edge_block(Index a, Index b) {
    const std::pair<Index, Index> ends = std::minmax(a, b);
    const auto [place, is_new] = edges_.emplace(ends, blocks_.size());
    if (is_new)
      blocks_.push_back({.ends = {ends.first, ends.second}, .is_edge = true, .size = n_ - 1});
    return place->second;
  }

  /// Vertex i of row `row`, counted from corner 0 to the opposite edge.
  Index vertex(const Triangle& face, std::span<const Index> first, Index row, Index i,
               Index first_of_row) const {
    if (i == 0) return on_edge(face, first, 0, 1, row, first[3]);
    if (i == row) return on_edge(face, first, 0, 2, row, first[4]);
    if (row == n_) return on_edge(face, first, 1, 2, i, first[5]);
    return first_of_row + i - 1;
  }

  Index on_edge(const Triangle& face, std::span<const Index> first, std::size_t a, std::size_t b,
                Index step, Index first_of_edge) const {
    if (step == 0) return first[a];
    if (step == n_) return first[b];
    return first_of_edge + (face[a] < face[b] ? step : n_ - step) - 1;
  }

  /// The mean of the three constructions along great circles, symmetric in the corners.
  Eigen::Vector3d inner(const Triangle& face, int row, int i) const {
    const int n = shape_.resolution;
    const auto corner = [&](int c) { return icosahedron_corner(face[c]); };
    const auto reach = [&](int a, int b, int c, int wb, int wc) {
      const double t = static_cast<double>(wb + wc) / n;
      return slerp(slerp(corner(a), corner(b), t), slerp(corner(a), corner(c), t),
                   static_cast<double>(wc) / (wb + wc));
    };
    const int w0 = n - row, w1 = row - i, w2 = i;
    return (reach(0, 1, 2, w1, w2) + reach(1, 2, 0, w2, w0) + reach(2, 0, 1, w0, w1)).normalized();
  }

  SphereShape shape_;
  Index n_;
  std::vector<Block> blocks_;
  std::vector<FaceBlocks> faces_;
  std::map<std::pair<Index, Index>, std::size_t> edges_;
};

/// The trefoil knot's point and derivative, about two units wide.
constexpr double kTrefoilScale = 1.0 / 3.2;
Eigen::Vector3d trefoil_point(double t) {
  // Centred: the middle of the bounding box is the origin.
  return kTrefoilScale * Eigen::Vector3d(elementary::sin(t) + 2 * elementary::sin(2 * t),
                                         elementary::cos(t) - 2 * elementary::cos(2 * t) + 0.46,
                                         -elementary::sin(3 * t));
}
Eigen::Vector3d trefoil_tangent(double t) {
  return Eigen::Vector3d(elementary::cos(t) + 4 * elementary::cos(2 * t),
                         -elementary::sin(t) + 4 * elementary::sin(2 * t),
                         -3 * elementary::cos(3 * t))
      .normalized();
}

/// A closed curve's points at equal arc length, with rotation-minimizing frames.
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
  // The frame's total rotation is distributed evenly over the rows.
  transport(parameters[0]);
  const double turn = elementary::atan2(normal.dot(tube.binormal[0]), normal.dot(tube.normal[0]));
  for (int row = 0; row < rows; ++row) {
    const double angle = -turn * row / rows;
    const Eigen::Vector3d n = tube.normal[row], b = tube.binormal[row];
    tube.normal[row] = elementary::cos(angle) * n + elementary::sin(angle) * b;
    tube.binormal[row] = elementary::cos(angle) * b - elementary::sin(angle) * n;
  }
  return tube;
}

}  // namespace

StripShape plane_strips(const PlaneShape& shape) {
  const double spacing = static_cast<double>(shape.width) / shape.resolution;
  const int rows = row_count(shape.height, spacing);
  const auto strips = static_cast<std::size_t>(rows);
  return open_lattice(
      shape.resolution, strips + 1, strips, [](std::size_t row) { return row; },
      [](std::size_t strip) { return std::pair(strip, strip + 1); },
      [=](std::size_t row, double at) {
        return point((at - 0.5) * shape.width,
                     (static_cast<double>(row) / rows - 0.5) * shape.height, 0);
      });
}

StripShape cylinder_strips(const CylinderShape& shape) {
  const double spacing = 2 * kPi * shape.radius / shape.resolution;
  return ring_lattice(
      shape.resolution, row_count(shape.height, spacing), false, [=](double u, double v) {
        return point(shape.radius * elementary::cos(2 * kPi * u),
                     shape.radius * elementary::sin(2 * kPi * u), (v - 0.5) * shape.height);
      });
}

StripShape tube_strips(const TubeShape& shape) {
  const double spacing = 2 * kPi * shape.radius / shape.resolution;
  const double turn = shape.bend_deg * kPi / 180;
  const double straight = turn > 1e-9 ? shape.length / turn : 0;  // the arc's radius
  return ring_lattice(
      shape.resolution, row_count(shape.length, spacing), false, [=](double u, double v) {
        const double r = shape.radius * (1 + shape.bulge * elementary::sin(2 * kPi * v)) *
                         (1 + (shape.taper - 1) * v);
        const double out = r * elementary::cos(2 * kPi * u),
                     aside = r * elementary::sin(2 * kPi * u);
        if (straight == 0) return point(out, aside, (v - 0.5) * shape.length);
        const double a = (v - 0.5) * turn;
        return point((straight + out) * elementary::cos(a) - straight, aside,
                     (straight + out) * elementary::sin(a));
      });
}

StripShape sphere_strips(const SphereShape& shape) {
  const auto sphere = std::make_shared<const Icosphere>(shape);
  StripShape strips;
  strips.block_sizes = sphere->block_sizes();
  strips.position = [sphere](std::size_t block, Index i) { return sphere->position(block, i); };
  strips.strips = sphere->strips();
  strips.triangles_of = [sphere](std::size_t strip) { return sphere->triangles_of(strip); };
  strips.blocks_of = [sphere](std::size_t strip) { return sphere->blocks_of(strip); };
  strips.add_strip = [sphere](std::size_t strip, std::span<const Index> first,
                              std::vector<Triangle>& triangles) {
    sphere->add_strip(strip, first, triangles);
  };
  return strips;
}

StripShape torus_strips(const TorusShape& shape) {
  const double R = shape.major, r = shape.minor;
  // psi is conformal to the angle along the major circle: d psi = r d theta / (R + r cos theta).
  const double period = 2 * kPi * r / std::sqrt(R * R - r * r);
  const double spacing = 2 * kPi / shape.resolution;
  return ring_lattice(
      shape.resolution, even_row_count(period, spacing), true, [=](double u, double v) {
        const double theta = 2 * elementary::atan2(std::sqrt(R + r) * elementary::sin(kPi * v),
                                                   std::sqrt(R - r) * elementary::cos(kPi * v));
        const double distance = R + r * elementary::cos(theta);
        return point(distance * elementary::cos(2 * kPi * u),
                     distance * elementary::sin(2 * kPi * u), r * elementary::sin(theta));
      });
}

StripShape trefoil_strips(const TrefoilShape& shape) {
  const auto tube =
      std::make_shared<const Tube>(trefoil_frames(2 * kPi * shape.radius / shape.resolution));
  const auto rows = static_cast<int>(tube->center.size());
  return ring_lattice(shape.resolution, rows, true, [=](double u, double v) {
    const auto row = static_cast<std::size_t>(std::lround(v * rows));
    const double angle = 2 * kPi * u;
    return Vec3((tube->center[row] + shape.radius * (elementary::cos(angle) * tube->normal[row] +
                                                     elementary::sin(angle) * tube->binormal[row]))
                    .cast<float>());
  });
}

// Ring k has 4k vertices: edges along the rim are about as long as the distance of rings.
StripShape hemisphere_strips(const HemisphereShape& shape) {
  const auto rings = static_cast<std::size_t>(shape.resolution);
  const auto size_of = [](std::size_t ring) {
    return std::max<Index>(1, static_cast<Index>(4 * ring));
  };
  StripShape strips;
  for (std::size_t ring = 0; ring <= rings; ++ring) strips.block_sizes.push_back(size_of(ring));
  strips.position = [=](std::size_t ring, Index i) {
    if (ring == 0) return point(0, 0, shape.radius);
    const double polar = 0.5 * kPi * static_cast<double>(ring) / static_cast<double>(rings);
    const double azimuth = 2 * kPi * i / static_cast<double>(4 * ring);
    return point(shape.radius * elementary::sin(polar) * elementary::cos(azimuth),
                 shape.radius * elementary::sin(polar) * elementary::sin(azimuth),
                 ring == rings ? 0.0 : shape.radius * elementary::cos(polar));
  };
  strips.strips = rings;
  strips.triangles_of = [](std::size_t strip) { return 4 * (2 * strip + 1); };
  strips.blocks_of = [](std::size_t strip) { return std::vector<std::size_t>{strip, strip + 1}; };
  strips.add_strip = [=](std::size_t strip, std::span<const Index> first,
                         std::vector<Triangle>& triangles) {
    const auto ring = static_cast<Index>(strip + 1);
    const auto outer = [&](Index i) { return first[1] + i % size_of(ring); };
    const auto inner = [&](Index i) { return first[0] + i % size_of(strip); };
    for (Index quarter = 0; quarter < 4; ++quarter) {
      for (Index i = 0; i < ring; ++i) {
        const Index o = quarter * ring + i, n = quarter * (ring - 1) + i;
        triangles.push_back({inner(n), outer(o), outer(o + 1)});
        if (i + 1 < ring) triangles.push_back({inner(n), outer(o + 1), inner(n + 1)});
      }
    }
  };
  return strips;
}

StripShape mobius_strips(const MobiusShape& shape) {
  const double spacing = static_cast<double>(shape.width) / shape.resolution;
  const int rows = even_row_count(2 * kPi * shape.radius, spacing);
  const auto strips = static_cast<std::size_t>(rows);
  return open_lattice(
      shape.resolution, strips, strips, [](std::size_t row) { return row; },
      [=](std::size_t strip) { return std::pair(strip, (strip + 1) % strips); },
      [=](std::size_t row, double at) {
        const double angle = 2 * kPi * static_cast<double>(row) / rows;
        const double across = (at - 0.5) * shape.width;
        const double distance = shape.radius + across * elementary::cos(angle / 2);
        return point(distance * elementary::cos(angle), distance * elementary::sin(angle),
                     across * elementary::sin(angle / 2));
      });
}

StripShape sheets_strips(const SheetsShape& shape) {
  const double spacing = static_cast<double>(shape.width) / shape.resolution;
  const int edges = std::max(1, static_cast<int>(std::lround(shape.height / spacing)));
  const auto rows = static_cast<std::size_t>(row_count(shape.width, spacing));
  const std::size_t strips = rows * static_cast<std::size_t>(shape.count);
  // Block 0 is the common edge, row 0 of each sheet.
  const auto number_of = [=](std::size_t block) { return block == 0 ? 0 : (block - 1) % rows + 1; };
  return open_lattice(
      edges, strips + 1, strips, number_of,
      [=](std::size_t strip) {
        return std::pair(strip % rows == 0 ? std::size_t{0} : strip, strip + 1);
      },
      [=](std::size_t block, double at) {
        const double height = (at - 0.5) * shape.height;
        if (block == 0) return point(0, 0, height);
        const std::size_t sheet = (block - 1) / rows;
        const double angle = 2 * kPi * static_cast<double>(sheet) / shape.count;
        const double distance =
            shape.width * static_cast<double>(number_of(block)) / static_cast<double>(rows);
        return point(distance * elementary::cos(angle), distance * elementary::sin(angle), height);
      });
}

StripShape pieces_strips(const PiecesShape& shape) {
  // Neighbours on a circle of radius 1 - size are separated by half their size.
  const double half = elementary::sin(kPi / std::max(2, shape.count));
  const double size = shape.count < 2 ? 1.0 : std::min(0.5, half / (1.25 + half));
  const auto radius = static_cast<float>(size);
  const std::array<StripShape, 3> kinds = {
      sphere_strips({.radius = radius, .resolution = shape.resolution}),
      torus_strips({.major = 0.7f * radius,
                    .minor = 0.3f * radius,
                    .resolution = std::max(8, 4 * shape.resolution)}),
      cylinder_strips({.radius = 0.6f * radius,
                       .height = 1.5f * radius,
                       .resolution = std::max(8, 4 * shape.resolution)})};
  std::vector<MovedShape> shapes;
  for (int i = 0; i < shape.count; ++i) {
    const double angle = 2 * kPi * i / shape.count;
    const double distance = shape.count < 2 ? 0.0 : 1 - size;
    shapes.push_back(
        {kinds[static_cast<std::size_t>(i % 3)],
         point(distance * elementary::cos(angle), distance * elementary::sin(angle), 0)});
  }
  return joined_shapes(std::move(shapes));
}

}  // namespace brindle
