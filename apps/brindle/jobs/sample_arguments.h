/// Arguments of `brindle sample`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "input/second_waves.h"
#include "input/solving_options.h"
#include "input/surface_options.h"
#include "input/wave_options.h"
#include "outputs/outputs.h"
#include "pictures/glyph_options.h"
#include "pictures/picture.h"

namespace brindle::tool {

struct SampleArguments {
  SurfaceOptions surface;
  WaveOptions waves;
  SecondWaveOptions second;
  SolvingOptions solving;
  std::shared_ptr<PictureOptions> picture;
  GlyphOptions glyphs;
  float min_distance = 0.25f;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
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
