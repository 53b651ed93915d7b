/// Spacing tolerance of partitions.
#pragma once

#include <span>

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "input/slack_options.h"
#include "ranks/mesh_pieces.h"

namespace brindle::tool {

/// Collective. Rank 0 reads the file of --avoid-branches, with rows of the whole mesh or, if rank 0
/// read one, of its file, and distributes the rows. Throws on all ranks what `make_slack` and
/// `piece_rows` throw.
Slack piece_slack(Communicator& ranks, const SlackOptions& options, const ReadPiece& read,
                  std::size_t vertices_of_all);

}  // namespace brindle::tool
