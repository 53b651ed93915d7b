/// Converts command lines of `brindle stripe`, `curves` and `sample` to sessions.
#pragma once

#include <string>
#include <vector>

#include "session/session_document.h"

namespace brindle::tool {

/// The document of the words "stripe MESH --stripes 60 --camera 30,20"; its picture is that of the
/// command. Throws Error or CLI::ValidationError for options that sessions do not have.
SessionDocument document_of_words(const std::vector<std::string>& command_line);

}  // namespace brindle::tool
