/// The options of `brindle stripe`, `curves` and `sample` as sessions have them: what a window
/// shows, and what a document's values mean.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/option_table.h"
#include "jobs/curves_arguments.h"
#include "jobs/sample_arguments.h"
#include "jobs/stripe_arguments.h"
#include "session/session_document.h"

namespace brindle::tool {

/// Rows of the table, in its order: those that make a pattern or its picture. Not those that a
/// session has another way (--camera, --size, --quality), that concern the machine (--threads) or
/// that write files.
const std::vector<const OptionInfo*>& session_options(Shown shown = Shown::stripes);

/// Null if there is no such option.
const OptionInfo* find_session_option(const std::string& name, Shown shown = Shown::stripes);

/// Whether curves or samples, which are shown, have the option to themselves: documents keep it
/// apart from those of stripes.
bool is_own(const OptionInfo& option, Shown shown);

/// A message of the tool in the words of a panel: 'split triangles' 2 for --subdivide 2.
std::string in_panel_words(const std::string& text, Shown shown);

/// All values of a choice; empty of other options.
std::vector<std::string> choices_of(const OptionInfo& option);

/// Where the document keeps this option of what it shows. Throws CLI::ValidationError, with what
/// there is instead, if there is no such option.
OptionValues& options_with(const std::string& name, SessionDocument& document);

/// The options that count for what the document shows.
OptionValues shown_options(const SessionDocument& document);

/// Whether patterns may follow earlier ones, so that documents may have phases: stripes of the
/// multilevel solver, without slack, without given phases and in the paper's weights.
bool can_follow(const StripeArguments& arguments);

/// The same with slack: while something moves.
bool can_follow_loosely(const StripeArguments& arguments);

/// Whether textures or crosses may follow earlier ones in drafts: those of the multilevel solver on
/// a mesh, without slack.
bool can_follow_tiles(const StripeArguments& arguments);

/// A document read as a command line of `brindle stripe`, `curves` or `sample`, as it shows.
class ParsedSession {
 public:
  /// Throws CLI::ParseError as the command does; without effects and without reading files.
  explicit ParsedSession(const SessionDocument& document);

  const CLI::App& command() const { return *command_; }
  /// With the document's camera, size, strokes and frequency factor. Of curves and samples: the
  /// pattern U.
  const StripeArguments& arguments() const { return *arguments_; }

  /// Null unless they are shown.
  const CurvesArguments* curves() const { return curves_.get(); }
  const SampleArguments* samples() const { return samples_.get(); }

  /// All files that are read.
  std::vector<UsedFile> inputs() const;

 private:
  void add_options(Shown shown);
  void take_shared();

  std::unique_ptr<CLI::App> app_;
  CLI::App* command_ = nullptr;
  std::unique_ptr<StripeArguments> arguments_;
  std::unique_ptr<CurvesArguments> curves_;
  std::unique_ptr<SampleArguments> samples_;
};

/// Throws as the command does for what points cannot have, if the mesh's file holds nothing else,
/// which is read for that.
void check_session_points(const ParsedSession& parsed);

/// Throws CLI::ValidationError or Error unless the document's picture can be written to these
/// files: .png, and drawings (.svg, .pdf) of stripes and curves. Reads what says whether the mesh
/// has triangles.
void check_picture_files(const ParsedSession& parsed,
                         const std::vector<std::filesystem::path>& paths);

/// `check_document` of one that is read already.
void check_document(const SessionDocument& document, const ParsedSession& parsed);

}  // namespace brindle::tool
