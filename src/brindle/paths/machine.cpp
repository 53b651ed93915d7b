#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/error.h"
#include "brindle/local_positions.h"
#include "brindle/tool_paths.h"

namespace brindle {
namespace {

void check_machine(const Machine& machine) {
  for (const double amount :
       {machine.unit, machine.thickness, machine.filament, machine.speed, machine.travel_speed}) {
    if (amount > 0 && std::isfinite(amount)) continue;
    throw Error("lengths and speeds of a machine must be finite numbers above 0");
  }
  if (!(machine.lift >= 0) || !std::isfinite(machine.lift)) {
    throw Error("the lift of a machine must be a finite number of 0 or more");
  }
  if (machine.axes != 3 && machine.axes != 5) throw Error("a machine has 3 or 5 axes");
  if (!(machine.up.norm() > 0)) throw Error("the direction that is up must not be zero");
}

}  // namespace

Eigen::Matrix3d machine_turn(const Machine& machine) {
  return Eigen::Quaterniond::FromTwoVectors(machine.up.cast<double>(), Eigen::Vector3d::UnitZ())
      .toRotationMatrix();
}

std::vector<Eigen::Vector3d> machine_points(const ToolPaths& paths, const Machine& machine) {
  check_machine(machine);
  const Eigen::Matrix3d turn = machine.unit * machine_turn(machine);
  std::vector<Eigen::Vector3d> positions;
  Eigen::AlignedBox3d box;
  for (const Vec3& point : paths.lines.points) {
    positions.emplace_back(turn * placed(point, paths.lines.origin));
    box.extend(positions.back());
  }
  if (!machine.place || positions.empty()) return positions;
  Eigen::Vector3d base = box.center();
  base.z() = box.min().z();
  for (Eigen::Vector3d& position : positions) position += *machine.place - base;
  return positions;
}

double speed_at(const ToolPaths& paths, std::size_t point, const Machine& machine) {
  return machine.speed * static_cast<double>(std::min(1.0f, paths.width / paths.widths[point]));
}

double extrusion_of(const ToolPaths& paths, std::size_t point,
                    std::span<const Eigen::Vector3d> positions, const Machine& machine) {
  const double width =
      static_cast<double>(paths.widths[point] + paths.widths[point + 1]) / 2 * machine.unit;
  const double section = std::numbers::pi / 4 * machine.filament * machine.filament;
  return width * machine.thickness * (positions[point + 1] - positions[point]).norm() / section;
}

MachineMetrics machine_metrics(const ToolPaths& paths, const Machine& machine) {
  const std::vector<Eigen::Vector3d> positions = machine_points(paths, machine);
  MachineMetrics metrics;
  const Polylines& lines = paths.lines;
  metrics.lifts = lines.count() > 1 ? lines.count() - 1 : 0;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const std::size_t begin = lines.offsets[line], last = lines.offsets[line + 1] - 1;
    for (std::size_t i = begin; i < last; ++i) {
      metrics.seconds += (positions[i + 1] - positions[i]).norm() / speed_at(paths, i, machine);
      metrics.extrusion += extrusion_of(paths, i, positions, machine);
    }
    if (line == 0) continue;
    const double travel = (positions[begin] - positions[begin - 1]).norm() + 2 * machine.lift;
    metrics.seconds += travel / machine.travel_speed;
  }
  return metrics;
}

}  // namespace brindle
