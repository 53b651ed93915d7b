/// Requests in the words of the tool's options: the table of options, waves and patterns of a
/// request, arrays of the result. For programs that offer the same options as the tool.
#pragma once

#include "brindle/option_table.h"
#include "brindle/pattern_arrays.h"
#include "brindle/pattern_of.h"
#include "brindle/waves_of.h"
