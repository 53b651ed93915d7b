/// Command lines of `brindle stripe`, `curves` and `sample` as sessions.
#pragma once

#include <string>
#include <vector>

#include "session/session_document.h"

namespace brindle::tool {

/// The document of "stripe MESH --stripes 60 --camera 30,20", a word each, whose picture is that of
/// the command. Throws Error or CLI::ValidationError for what sessions do not have.
SessionDocument document_of_words(const std::vector<std::string>& words);

}  // namespace brindle::tool
