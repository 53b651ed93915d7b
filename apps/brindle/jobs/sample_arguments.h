/// Arguments of `brindle sample`.
#pragma once

#include <vector>

#include <CLI/CLI.hpp>

#include "input/second_waves.h"
#include "outputs/outputs.h"
#include "pictures/glyph_options.h"

namespace brindle::tool {

struct SampleArguments : JobArguments {
  SecondWaveOptions second;
  GlyphOptions glyphs;
  float min_distance = 0.25f;
};

/// The kind of output of a path. Throws CLI::ValidationError with a remedy for files that cannot
/// hold samples.
OutputKind planned_sample(const std::filesystem::path& path);

void add_sample_options(CLI::App& command, SampleArguments& arguments);

/// Throws CLI::ValidationError for options without effect on these files or beside other options,
/// and for what cannot be drawn.
void check_sample_options(const CLI::App& command, const SampleArguments& arguments,
                          const Outputs& outputs);

/// The same for options that point clouds do not support; reads the mesh's file if necessary.
void check_sample_points(const CLI::App& command, const SampleArguments& arguments,
                         const Outputs& outputs);

/// All input files.
std::vector<UsedFile> sample_inputs(const SampleArguments& arguments);

}  // namespace brindle::tool
