/// Curves as paths of a tool: in order, joined, with poses, widths and places to cut.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The order of curves.
enum class PathOrder : std::uint8_t {
  nearest,        ///< nearest ends first, then shortened by 2-opt and Or-opt moves
  boustrophedon,  ///< to and fro: goes on at a neighbouring curve while one is left
  layers,  ///< from below upwards, by mean height in steps of half a width; shortened in each
  spiral   ///< the only curve, as `wind` makes it, from its lower to its upper end
};

/// Options of `tool_paths`. Lengths are in units of length; 0 switches an option off.
struct ToolPathOptions {
  PathOrder order = PathOrder::nearest;
  float width = 0;          ///< of the tool's trace where no curve is beside it; above 0
  Vec3 up = Vec3::UnitZ();  ///< for layers and spirals; not zero
  /// Ends up to this far apart are joined along the surface. Empty: two widths, but 0 for spirals
  /// and with `least_radius`, as joins are sharp bends.
  std::optional<float> connect = {};
  float least_radius = 0;  ///< curves are cut where they bend more tightly
  float least_length = 0;  ///< curves that are then shorter are left out
  float cut_length = 0;    ///< from the cutter to the tool; shorter paths are left out
};

/// Metrics of paths, in units of length.
struct ToolPathMetrics {
  std::size_t curves = 0;     ///< after cutting, without those left out
  std::size_t bends_cut = 0;  ///< by `least_radius`
  std::size_t left_out = 0;   ///< too short
  std::size_t joins = 0;      ///< made by `connect`
  double length = 0;          ///< of all paths, with their joins
  double joined_length = 0;   ///< of the joins
  double travel = 0;          ///< straight from path to path
  double travel_nearest = 0;  ///< of nearest ends first, before joins; 0 for one curve
  double least_radius = 0;    ///< of curves without joins; infinite if they are straight
  double least_width = 0, mean_width = 0, most_width = 0;
};

/// Paths in order, and data at each of their points.
struct ToolPaths {
  /// Open lines; closed curves end at their first point. Without places on the mesh.
  Polylines lines;
  float width = 0;                   ///< nominal: that of the options
  std::vector<Vec3> directions;      ///< of travel, unit vectors tangent to the surface
  std::vector<float> widths;         ///< half the distance to both neighbours, at most 2 widths
  std::vector<std::uint8_t> joined;  ///< 1: the segment to the next point is a join
  std::vector<std::uint8_t> cut;     ///< 1: the cutter has passed here already
  ToolPathMetrics metrics;
};

/// Orders curves, joins their ends and measures them.
///
/// Joins are straight ways, laid onto the surface, that cross no curve. Widths are straight
/// distances sideways, on the same side of the surface; a neighbour farther than two widths is
/// none. The radius at a point is that of the circle through it and the points half a width before
/// and after it. Results do not depend on the number of threads or the sense of curves (up to
/// ties), and move with the mesh. Throws Error unless `width` is finite and above 0, for other
/// options below 0 or not finite, for curves without normals, and for a spiral of anything but one
/// open curve. Throws Cancelled if `progress` cancels.
ToolPaths tool_paths(const Mesh& mesh, const Polylines& curves, const ToolPathOptions& options,
                     const Progress& progress = {});

/// Attitudes of the tool as unit quaternions w, x, y, z, one per point, w not negative: they turn x
/// into the direction of travel and z into the surface's normal.
std::vector<Eigen::Vector4f> path_poses(const ToolPaths& paths);

/// Dialects of G-code.
enum class GcodeDialect : std::uint8_t {
  marlin,  ///< for printers: E is the length of filament, relative (M83)
  plain    ///< for mills, robots and plotters (RS-274): no E
};

/// A machine whose Z is up. Lengths are in millimetres, speeds in millimetres per second.
struct Machine {
  GcodeDialect dialect = GcodeDialect::marlin;
  int axes = 3;             ///< 3, or 5 with A and C
  double unit = 1;          ///< millimetres in a unit of length; above 0
  Vec3 up = Vec3::UnitZ();  ///< turned into Z by the smallest rotation; not zero
  /// The place of the middle of the base of the paths' bounding box; empty: nothing moves.
  std::optional<Eigen::Vector3d> place = {};
  double thickness = 0.2;     ///< of the trace, along the normal; above 0
  double filament = 1.75;     ///< its diameter, above 0
  double speed = 30;          ///< above 0; less where paths are wider than nominal
  double travel_speed = 120;  ///< above 0
  double lift = 1;            ///< above all paths; with 5 axes, along the normal; 0 or more
};

/// Amounts of a job.
struct MachineMetrics {
  double seconds = 0;     ///< without acceleration
  double extrusion = 0;   ///< millimetres of filament
  std::size_t lifts = 0;  ///< between paths
};

/// The rotation of directions into the machine's axes.
Eigen::Matrix3d machine_turn(const Machine& machine);

/// Positions in millimetres, of all points in order. Throws Error for a machine out of range.
std::vector<Eigen::Vector3d> machine_points(const ToolPaths& paths, const Machine& machine);

/// Millimetres per second at a point: `speed` times the nominal width over the width there, at most
/// `speed`, so that the flow of material is never above nominal.
double speed_at(const ToolPaths& paths, std::size_t point, const Machine& machine);

/// Millimetres of filament for the segment behind a point: width times thickness times length over
/// the filament's section.
double extrusion_of(const ToolPaths& paths, std::size_t point,
                    std::span<const Eigen::Vector3d> positions, const Machine& machine);

/// Throws Error as `machine_points` does.
MachineMetrics machine_metrics(const ToolPaths& paths, const Machine& machine);

}  // namespace brindle
