/// What `brindle sample` is asked for.
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

enum class SampleOutput { samples, picture, report };

/// What a path asks for. Throws CLI::ValidationError, naming what to do, for what it cannot hold.
SampleOutput planned_sample(const std::string& path);

void add_sample_options(CLI::App& command, SampleArguments& arguments);

/// Throws CLI::ValidationError for options that have no effect on these files, or leave each other
/// without one, and for what cannot be drawn.
void check_sample_options(const CLI::App& command, const SampleArguments& arguments,
                          const PlannedFiles<SampleOutput>& files);

/// The same for what points cannot have, if the mesh's file holds nothing else, which is read for
/// that.
void check_sample_points(const CLI::App& command, const SampleArguments& arguments,
                         const PlannedFiles<SampleOutput>& files);

/// All files that are read.
std::vector<UsedFile> sample_inputs(const SampleArguments& arguments);

}  // namespace brindle::tool
