#include "brindle/base/error.h"
#include "picture.h"

namespace brindle::tool {

struct PictureOptions {};

std::shared_ptr<PictureOptions> add_picture_options(CLI::App& /*app*/) {
  return std::make_shared<PictureOptions>();
}

void stand_on_z(PictureOptions& /*options*/) {}

void check_pictures_available() {
  throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
}

void write_picture(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                   const StripePattern& /*pattern*/, const PictureOptions& /*options*/) {
  check_pictures_available();
}

}  // namespace brindle::tool
