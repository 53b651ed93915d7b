/// The lowest of descents from several starts: for fields on surfaces with symmetry, whose energy
/// has many minima far apart (docs/method.md, "Direction fields as phase graphs").
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/progress.h"

namespace brindle {

/// The energy that descents lower: that of the edges, plus |T_i| - Re(conj(z_i) T_i) a slot for
/// anchors. The weight is that of the edges.
EnergySums lowered_sums(const Level& level, std::span<const Complex> z);

/// Whether a minimum replaces that of the plain descent: if it is lower by a tenth, and by more
/// than rounding. Smaller gains do not count, so that nearly equal surfaces get the same field.
bool is_much_lower(const EnergySums& found, const EnergySums& plain);

/// As `descend`, from the lowest of several starts. A start is a random peak or trough at every
/// node of a level of few nodes, the same in every run and for any signs of directions. Starts are
/// compared on a small level.
void descend_from_lowest(Hierarchy& hierarchy, int sweeps, const Progress& progress = {});

/// Descends from one start (`descend`) and from the lowest of several. Keeps the phases of the
/// former unless those of the latter are much lower; returns whether they are.
bool descend_from_several(Hierarchy& hierarchy, int sweeps, const Progress& progress = {});

enum class Starts { one, several };

/// The starts for a direction field. Several are used only where equally smooth fields can be told
/// apart by their curl: with triangles, and with normals on one side. Elsewhere rounding would
/// decide.
Starts starts_of_field(const PhaseGraph& graph, bool has_triangles);

struct LowestPhases {
  std::vector<Complex> z;  ///< one per node
  bool is_lower = false;   ///< whether they come from another start than that of `descend`
};

/// The phases of a graph after a descent from one start or from several, and then cycles. Throws
/// Cancelled if `progress` asks for it, as the functions above do.
LowestPhases solve_from(Starts starts, const PhaseGraph& graph, int sweeps, int cycles,
                        const Progress& progress = {});

}  // namespace brindle
