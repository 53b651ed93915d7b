/// What `brindle curves` is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "making_options.h"
#include "option_values.h"
#include "picture.h"
#include "planned_files.h"
#include "second_waves.h"
#include "solving_options.h"
#include "surface_options.h"
#include "wave_options.h"

namespace brindle::tool {

enum class TracedWaves { u, v, both };

/// How lines are written.
struct LineShape {
  std::optional<Length> simplify, resample, tube_radius;
  int tube_sides = 8;
};

struct CurvesArguments : LineShape {
  SurfaceOptions surface;
  WaveOptions waves;
  SecondWaveOptions second;
  SolvingOptions solving;
  MakingOptions making;
  std::shared_ptr<PictureOptions> picture;
  TracedWaves traced = TracedWaves::u;
  float offset = 0;
  bool join = false;
  Length min_length;
  std::optional<Length> line_width;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

enum class CurveOutput { lines, tubes, drawing, picture, report };

/// Those that lines of many processes have, too: --lines, --min-length, --offset; --simplify and
/// --resample; --tube-radius and --tube-sides.
void add_lines_option(CLI::App& command, TracedWaves& traced);
void add_min_length_option(CLI::App& command, Length& min_length);
void add_offset_option(CLI::App& command, float& offset);

void add_join_option(CLI::App& command, bool& join);
void add_line_shape_options(CLI::App& command, LineShape& shape);
void add_tube_options(CLI::App& command, LineShape& shape);

void add_curves_options(CLI::App& command, CurvesArguments& arguments);

/// Throws CLI::ValidationError for options that have no effect on these files, or leave each other
/// without one.
void check_curves_options(const CLI::App& command, const CurvesArguments& arguments,
                          const PlannedFiles<CurveOutput>& files);

/// Throws Error if the mesh's file holds points alone, and reads it for that.
void check_curves_points(const CurvesArguments& arguments);

/// All files that are read.
std::vector<UsedFile> curves_inputs(const CurvesArguments& arguments);

}  // namespace brindle::tool
