#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <sstream>

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/local_positions.h"
#include "brindle/points.h"
#include "brindle/render/parsed_words.h"
#include "cli/commands.h"
#include "cli/progress_display.h"
#include "input/mesh_statistics.h"
#include "input/preparation.h"

namespace brindle::tool {
namespace {

constexpr const char* kInfoExamples = R"(Examples:
  brindle info horse.ply
  brindle info shape:mobius
  brindle info points.csv
  brindle info flow.vtp)";

// Coordinates far from zero need more digits.
std::string coordinates(const Vec3& point, const Eigen::Vector3d& origin) {
  std::ostringstream text;
  if (origin.isZero(0)) {
    text << point.x() << ' ' << point.y() << ' ' << point.z();
  } else {
    const Eigen::Vector3d place = placed(point, origin);
    text.precision(12);
    text << place.x() << ' ' << place.y() << ' ' << place.z();
  }
  return text.str();
}

std::string box_line(const BoundingBox& box, const Eigen::Vector3d& origin) {
  std::ostringstream text;
  text << "bounding box  " << coordinates(box.lower, origin) << " to "
       << coordinates(box.upper, origin) << ", diagonal " << box.diagonal() << '\n';
  return text.str();
}

std::string orientation(const MeshStatistics& statistics) {
  if (!statistics.orientable) return "not orientable";
  return statistics.wound_alike ? "orientable, wound alike" : "orientable, but not wound alike";
}

void print_statistics(std::ostream& out, const Mesh& mesh, const MeshStatistics& statistics) {
  out << "vertices      " << mesh.vertex_count() << '\n'
      << "triangles     " << mesh.triangle_count() << '\n'
      << "edges         " << statistics.edges << ", " << statistics.boundary_edges
      << " on a boundary, " << statistics.non_manifold_edges << " non-manifold\n"
      << "components    " << statistics.components << '\n'
      << "orientation   " << orientation(statistics) << '\n'
      << box_line(statistics.box, mesh.origin) << "edge lengths  " << statistics.edge_length_min
      << " to " << statistics.edge_length_max << ", mean " << statistics.edge_length_mean << '\n'
      << "area          " << statistics.area << '\n';
}

void print_statistics(std::ostream& out, const PointCloud& cloud,
                      const PointStatistics& statistics) {
  out << "points        " << cloud.positions.size() << ", " << statistics.used << " in use\n"
      << "normals       " << (cloud.normals.empty() ? "to be estimated" : "given") << '\n'
      << "neighbours    " << statistics.neighbors_mean << " of a point on average\n"
      << "components    " << statistics.components << '\n'
      << box_line(statistics.box, cloud.origin)  //
      << "spacing       " << statistics.spacing_min << " to " << statistics.spacing_max << ", mean "
      << statistics.spacing_mean << '\n';
}

std::string type_of(const DataArray& array) {
  std::string type(name_of(array.type));
  if (array.components > 1) type += " x " + std::to_string(array.components);
  return type;
}

std::string range_of(const DataArray& array, const ArrayMetrics& metrics) {
  std::ostringstream text;
  if (array.components > 1) text << "length ";
  text << metrics.minimum << " to " << metrics.maximum;
  if (metrics.rows_nan > 0) text << ", NaN in " << metrics.rows_nan << " rows";
  return text.str();
}

// A line per array, in aligned columns.
void print_arrays(std::ostream& out, const std::string& of, std::span<const DataArray> arrays) {
  if (arrays.empty()) return;
  std::size_t name_width = 0, type_width = 0;
  for (const DataArray& array : arrays) {
    name_width = std::max(name_width, shown(array.name).size());
    type_width = std::max(type_width, type_of(array).size());
  }
  out << "arrays of " << of << '\n' << std::left;
  for (const DataArray& array : arrays) {
    out << "  " << std::setw(static_cast<int>(name_width)) << shown(array.name) << "  "
        << std::setw(static_cast<int>(type_width)) << type_of(array) << "  "
        << range_of(array, measure_array(array)) << '\n';
  }
}

/// The axis that points up where this is drawn, which a file's extension may tell.
void print_up(std::ostream& out, const std::string& mesh) {
  const std::optional<UpAxis> usual = usual_up_axis(mesh);
  out << "up            " << name_of(usual.value_or(UpAxis::y)) << " in pictures"
      << (usual && !mesh.starts_with("shape:") ? ", as in most " + lower_extension(mesh) + " files"
                                               : "")
      << "; --up changes it\n";
}

void print_repairs(const std::string& repairs) {
  std::cout << (repairs.empty() ? "nothing had to be repaired\n" : repairs);
}

void run_points(const SurfaceOptions& options) {
  LoadedPoints loaded;
  PointStatistics statistics;
  {
    ProgressDisplay display(false);
    display.stage("loading " + shown(options.mesh));
    loaded = load_points(options);
    display.note(describe_kind(options));
    display.stage("counting");
    const int neighbors = options.neighbors.value_or(kDefaultNeighbors);
    statistics =
        point_statistics(loaded.cloud, point_neighborhood(loaded.cloud.positions, loaded.cloud.used,
                                                          neighbors, display.progress()));
  }
  print_statistics(std::cout, loaded.cloud, statistics);
  print_up(std::cout, options.mesh);
  print_arrays(std::cout, "points", loaded.arrays);
  print_repairs(describe(loaded));
}

void run_mesh(const SurfaceOptions& options) {
  LoadedMesh loaded;
  MeshStatistics statistics;
  {
    ProgressDisplay display(false);
    display.stage("loading " + shown(options.mesh));
    loaded = load_mesh(options, display.progress());
    display.stage("counting");
    statistics = mesh_statistics(loaded.mesh, display.progress());
  }
  print_statistics(std::cout, loaded.mesh, statistics);
  print_up(std::cout, options.mesh);
  print_arrays(std::cout, "points", loaded.arrays.points);
  print_arrays(std::cout, "cells", loaded.arrays.cells);
  print_repairs(describe(loaded));
}

void run_info(const CLI::App& /*command*/, const SurfaceOptions& options) {
  is_points(options) ? run_points(options) : run_mesh(options);
}

void add_info_options(CLI::App& command, SurfaceOptions& arguments) {
  add_surface_options(command, arguments);
  add_point_options(command, arguments);
}

}  // namespace

Command add_info_command(CLI::App& app) {
  return add_command<SurfaceOptions>(app, "info", "What kind of surface a mesh or a point cloud is",
                                     kInfoExamples, add_info_options, run_info);
}

}  // namespace brindle::tool
