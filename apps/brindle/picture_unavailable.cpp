#include "brindle/error.h"
#include "moving_picture.h"
#include "picture.h"
#include "texture_options.h"

namespace brindle::tool {

struct PictureOptions {};

std::shared_ptr<PictureOptions> add_picture_options(CLI::App& /*app*/) {
  return std::make_shared<PictureOptions>();
}

std::shared_ptr<PictureOptions> add_camera_options(CLI::App& app) {
  return add_picture_options(app);
}

void stand_on_z(PictureOptions& /*options*/) {}

bool shows_stripes(const PictureOptions& /*options*/) { return true; }

void check_pictures_available() {
  throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
}

void write_picture(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                   const StripeResult& /*result*/, const PictureOptions& /*options*/) {
  check_pictures_available();
}

std::string tile_png(const TextureTile& /*tile*/, const PictureOptions& /*options*/) {
  check_pictures_available();
  return {};
}

void add_texture_options(CLI::App& /*app*/, TextureChoice& /*choice*/, WaveOptions& /*waves*/,
                         CLI::Option* /*cross*/) {}

std::optional<TextureTile> chosen_tile(const TextureChoice& /*choice*/, bool /*cross*/) {
  return std::nullopt;
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

MovingPicture::MovingPicture(std::vector<FrameOutput> /*outputs*/,
                             const PictureOptions& /*options*/, int /*frames_per_second*/,
                             bool /*own_context*/) {
  check_pictures_available();
}

MovingPicture::~MovingPicture() = default;

void MovingPicture::add(const SolvedFrame& /*frame*/) {}

void MovingPicture::finish() {}

}  // namespace brindle::tool
