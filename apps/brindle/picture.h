/// Pictures of a pattern. A build without OpenGL offers none of the options and draws nothing.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "brindle/pipeline/surface.h"
#include "stripe_result.h"

namespace brindle::tool {

struct PictureOptions;

/// The options live as long as the pointer, which must outlive `app.parse`.
std::shared_ptr<PictureOptions> add_picture_options(CLI::App& app);

/// Lets the z axis point up unless the user says otherwise, as the built-in shapes are made.
void stand_on_z(PictureOptions& options);

/// Whether pictures show stripes and nothing on top of them.
bool shows_stripes(const PictureOptions& options);

/// Throws Error in a build without OpenGL.
void check_pictures_available();

/// Throws Error if no OpenGL context is to be had or the file cannot be written.
void write_picture(const std::filesystem::path& path, const Surface& surface,
                   const StripeResult& result, const PictureOptions& options);

/// The texture's tile as the content of a PNG file, in the picture's colours.
std::string tile_png(const TextureTile& tile, const PictureOptions& options);

}  // namespace brindle::tool
