#include "input/fabrication_options.h"

#include <cmath>

#include "brindle/recipe/wave_rows.h"
#include "cli/command_line.h"
#include "cli/option_fields.h"

namespace brindle::tool {
namespace {

int parse_whole(const std::string& option, const std::string& expected, const std::string& number,
                const std::string& text) {
  std::size_t read = 0;
  int value = 0;
  try {
    value = std::stoi(number, &read);
  } catch (const std::exception&) {
    read = 0;
  }
  if (number.empty() || read != number.size() || std::abs(value) > 1'000'000) {
    wrong_usage(option, expected, text);
  }
  return value;
}

}  // namespace

WantedWinding parse_winding(const std::string& option, const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::string name = colon == std::string::npos ? "" : text.substr(0, colon);
  const std::string number = colon == std::string::npos ? text : text.substr(colon + 1);
  const std::string expected =
      "a whole number, or a loop's name and one: 1, boundary-1:0 or loop-2:-3";
  if (colon != std::string::npos && name.empty()) wrong_usage(option, expected, text);
  return {name, parse_whole(option, expected, number, text)};
}

void add_fabrication_options(CLI::App& app, FabricationOptions& options) {
  visit_fabrication(options, AddField(app));
  app.add_option_function<std::vector<std::string>>(
         "--winding",
         [&options](const std::vector<std::string>& texts) {
           options.windings.clear();
           for (const std::string& text : texts) {
             options.windings.push_back(parse_winding("--winding", text));
           }
         })
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

void check_fabrication_options(const FabricationOptions& options, Solver solver) {
  refuse_usage([&] { check_fabrication(options, solver); });
}

}  // namespace brindle::tool
