/// How far the frequencies of a piece may yield.
#pragma once

#include <span>

#include "brindle/communicator.h"
#include "brindle/distributed_surface.h"
#include "input/slack_options.h"
#include "mesh_pieces.h"

namespace brindle::tool {

/// Collective. Rank 0 reads the file of --calm, whose rows are those of the whole mesh, or of its
/// file where rank 0 has read one, and tells the others what it says of their vertices. Throws on
/// all ranks what `make_slack` and `piece_rows` throw.
Slack piece_slack(Communicator& ranks, const SlackOptions& options, const ReadPiece& read,
                  std::size_t vertices_of_all);

}  // namespace brindle::tool
