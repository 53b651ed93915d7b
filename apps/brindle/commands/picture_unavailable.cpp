#include "brindle/error.h"
#include "cli/commands.h"
#include "jobs/moving_picture.h"
#include "pictures/glyph_options.h"
#include "pictures/picture.h"
#include "pictures/styled_output.h"
#include "pictures/texture_options.h"

namespace brindle::tool {

struct PictureOptions {};

std::shared_ptr<PictureOptions> add_picture_options(CLI::App& /*app*/) {
  return std::make_shared<PictureOptions>();
}

std::shared_ptr<PictureOptions> add_camera_options(CLI::App& app) {
  return add_picture_options(app);
}

Command add_render_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Draw a session: not in this build");
  command->prefix_command();
  return {command, check_pictures_available};
}

void stand_on_z(PictureOptions& /*options*/) {}

std::optional<Viewpoint> viewpoint_of(const PictureOptions& /*options*/) { return std::nullopt; }

bool shows_stripes(const PictureOptions& /*options*/) { return true; }

std::string_view quality_name(const PictureOptions& /*options*/) { return "final"; }

void check_pictures_available() {
  throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
}

void write_picture(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                   const StripeResult& /*result*/, const PictureOptions& /*options*/,
                   const Progress& /*progress*/) {
  check_pictures_available();
}

std::string tile_png(const TextureTile& /*tile*/, const PictureOptions& /*options*/) {
  check_pictures_available();
  return {};
}

void add_texture_options(CLI::App& /*app*/, TextureChoice& /*choice*/, WaveOptions& /*waves*/) {}

std::optional<TextureTile> chosen_tile(const TextureChoice& /*choice*/, bool /*cross*/) {
  return std::nullopt;
}

WholeTiles::WholeTiles(std::optional<bool> asked) : asked_(asked) {}

std::shared_ptr<const BrokenTiles> Texture::broken(const Mesh& /*mesh*/) const { return nullptr; }

void write_ornaments(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                     std::span<const Ornament> /*ornaments*/, const PictureOptions& /*options*/,
                     const Progress& /*progress*/) {
  check_pictures_available();
}

void write_line_drawing(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                        std::span<const FamilyLines> /*families*/,
                        const PictureOptions& /*options*/, const Progress& /*progress*/) {
  check_pictures_available();
}

void add_style_options(CLI::App& /*app*/, StyleOptions& /*options*/) {}

void add_flow_option(CLI::App& /*app*/, StyleOptions& /*options*/) {}

bool is_styled(const CLI::App& /*command*/) { return false; }

void refuse_style_options(const CLI::App& /*command*/, std::string_view /*why*/) {}

void check_style_options(const CLI::App& /*command*/, const StyleOptions& /*options*/,
                         bool /*texture*/) {}

void refuse_for_outlines(const CLI::App& /*command*/) {}

std::vector<UsedFile> style_files(const StyleOptions& /*options*/) { return {}; }

StyleInput read_style_input(const StyleOptions& /*style*/, const Preparation& /*prepared*/,
                            const WaveSet& /*drawn*/, const SurfaceOptions& /*surface*/,
                            const WaveOptions& /*waves*/, const PictureOptions& /*picture*/,
                            JobListener& /*listener*/) {
  return {};
}

StylePatterns make_style_patterns(const Surface& /*surface*/, const StripeResult& /*result*/,
                                  const StyleOptions& /*style*/, StyleInput& /*input*/,
                                  const StripeOptions& /*solving*/, const Progress& /*progress*/) {
  return {};
}

void write_styled_picture(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                          const StripeResult& /*result*/, const StylePatterns& /*patterns*/,
                          const StyleOptions& /*style*/, const StyleInput& /*input*/,
                          const PictureOptions& /*picture*/, const Progress& /*progress*/) {
  check_pictures_available();
}

void add_glyph_options(CLI::App& /*app*/, GlyphOptions& /*options*/) {}

bool has_glyphs(const CLI::App& /*command*/) { return false; }

void refuse_glyph_options(const CLI::App& /*command*/, std::string_view /*why*/) {}

void check_glyph_options(const CLI::App& /*command*/, const GlyphOptions& /*options*/) {}

std::vector<UsedFile> glyph_files(const GlyphOptions& /*options*/) { return {}; }

std::optional<Image> read_glyph_picture(const GlyphOptions& /*options*/) { return std::nullopt; }

GlyphInput read_glyph_input(const GlyphOptions& /*options*/, const Preparation& /*prepared*/,
                            const SurfaceOptions& /*surface*/, const WaveOptions& /*waves*/,
                            const PictureOptions& /*picture*/) {
  return {};
}

void write_glyphs(const std::filesystem::path& /*path*/, const Surface& /*surface*/,
                  std::span<const Sample> /*samples*/, const GlyphOptions& /*options*/,
                  const GlyphInput& /*input*/, const PictureOptions& /*picture*/,
                  const Progress& /*progress*/) {
  check_pictures_available();
}

struct MovingPicture::State {};

MovingPicture::MovingPicture(std::vector<FrameOutput> /*outputs*/,
                             const PictureOptions& /*options*/, int /*frames_per_second*/,
                             bool /*own_context*/, const FrameStyle* /*style*/) {
  check_pictures_available();
}

MovingPicture::~MovingPicture() = default;

std::string MovingPicture::add(const SolvedFrame& /*frame*/) { return ""; }

void MovingPicture::finish() {}

}  // namespace brindle::tool
