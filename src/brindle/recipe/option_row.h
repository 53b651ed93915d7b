/// Rows of the table of options, found by what users type.
#pragma once

#include <string>

#include "brindle/option_table.h"

namespace brindle {

/// The first row of "--name", whatever job it is for. Throws Error if there is none.
const OptionInfo& row_of(const std::string& option);

/// The first one of this kind.
const OptionInfo& row_of(const std::string& option, OptionKind kind);

}  // namespace brindle
