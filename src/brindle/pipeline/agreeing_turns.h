/// Triangles turned round until neighbours run alike.
#pragma once

#include <cstdint>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace brindle {

/// How much a triangle and its neighbour agree: 1 where they run alike, -1 where one of them would
/// have to be turned round, 0 where that does not help.
struct TriangleLink {
  Index neighbor;
  float coupling;
};

/// Which triangles to turn (1) so that as many neighbours as can be run alike. `links` has each
/// link in the rows of both its triangles. Of many triangles whole blocks are turned first, and
/// then single ones around the seams that these leave. Throws Cancelled if `progress` asks for it.
std::vector<std::uint8_t> agreeing_turns(const CompressedRows<TriangleLink>& links,
                                         const Progress& progress = {});

}  // namespace brindle
