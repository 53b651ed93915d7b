/// Flips triangles until neighbours are oriented consistently.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// Agreement of two neighbouring triangles. 1: their waves point the same way; -1: one has to be
/// flipped; 0: flipping does not help.
struct TriangleLink {
  Index neighbor;
  float coupling;
};

/// Triangles to flip (1) so that as many neighbours as possible agree. `links` stores each link in
/// the rows of both triangles. Large meshes are solved in blocks first, then triangle by triangle
/// around the remaining seams. Throws Cancelled if `progress` asks for it.
std::vector<std::uint8_t> agreeing_turns(const CompressedRows<TriangleLink>& links,
                                         const Progress& progress = {});

}  // namespace brindle
