/// Pictures of a pattern.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/polylines.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "input/viewpoint.h"
#include "pictures/stripe_result.h"

namespace brindle::tool {

struct PictureOptions;

/// The share of drawing in a picture that is drawn and written.
inline constexpr double kDrawn = 0.7;

/// The options live as long as the pointer, which must outlive `app.parse`.
std::shared_ptr<PictureOptions> add_picture_options(CLI::App& app);

/// The same without what only stripes have: --view and --stripe-width.
std::shared_ptr<PictureOptions> add_camera_options(CLI::App& app);

/// --size and --quality alone.
std::shared_ptr<PictureOptions> add_size_options(CLI::App& app);

/// Lets the axis point up that `usual_up_axis` gives, unless the user says otherwise.
void stand_upright(PictureOptions& options, const std::string& mesh);

/// Where pictures are taken from. For patterns, which are those of the whole surface: without a
/// slice.
std::optional<Viewpoint> viewpoint_of(const PictureOptions& options);

/// The same for what a picture alone has, with its slice, which shows inner sides.
Viewpoint seen_viewpoint_of(const PictureOptions& options);

/// Whether pictures show stripes and nothing on top of them.
bool shows_stripes(const PictureOptions& options);

/// What reports say of pictures: their quality and the axis that points up.
nlohmann::ordered_json picture_json(const PictureOptions& options);

/// What is drawn on a surface in one colour: tubes along curves, discs at samples.
struct Ornament {
  Mesh mesh;
  bool second = false;  ///< in the colour of the second pattern
};

/// Throws Error if no OpenGL context is to be had or the file cannot be written; Cancelled if
/// `progress` asks for it.
void write_ornaments(const std::filesystem::path& path, const Surface& surface,
                     std::span<const Ornament> ornaments, const PictureOptions& options,
                     const Progress& progress);

/// The lines of one pattern.
struct FamilyLines {
  std::string name;
  const Polylines& lines;
  bool second = false;  ///< in the colour of the second pattern
};

/// Draws what is seen of lines from the picture's camera, and of the surface's outline, as SVG.
/// Throws Error if the picture is too large or the file cannot be written; Cancelled if `progress`
/// asks for it.
void write_line_drawing(const std::filesystem::path& path, const Surface& surface,
                        std::span<const FamilyLines> families, const PictureOptions& options,
                        const Progress& progress);

/// Throws Error if no OpenGL context is to be had or the file cannot be written; Cancelled if
/// `progress` asks for it.
void write_picture(const std::filesystem::path& path, const Surface& surface,
                   const StripeResult& result, const PictureOptions& options,
                   const Progress& progress);

/// The texture's tile as the content of a PNG file, in the picture's colours.
std::string tile_png(const TextureTile& tile, const PictureOptions& options);

}  // namespace brindle::tool
