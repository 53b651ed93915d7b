#include "cli/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "brindle/base/text.h"
#include "brindle/error.h"

namespace brindle::tool {

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  std::string name = (place / "brindle-XXXXXX").string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw Error("no temporary folder can be made in '" + shown(place.native()) +
                "'; set TMPDIR to a folder that can be written to");
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace brindle::tool
