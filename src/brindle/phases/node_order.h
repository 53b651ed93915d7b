/// An order of nodes in which neighbours stand close together.
#pragma once

#include <vector>

#include "brindle/adjacency.h"
#include "brindle/progress.h"

namespace brindle {

/// Breadth-first from the first node of every component: neighbours are at most two fronts apart,
/// whatever order the nodes had before.
std::vector<Index> breadth_first_order(const Adjacency& adjacency, const Progress& progress = {});

}  // namespace brindle
