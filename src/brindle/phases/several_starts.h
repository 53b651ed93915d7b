/// The lowest of several descents, for fields on symmetric surfaces, whose energy has many minima
/// far apart (docs/method.md, "Direction fields as phase graphs").
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/progress.h"

namespace brindle {

/// The energy that descents minimise: that of the edges, plus |T_i| - Re(conj(z_i) T_i) per slot
/// for anchors. The weight is that of the edges.
EnergySums lowered_sums(const Level& level, std::span<const Complex> z);

/// Whether a minimum replaces that of the plain descent: it must be lower by a tenth, and by more
/// than rounding. Smaller gains are ignored so that nearly equal surfaces get the same field.
bool is_much_lower(const EnergySums& found, const EnergySums& plain);

/// As `descend`, but from the lowest of several starts, compared on a small level. A start is a
/// random peak or trough per node of a coarse level, equal in every run and for any signs of
/// directions.
void descend_from_lowest(Hierarchy& hierarchy, int sweeps, const Progress& progress = {});

/// Descends from one start (`descend`) and from the lowest of several. Keeps the phases of the
/// first descent unless those of the second are much lower; returns whether they are.
bool descend_from_several(Hierarchy& hierarchy, int sweeps, const Progress& progress = {});

/// How many starts descents have.
enum class Starts { one, several };

/// The starts for a direction field. Several starts need triangles and normals on one side: only
/// then does the curl distinguish equally smooth fields. Otherwise rounding would decide.
Starts starts_of_field(const PhaseGraph& graph, bool has_triangles);

/// The result of `solve_from`.
struct LowestPhases {
  std::vector<Complex> z;  ///< one per node
  bool is_lower = false;   ///< whether they come from a start other than that of `descend`
};

/// The phases of a graph after a descent from one start or from several, and `cycles` cycles.
/// Throws Cancelled if `progress` cancels, as the functions above do.
LowestPhases solve_from(Starts starts, const PhaseGraph& graph, int sweeps, int cycles,
                        const Progress& progress = {});

}  // namespace brindle
