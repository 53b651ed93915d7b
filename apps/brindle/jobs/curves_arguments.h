/// What `brindle curves` is asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/option_values.h"
#include "input/making_options.h"
#include "input/second_waves.h"
#include "input/solving_options.h"
#include "input/surface_options.h"
#include "input/wave_options.h"
#include "outputs/planned_files.h"
#include "pictures/picture.h"

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
  float trim = 0, fair = 0;
  Length min_length;
  std::optional<Length> line_width;
  std::vector<std::string> outputs;
  std::string report;
  bool quiet = false;
};

enum class CurveOutput { lines, tubes, drawing, picture, report };

/// Those that lines of many processes have, too: --lines, --min-length, --offset; --line-width;
/// --join and --trim; --simplify and --resample; --tube-radius and --tube-sides.
void add_lines_option(CLI::App& command, TracedWaves& traced);
void add_min_length_option(CLI::App& command, Length& min_length);
void add_offset_option(CLI::App& command, float& offset);

void add_line_width_option(CLI::App& command, std::optional<Length>& line_width);
void add_end_options(CLI::App& command, bool& join, float& trim);
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
