#include "brindle/base/error.h"
#include "moving_picture.h"
#include "picture.h"

namespace brindle::tool {

struct PictureOptions {};

std::shared_ptr<PictureOptions> add_picture_options(CLI::App& /*app*/) {
  return std::make_shared<PictureOptions>();
}

std::shared_ptr<PictureOptions> add_camera_options(CLI::App& app) {
  return add_picture_options(app);
}

void stand_on_z(PictureOptions& /*options*/) {}

void check_pictures_available() {
  throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
}

void write_picture(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                   const StripePattern& /*pattern*/, const PictureOptions& /*options*/) {
  check_pictures_available();
}

void write_ornaments(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                     std::span<const Ornament> /*ornaments*/, const PictureOptions& /*options*/) {
  check_pictures_available();
}

void write_line_drawing(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                        std::span<const PenLines> /*pens*/, const PictureOptions& /*options*/) {
  check_pictures_available();
}

struct MovingPicture::State {};

MovingPicture::MovingPicture(FrameOutput /*output*/, const PictureOptions& /*options*/,
                             int /*frames_per_second*/) {
  check_pictures_available();
}

MovingPicture::~MovingPicture() = default;

void MovingPicture::add(const SceneFrame& /*frame*/, std::span<const Complex> /*z*/,
                        std::span<const CornerPhases> /*corners*/) {}

void MovingPicture::finish() {}

}  // namespace brindle::tool
