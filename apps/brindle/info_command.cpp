#include <iostream>
#include <memory>
#include <sstream>

#include "commands.h"
#include "mesh_statistics.h"
#include "progress_display.h"
#include "surface_options.h"

namespace brindle::tool {
namespace {

constexpr const char* kExamples = R"(Examples:
  brindle info horse.ply
  brindle info shape:mobius)";

std::string coordinates(const Vec3& point) {
  std::ostringstream text;
  text << point.x() << ' ' << point.y() << ' ' << point.z();
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
      << "bounding box  " << coordinates(statistics.box.lower) << " to "
      << coordinates(statistics.box.upper) << ", diagonal " << statistics.box.diagonal() << '\n'
      << "edge lengths  " << statistics.edge_length_min << " to " << statistics.edge_length_max
      << ", mean " << statistics.edge_length_mean << '\n'
      << "area          " << statistics.area << '\n';
}

void run(const SurfaceOptions& options) {
  LoadedMesh loaded;
  MeshStatistics statistics;
  {
    ProgressDisplay display(false);
    display.stage("loading " + options.mesh);
    loaded = load_mesh(options);
    display.stage("counting");
    statistics = mesh_statistics(loaded.mesh);
  }
  print_statistics(std::cout, loaded.mesh, statistics);
  const std::string repairs = describe(loaded.repair);
  std::cout << (repairs.empty() ? "nothing had to be repaired\n" : repairs);
}

}  // namespace

Command add_info_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "What kind of surface a mesh is");
  command->footer(kExamples);
  const auto options = std::make_shared<SurfaceOptions>();
  add_surface_options(*command, *options);
  return {command, [options] { run(*options); }};
}

}  // namespace brindle::tool
