/// Patterns on surfaces partitioned over MPI ranks (docs/distributed.md). Needs a build with
/// BRINDLE_MPI.
#pragma once

#include "brindle/communicator.h"
#include "brindle/distributed_pattern.h"
#include "brindle/distributed_stripes.h"
#include "brindle/distributed_surface.h"
#include "brindle/distributed_waves.h"
