/// Descents from several starts, of which the lowest counts: for fields on surfaces with symmetry,
/// whose energy has many minima far apart (docs/method.md, "Direction fields as phase graphs").
#pragma once

#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/progress.h"

namespace brindle {

/// What a descent lowers: the energy over the edges, to which the anchors add |T_i| - Re(conj(z_i)
/// T_i) a slot. The weight is that of the edges.
EnergySums lowered_sums(const Level& level, std::span<const Complex> z);

/// Whether one minimum is so much lower than that of the plain descent that it replaces it: by a
/// tenth, and by more than rounding. What is hardly lower does not, so that surfaces that hardly
/// differ get the same field.
bool is_much_lower(const EnergySums& found, const EnergySums& plain);

/// As `descend`, from the lowest of several starts. Each is a peak or a trough at every node of a
/// level of few nodes, by chance (the same in every run), so that it does not depend on how
/// directions are signed. Which is lowest is told on a small level.
void descend_from_lowest(Hierarchy& hierarchy, int sweeps, const Progress& progress = {});

/// Descends from one start (`descend`) and from the lowest of several; keeps the phases of the
/// former unless those of the latter are much lower. Returns whether they are.
bool descend_from_several(Hierarchy& hierarchy, int sweeps, const Progress& progress = {});

enum class Starts { one, several };

/// Those of a direction field. Which of several equally smooth ones is found would depend on
/// rounding where they cannot be turned to the least curl: without triangles, and with normals to
/// both sides.
Starts starts_of_field(const PhaseGraph& graph, bool has_triangles);

struct LowestPhases {
  std::vector<Complex> z;  ///< one per node
  bool is_lower = false;   ///< whether they come from another start than those of `descend`
};

/// The phases of a graph after a descent from one start or from several, and so many cycles.
LowestPhases solve_from(Starts starts, const PhaseGraph& graph, int sweeps, int cycles,
                        const Progress& progress = {});

}  // namespace brindle
