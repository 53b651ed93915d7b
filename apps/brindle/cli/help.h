/// Help in two lengths.
#pragma once

#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace brindle::tool {

/// The order of groups: output first, the solver last, the rest as in the table.
int rank_of_group(std::string_view group);

/// The parts that an option's value may have, as a form shows them: "[@A..B]", "[,...]".
std::string form_of_parts(const CLI::Option& option, const CLI::App& command);

/// Lists options group by group: `--help` the common ones and a few examples, `--help-all` all.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_option_opts(const CLI::Option* option) const override;

 private:
  std::string groups_of(const CLI::App& app) const;

  mutable const CLI::App* command_ = nullptr;  ///< whose help is being made
  mutable bool all_ = false;                   ///< the help that is being made is `--help-all`
};

}  // namespace brindle::tool
