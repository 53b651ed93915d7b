/// The table of pattern options: their names, syntax, meaning and values. Command lines, windows,
/// other languages and the documentation are generated from it. Experimental: rows and fields may
/// still change.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "brindle/export.h"

namespace BRINDLE_EXPORT brindle {

/// The syntax of an option's value.
enum class OptionKind : std::uint8_t {
  flag,     ///< given or not: no value
  choice,   ///< one of the words of `form`
  whole,    ///< a whole number
  number,   ///< a number
  numbers,  ///< two numbers: "A..B", or as `form` has them
  length,   ///< a length in the mesh's units, or "P%" of the diagonal of its bounding box
  text      ///< as `form` describes: a file, a name, a vector
};

/// Jobs that options apply to, as a set of bits.
enum class PatternJob : std::uint8_t {
  stripe = 1,
  curves = 2,
  sample = 4,
  animate = 8,
  compare = 16,
  paths = 32,
  relief = 64
};

/// The stages that a change of an option makes stale, as a set of bits; all later stages are stale,
/// too.
enum class OptionStage : std::uint8_t {
  none = 0,     ///< output files and the number of threads
  surface = 1,  ///< the mesh
  field = 2,    ///< the direction field, which takes long
  waves = 4,    ///< turns and frequencies of the field
  second = 8,   ///< the waves of V
  phases = 16,  ///< the solution
  values = 32,  ///< the values that a picture reads
  margin = 64,  ///< the space for a picture's legends
  style = 128   ///< the drawing of the pattern
};

constexpr OptionStage operator|(OptionStage a, OptionStage b) {
  return static_cast<OptionStage>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(OptionStage stages, OptionStage stage) {
  return (static_cast<unsigned>(stages) & static_cast<unsigned>(stage)) != 0;
}

/// The numbers that are valid for an option.
struct NumberRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above_least = false;  ///< excludes `least` itself
  bool below_most = false;   ///< excludes `most` itself

  /// Whether `value` is in range; infinities and NaN never are.
  bool contains(double value) const;
};

/// The range of a slider: the most useful numbers. Lengths are in hundredths of the diagonal.
struct SliderRange {
  double lowest = 0;
  double highest = 1;
  bool logarithmic = false;  ///< in even ratios; may begin at 0
  bool whole = false;        ///< stops at whole numbers; what is typed may have a fraction
};

/// Extensions of the files that hold meshes or points, separated by spaces.
inline constexpr std::string_view kMeshFiles = ".vtp .vtu .vtk .ply .obj .stl .off .gltf .glb";

/// A row of the table. Texts live as long as the program.
struct OptionInfo {
  std::string_view name = {};   ///< long, without dashes: "stripe-width"
  std::string_view words = {};  ///< label in panels: "width of stripes"; empty: not shown there
  bool common = false;          ///< in short lists, too
  std::string_view group = {};  ///< heading in lists of options: "Stripes"
  OptionKind kind = OptionKind::text;
  std::string_view form = {};  ///< how a value is written: "N", "FILE|array:NAME"; of flags: empty
  std::string_view unit = {};  ///< of numbers and lengths; empty: none
  std::string_view standard = {};  ///< default; empty: none
  NumberRange range = {};          ///< of whole numbers, numbers and lengths
  SliderRange slider = {};         ///< of whole numbers, numbers and lengths
  bool several = false;            ///< may be given more than once
  std::string_view files = {};     ///< extensions of files, separated by spaces, that it may name
  bool by_camera = false;          ///< the value may depend on a picture's camera or light
  std::string_view needs = {};     ///< options, separated by spaces, that it requires
  std::string_view excludes = {};  ///< options, separated by spaces, that it excludes
  std::string_view one_process = {};  ///< why MPI ranks reject it; empty: they take it
  /// Options, separated by spaces, in whose values command lines have this one:
  /// --solver relaxation,epsilon=0.01. An option of its own in other doors, and in commands without
  /// them.
  std::string_view part_of = {};
  /// Before the part's value: ",epsilon=", or "@"; all of a flag: ",rounded", or "none" instead of
  /// the value; otherwise the unit behind a number: "px".
  std::string_view written = {};
  bool styles = false;  ///< pictures with it have a style
  bool own = false;     ///< of curves and samples: kept apart from the value for stripes
  OptionStage stale = OptionStage::none;  ///< stages that a change makes stale
  unsigned jobs = 0;                      ///< bits of PatternJob
  std::string_view help = {};             ///< one line of at most 70 bytes, without a full stop

  bool is_for(PatternJob job) const { return (jobs & static_cast<unsigned>(job)) != 0; }
};

/// All options, group by group, in the order of lists. A name has at most one row per job.
std::span<const OptionInfo> option_table();

/// The row of `name`, without dashes, for a job; null if the job has no such option.
const OptionInfo* find_option(std::string_view name, PatternJob job);

}  // namespace brindle
