/// Sizes of pictures, in pixels or on paper.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "brindle/renderer.h"

namespace brindle::tool {

struct PictureOptions;

/// --size in pixels.
void set_pixel_size(RenderOptions& render, const std::string& option, const std::string& text);

/// --size in pixels or, for commands with --dpi, in mm, cm or in.
void set_size(const CLI::App& command, PictureOptions& options, const std::string& option,
              const std::string& text);

/// Millimetres on paper for each unit of length, from "MM:UNITS".
float parse_scale(const std::string& option, const std::string& text);

/// Sets the pixels and the visible height of a picture that is measured on paper.
void set_paper(RenderOptions& render, const PictureOptions& options);

/// Throws CLI::ValidationError for options of paper that contradict each other, or that pictures
/// (.png) or drawings, if written, cannot follow.
void check_paper_options(const CLI::App& command, const PictureOptions& options, bool pictures,
                         bool drawings);

}  // namespace brindle::tool
