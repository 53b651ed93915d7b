/// Options of `brindle stripe`, `curves` and `sample` in sessions: those shown by windows, and the
/// meaning of a document's values.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "brindle/option_table.h"
#include "jobs/curves_job.h"
#include "jobs/sample_job.h"
#include "jobs/stripe_job.h"
#include "session/session_document.h"

namespace brindle::tool {

/// Rows of the option table, in order, for patterns and their pictures. Without options that
/// sessions store otherwise (--camera, --size, --quality), that concern the machine (--threads) or
/// that write files.
const std::vector<const OptionInfo*>& session_options(Shown shown = Shown::stripes);

/// Null if there is no such option.
const OptionInfo* find_session_option(const std::string& name, Shown shown = Shown::stripes);

/// Whether the option belongs to the shown curves or samples alone: documents store it apart from
/// that of stripes.
bool is_own(const OptionInfo& option, Shown shown);

/// A message of the tool in the words of a panel: 'split triangles' 2 for --subdivide 2.
std::string in_panel_words(const std::string& text, Shown shown);

/// All values of a choice; empty of other options.
std::vector<std::string> choices_of(const OptionInfo& option);

/// The part of the document that stores this option. Throws CLI::ValidationError with the
/// alternative if there is no such option.
OptionValues& options_with(const std::string& name, SessionDocument& document);

/// The options in effect for the shown picture.
OptionValues shown_options(const SessionDocument& document);

/// Whether patterns may continue earlier ones, and documents may store phases: stripes of the
/// multilevel solver with the paper's weights, without a spacing tolerance or given phases.
bool can_follow(const StripeArguments& arguments);

/// The same with a spacing tolerance, for drafts.
bool can_follow_loosely(const StripeArguments& arguments);

/// Whether textures or crosses may continue earlier ones in drafts: those of the multilevel solver
/// on a mesh, without a spacing tolerance.
bool can_follow_tiles(const StripeArguments& arguments);

/// A document, parsed as a command line of `brindle stripe`, `curves` or `sample`.
class ParsedSession {
 public:
  /// Throws CLI::ParseError as the command does; has no side effects and reads no files.
  explicit ParsedSession(const SessionDocument& document);

  const CLI::App& command() const { return *command_; }
  /// With the document's camera, size, strokes and frequency factor. For curves and samples, the
  /// pattern U.
  const StripeArguments& arguments() const { return *arguments_; }

  /// Null unless they are shown.
  const CurvesArguments* curves() const { return curves_.get(); }
  const SampleArguments* samples() const { return samples_.get(); }

  /// All input files.
  std::vector<UsedFile> inputs() const;

 private:
  void add_options(Shown shown);
  /// What the command line has set, of whichever command is shown.
  JobArguments& parsed_job();
  void take_shared();

  std::unique_ptr<CLI::App> app_;
  CLI::App* command_ = nullptr;
  std::unique_ptr<StripeArguments> arguments_;
  std::unique_ptr<CurvesArguments> curves_;
  std::unique_ptr<SampleArguments> samples_;
};

/// Throws as the command does for options that point clouds do not support; reads the mesh's file
/// if necessary.
void check_session_points(const ParsedSession& parsed);

/// Throws CLI::ValidationError or Error unless the document's picture can be written to these
/// files: .png, and drawings (.svg, .pdf) of stripes and curves. Reads the mesh's file if its kind
/// matters.
void check_picture_files(const ParsedSession& parsed,
                         const std::vector<std::filesystem::path>& paths);

/// `check_document` of a parsed one.
void check_document(const SessionDocument& document, const ParsedSession& parsed);

}  // namespace brindle::tool
