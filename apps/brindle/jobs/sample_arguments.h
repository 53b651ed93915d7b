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
#include "outputs/planned_files.h"
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

enum class SampleOutput { samples, picture, report, pieces };

/// The kind of output of a path. Throws CLI::ValidationError with a remedy for files that cannot
/// hold samples.
SampleOutput planned_sample(const std::string& path);

void add_sample_options(CLI::App& command, SampleArguments& arguments);

/// Throws CLI::ValidationError for options without effect on these files or beside other options,
/// and for what cannot be drawn.
void check_sample_options(const CLI::App& command, const SampleArguments& arguments,
                          const PlannedFiles<SampleOutput>& files);

/// The same for options that point clouds do not support; reads the mesh's file if necessary.
void check_sample_points(const CLI::App& command, const SampleArguments& arguments,
                         const PlannedFiles<SampleOutput>& files);

/// All input files.
std::vector<UsedFile> sample_inputs(const SampleArguments& arguments);

}  // namespace brindle::tool
