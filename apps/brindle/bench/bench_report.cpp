#include "bench/bench_report.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <ostream>

#include "brindle/base/parallel.h"
#include "brindle/base/text.h"
#include "brindle/phases/sliced_kernels.h"
#include "brindle/recipe/report.h"

namespace brindle::tool {
namespace {

using Json = nlohmann::ordered_json;

std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

std::string title_of(const MeshMetrics& mesh) {
  std::string title = mesh.mesh;
  if (mesh.subdivided > 0) title += formatted(", subdivided %d", mesh.subdivided);
  return title;
}

const SolverMetrics* find_solver(const MeshMetrics& mesh, const std::string& name) {
  const SolverMetrics* found = nullptr;
  for (const SolverMetrics& solver : mesh.solvers) {
    if (solver.name == name) found = &solver;  // the last one has the most threads
  }
  return found;
}

Ratio ratio_of(const std::string& name, const Spread& numerator, const Spread& denominator) {
  return {name, "ms", {numerator.median, denominator.median}, {numerator.min, denominator.min}};
}

Spread later_by(const Spread& spread, double milliseconds) {
  return {spread.min + milliseconds, spread.median + milliseconds, spread.repetitions};
}

void add_ratios_of_mesh(const MeshMetrics& mesh, std::vector<Ratio>& ratios) {
  const FrameMetrics& frame = mesh.frames.back();
  const std::string where = formatted(" (%s, threads: %d)", title_of(mesh).c_str(), frame.threads);
  for (const char* name : {"global 20", "global 1", "relaxation 0.02"}) {
    if (const SolverMetrics* solver = find_solver(mesh, name)) {
      ratios.push_back(ratio_of(name + (" / frame" + where), solver->solve, frame.total));
    }
  }
  const SolverMetrics* const global = find_solver(mesh, "global 20");
  if (global != nullptr && mesh.draw) {
    ratios.push_back(
        ratio_of("interactive picture / global 20" + where, mesh.draw->interactive, global->solve));
    ratios.push_back(
        ratio_of("final picture / global 20" + where, mesh.draw->final, global->solve));
  }
  if (global != nullptr) {
    ratios.push_back(ratio_of("global 20 / topology" + where, global->solve, frame.topology));
    ratios.push_back(ratio_of("global 20 / topology, neighbourhood and normals" + where,
                              global->solve,
                              later_by(frame.topology, mesh.neighborhood_milliseconds)));
  }
  ratios.push_back(ratio_of("measure / frame" + where, frame.measure, frame.total));
  if (mesh.slack) {
    ratios.push_back(
        ratio_of("slack from scratch / frame" + where, mesh.slack->from_scratch, frame.total));
    ratios.push_back(
        ratio_of("slack in a frame / frame" + where, mesh.slack->in_frame, frame.total));
  }
  for (std::size_t i = 1; i < mesh.frames.size(); ++i) {
    ratios.push_back(ratio_of(formatted("frame, 1 thread / %d threads (%s)", mesh.frames[i].threads,
                                        title_of(mesh).c_str()),
                              mesh.frames[0].total, mesh.frames[i].total));
  }
}

double per_vertex_ns(double milliseconds, const MeshMetrics& mesh) {
  return 1e6 * milliseconds / static_cast<double>(mesh.vertices);
}

void add_ratios_of_sizes(const MeshMetrics& coarse, const MeshMetrics& fine,
                         std::vector<Ratio>& ratios) {
  for (std::size_t i = 0; i < coarse.frames.size(); ++i) {
    const Spread &of_fine = fine.frames[i].total, &of_coarse = coarse.frames[i].total;
    ratios.push_back(
        {formatted("frame per vertex, %zu / %zu vertices (threads: %d)", fine.vertices,
                   coarse.vertices, coarse.frames[i].threads),
         "ns",
         {per_vertex_ns(of_fine.median, fine), per_vertex_ns(of_coarse.median, coarse)},
         {per_vertex_ns(of_fine.min, fine), per_vertex_ns(of_coarse.min, coarse)}});
  }
}

void add_slack_of_sizes(const MeshMetrics& coarse, const MeshMetrics& fine,
                        std::vector<Ratio>& ratios) {
  if (!coarse.slack || !fine.slack) return;
  const auto add = [&](const char* name, const Spread& of_fine, const Spread& of_coarse) {
    ratios.push_back(
        {formatted("%s per vertex, %zu / %zu vertices (threads: %d)", name, fine.vertices,
                   coarse.vertices, fine.slack->threads),
         "ns",
         {per_vertex_ns(of_fine.median, fine), per_vertex_ns(of_coarse.median, coarse)},
         {per_vertex_ns(of_fine.min, fine), per_vertex_ns(of_coarse.min, coarse)}});
  };
  add("slack from scratch", fine.slack->from_scratch, coarse.slack->from_scratch);
  add("slack in a frame", fine.slack->in_frame, coarse.slack->in_frame);
}

Json to_json(const Spread& spread) {
  return {{"min", spread.min}, {"median", spread.median}, {"repetitions", spread.repetitions}};
}

Json to_json(const Quotient& quotient) {
  return {{"numerator", quotient.numerator},
          {"denominator", quotient.denominator},
          {"ratio", quotient.value()}};
}

Json to_json(const Quality& quality) {
  return {{"energy", quality.energy},
          {"branches", quality.branches},
          {"angle_error_mean_deg", quality.angle_error_mean_deg}};
}

Json to_json(const SolverMetrics& solver) {
  Json json = {{"solver", solver.name},
               {"threads", solver.threads},
               {"iterations", solver.iterations},
               {"milliseconds",
                {{"topology", to_json(solver.topology)},
                 {"couple", to_json(solver.couple)},
                 {"solve", to_json(solver.solve)}}}};
  json.update(to_json(solver.quality));
  return json;
}

Json to_json(const FrameMetrics& frame) {
  Json json = {{"threads", frame.threads},
               {"milliseconds",
                {{"topology", to_json(frame.topology)},
                 {"couple", to_json(frame.couple)},
                 {"sum", to_json(frame.sum)},
                 {"solve", to_json(frame.solve)},
                 {"total", to_json(frame.total)},
                 {"measure", to_json(frame.measure)}}}};
  json.update(to_json(frame.quality));
  return json;
}

Json to_json(const MeshMetrics& mesh) {
  Json json = {{"mesh", mesh.mesh},
               {"subdivided", mesh.subdivided},
               {"kind", mesh.triangles == 0 ? "points" : "mesh"},
               {"vertices", mesh.vertices},
               {"triangles", mesh.triangles},
               {"edges", mesh.edges},
               {"colors", {{"luby", mesh.luby_colors}, {"greedy", mesh.greedy_colors}}},
               {"fields", mesh.fields},
               {"neighborhood_milliseconds", mesh.neighborhood_milliseconds},
               {"solvers", Json::array()},
               {"frames", Json::array()}};
  for (const SolverMetrics& solver : mesh.solvers) json["solvers"].push_back(to_json(solver));
  for (const FrameMetrics& frame : mesh.frames) json["frames"].push_back(to_json(frame));
  if (mesh.draw) {
    json["draw"] = {{"width", mesh.draw->width},
                    {"height", mesh.draw->height},
                    {"milliseconds",
                     {{"visible", to_json(mesh.draw->visible)},
                      {"visible_final", to_json(mesh.draw->visible_final)},
                      {"interactive", to_json(mesh.draw->interactive)},
                      {"final", to_json(mesh.draw->final)}}}};
  }
  for (const SurroundingMetrics& metrics : mesh.surroundings) {
    json["surroundings"].push_back({{"threads", metrics.threads},
                                    {"milliseconds",
                                     {{"texture", to_json(metrics.texture)},
                                      {"whole_tiles", to_json(metrics.whole_tiles)},
                                      {"cross_frame", to_json(metrics.cross_frame)},
                                      {"cross", to_json(metrics.cross)},
                                      {"smooth_field", to_json(metrics.smooth_field)}}}});
  }
  if (mesh.slack) {
    json["slack"] = {{"threads", mesh.slack->threads},
                     {"sweeps_from_scratch", mesh.slack->sweeps_from_scratch},
                     {"sweeps_in_frame", mesh.slack->sweeps_in_frame},
                     {"milliseconds",
                      {{"from_scratch", to_json(mesh.slack->from_scratch)},
                       {"in_frame", to_json(mesh.slack->in_frame)}}}};
  }
  if (mesh.memory) {
    json["memory_bytes"] = {{"neighborhood", mesh.memory->neighborhood},
                            {"animator", mesh.memory->animator},
                            {"animator_peak", mesh.memory->animator_peak},
                            {"sibling", mesh.memory->sibling}};
  }
  return json;
}

double floor_milliseconds(std::size_t bytes, double bandwidth) {
  return 1000 * static_cast<double>(bytes) / bandwidth;
}

std::size_t bytes_of(const GpuFrameMetrics& frame) {
  std::size_t bytes = 0;
  for (const GpuStage& stage : frame.stages) bytes += stage.bytes;
  return bytes;
}

Json to_json(const GpuFrameMetrics& frame, double bandwidth) {
  Json json = {{"dispatches", frame.dispatches},
               {"bytes", bytes_of(frame)},
               {"floor_milliseconds", floor_milliseconds(bytes_of(frame), bandwidth)},
               {"topology_milliseconds", frame.topology_milliseconds},
               {"milliseconds",
                {{"device", to_json(frame.device)},
                 {"wall", to_json(frame.wall)},
                 {"resident", to_json(frame.resident)},
                 {"picture", to_json(frame.picture)}}}};
  for (const GpuStage& stage : frame.stages) {
    json["stages"][stage.name] = {{"milliseconds", to_json(stage.time)}, {"bytes", stage.bytes}};
  }
  json.update(to_json(frame.quality));
  return json;
}

std::string times(const Spread& spread) {
  return formatted("%9.2f %9.2f", spread.min, spread.median);
}

std::string tail(const Quality& quality) {
  return formatted(" %9.6f %8zu %6.2f\n", quality.energy, quality.branches,
                   quality.angle_error_mean_deg);
}

void print_heading(std::ostream& out, const MeshMetrics& mesh) {
  out << formatted("\n%s: %zu vertices, %zu edges, colours: %u (paper: %u), ",
                   title_of(mesh).c_str(), mesh.vertices, mesh.edges, mesh.greedy_colors,
                   mesh.luby_colors)
      << formatted("neighbourhood and normals %.1f ms\n", mesh.neighborhood_milliseconds);
}

void print_solvers(std::ostream& out, const MeshMetrics& mesh) {
  out << "                         topology    couple   solve ms\n"
         "solver           threads       ms        ms       min    median  iterations    energy "
         "branches  angle\n";
  for (const SolverMetrics& solver : mesh.solvers) {
    out << formatted("%-16s %7d %8.1f %9.1f ", solver.name.c_str(), solver.threads,
                     solver.topology.median, solver.couple.median)
        << times(solver.solve) << formatted(" %11d", solver.iterations) << tail(solver.quality);
  }
}

void print_frames(std::ostream& out, const MeshMetrics& mesh) {
  out << "                         topology  couple     sum   solve  total ms\n"
         "                 threads       ms      ms      ms      ms       min    median    energy "
         "branches  angle\n";
  for (const FrameMetrics& frame : mesh.frames) {
    out << formatted("%-16s %7d %8.1f %7.2f %7.2f %7.2f ", "frame", frame.threads,
                     frame.topology.median, frame.couple.median, frame.sum.median,
                     frame.solve.median)
        << times(frame.total) << tail(frame.quality);
  }
  for (const FrameMetrics& frame : mesh.frames) {
    out << formatted("%-16s %7d %33s", "measure a frame", frame.threads, "") << times(frame.measure)
        << '\n';
  }
  if (!mesh.slack) return;
  const auto row = [&](const char* name, const Spread& time, int sweeps) {
    out << formatted("%-16s %7d %33s", name, mesh.slack->threads, "") << times(time)
        << formatted("  %d sweeps\n", sweeps);
  };
  row("slack, scratch", mesh.slack->from_scratch, mesh.slack->sweeps_from_scratch);
  row("slack, frame", mesh.slack->in_frame, mesh.slack->sweeps_in_frame);
}

/// One line per stage, with the lower bound by bytes and bandwidth.
void print_gpu_frames(std::ostream& out, const GpuFrameMetrics& frame, double bandwidth) {
  const auto row = [&](const std::string& name, const Spread& time, std::size_t bytes) {
    out << formatted("%-24s %9.3f %9.3f", name.c_str(), time.min, time.median);
    if (bytes > 0) {
      out << formatted(" %9.3f %8.1f", floor_milliseconds(bytes, bandwidth),
                       1e-6 * static_cast<double>(bytes));
    }
    out << '\n';
  };
  out << "frame on the GPU           min ms    median     floor       MB\n";
  for (const GpuStage& stage : frame.stages) row("  " + stage.name, stage.time, stage.bytes);
  row("all stages", frame.device, bytes_of(frame));
  row("until it has finished", frame.resident, 0);
  row("input from the processor", frame.wall, 0);
  row("picture of 1920 x 1080", frame.picture, 0);
  out << formatted("%zu dispatches; topology %.1f ms, once; energy, branches, angle:",
                   frame.dispatches, frame.topology_milliseconds)
      << tail(frame.quality);
}

void print_draw(std::ostream& out, const MeshMetrics& mesh) {
  if (!mesh.draw) return;
  const DrawMetrics& draw = *mesh.draw;
  const std::string size = formatted("draw, %d x %d", draw.width, draw.height);
  out << formatted("%-58s min ms    median\n", size.c_str());
  const auto row = [&](const char* name, const Spread& spread) {
    out << formatted("  %-56s", name) << times(spread) << '\n';
  };
  row("interactive", draw.interactive);
  row("  of this: which triangle is seen", draw.visible);
  row("final", draw.final);
  row("  of this: which triangle is seen", draw.visible_final);
}

void print_surroundings(std::ostream& out, const MeshMetrics& mesh) {
  for (const SurroundingMetrics& metrics : mesh.surroundings) {
    const auto row = [&](const char* name, const Spread& spread) {
      out << formatted("%-32s %7d %17s", name, metrics.threads, "") << times(spread) << '\n';
    };
    row("texture, in a frame", metrics.texture);
    row("whole tiles, in a frame", metrics.whole_tiles);
    row("crosses, in a frame", metrics.cross_frame);
    row("texture of a cross field", metrics.cross);
    row("smooth field", metrics.smooth_field);
  }
}

void print_memory(std::ostream& out, const MeshMetrics& mesh) {
  if (!mesh.memory) return;
  const MemoryMetrics& memory = *mesh.memory;
  const auto per_vertex = [&](std::size_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(mesh.vertices);
  };
  out << formatted("memory           %.0f bytes a vertex beyond the mesh: neighbour lists %.0f, ",
                   per_vertex(memory.neighborhood + memory.animator),
                   per_vertex(memory.neighborhood))
      << formatted("animator %.0f (while it is built %.0f); a second field %.0f more\n",
                   per_vertex(memory.animator), per_vertex(memory.animator_peak),
                   per_vertex(memory.sibling));
}

void print_ratios(std::ostream& out, const std::vector<Ratio>& ratios) {
  if (ratios.empty()) return;
  out << "\n   of medians                         of minima\n";
  for (const Ratio& ratio : ratios) {
    for (const Quotient& quotient : {ratio.median, ratio.min}) {
      out << formatted("%8.2f = %9.2f / %-8.2f %s", quotient.value(), quotient.numerator,
                       quotient.denominator, ratio.unit.c_str());
    }
    out << "  " << ratio.name << '\n';
  }
}

/// One line per method, as the paper's plots have one curve per method.
void print_figure(std::ostream& out, const BenchReport& report) {
  out << formatted("Figure %d of the paper, fields: %zu\n", report.figure, report.meshes[0].fields)
      << "                                       colours                         ms\n"
         "mesh                                 vertices paper ours  method             min    "
         "median  iterations    energy branches  angle\n";
  for (const MeshMetrics& mesh : report.meshes) {
    const std::string begin = formatted("%-36s %8zu %5u %4u  ", title_of(mesh).c_str(),
                                        mesh.vertices, mesh.luby_colors, mesh.greedy_colors);
    for (const SolverMetrics& solver : mesh.solvers) {
      out << begin << formatted("%-16s", solver.name.c_str()) << times(solver.solve)
          << formatted(" %11d", solver.iterations) << tail(solver.quality);
    }
    if (mesh.gpu_frames) {
      out << begin << formatted("%-16s", "frame") << times(mesh.gpu_frames->wall)
          << formatted(" %11s", "-") << tail(mesh.gpu_frames->quality);
    }
    for (const FrameMetrics& frame : mesh.frames) {
      out << begin << formatted("%-16s", "frame") << times(frame.total) << formatted(" %11s", "-")
          << tail(frame.quality);
    }
  }
}

}  // namespace

Machine this_machine() {
  Machine machine{processor_name(), ThreadLimit::current(), "portable", -1};
#ifdef BRINDLE_HAS_HIGHWAY
  machine.instruction_set = simd::target_name();
#endif
  double load = 0;
  if (getloadavg(&load, 1) == 1) machine.load = load;
  return machine;
}

std::vector<Ratio> ratios_of(const BenchReport& report) {
  std::vector<Ratio> ratios;
  if (report.figure != 0 || report.copy_bandwidth > 0) return ratios;
  for (const MeshMetrics& mesh : report.meshes) add_ratios_of_mesh(mesh, ratios);
  for (std::size_t i = 1; i < report.meshes.size(); ++i) {
    if (report.meshes[i].subdivided == 0) continue;
    add_ratios_of_sizes(report.meshes[i - 1], report.meshes[i], ratios);
    add_slack_of_sizes(report.meshes[i - 1], report.meshes[i], ratios);
  }
  return ratios;
}

Json to_json(const BenchReport& report) {
  const Machine& machine = report.machine;
  Json json = {{"machine",
                {{"processor", machine.processor},
                 {"threads", machine.threads},
                 {"instruction_set", machine.instruction_set},
                 {"load", machine.load}}},
               {"device", report.device},
               {"figure", report.figure},
               {"meshes", Json::array()},
               {"ratios", Json::array()},
               {"notes", report.notes}};
  if (report.copy_bandwidth > 0) json["device"]["copy_bytes_per_second"] = report.copy_bandwidth;
  for (const MeshMetrics& mesh : report.meshes) {
    json["meshes"].push_back(to_json(mesh));
    if (mesh.gpu_frames) {
      json["meshes"].back()["gpu_frames"] = to_json(*mesh.gpu_frames, report.copy_bandwidth);
    }
  }
  for (const Ratio& ratio : ratios_of(report)) {
    json["ratios"].push_back({{"name", ratio.name},
                              {"unit", ratio.unit},
                              {"median", to_json(ratio.median)},
                              {"min", to_json(ratio.min)}});
  }
  return json;
}

void print_bench_report(std::ostream& out, const BenchReport& report) {
  const Machine& machine = report.machine;
  out << formatted("machine: %s, %d thread%s, %s, load before the run ", machine.processor.c_str(),
                   machine.threads, machine.threads == 1 ? "" : "s",
                   machine.instruction_set.c_str())
      << (machine.load < 0 ? "unknown" : formatted("%.1f", machine.load)) << '\n'
      << device_line(report.device);
  if (report.copy_bandwidth > 0) {
    out << formatted("copies    %.1f GB/s, read and written\n", 1e-9 * report.copy_bandwidth);
  }
  if (report.figure != 0) {
    print_figure(out, report);
  } else {
    for (const MeshMetrics& mesh : report.meshes) {
      print_heading(out, mesh);
      print_solvers(out, mesh);
      if (!mesh.frames.empty()) print_frames(out, mesh);
      if (mesh.gpu_frames) print_gpu_frames(out, *mesh.gpu_frames, report.copy_bandwidth);
      print_draw(out, mesh);
      print_surroundings(out, mesh);
      print_memory(out, mesh);
    }
    print_ratios(out, ratios_of(report));
  }
  for (const std::string& note : report.notes) out << "note: " << note << '\n';
}

}  // namespace brindle::tool
