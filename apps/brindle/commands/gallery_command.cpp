#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/option_table.h"
#include "brindle/render/parsed_words.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/progress_display.h"
#include "cli/temporary_folder.h"
#include "commands/run_words.h"
#include "gallery/gallery.h"
#include "input/used_files.h"
#include "outputs/outputs.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGalleryExamples = R"(Examples:
  brindle gallery
  brindle gallery aneurysm --output aneurysm.png
  brindle gallery molecule --picture colors --size 600x450 --output molecule.png
  brindle gallery nested --data nested
  brindle gallery hatching --surface scan.obj --output scan.png

Without a name, all items are listed; with a name alone, its pictures and their command lines.
--data keeps the item's data, so that you can run and change these lines. Their options, such as
--up, --camera, --stripes or --depth-cue, are options here, too.)";

struct GalleryArguments {
  std::string name;
  std::string picture;
  std::string output;
  std::string data;
  std::string surface, field, values;
  std::string size, quality;
  std::map<std::string, std::vector<std::string>> options;  ///< of its command lines, by name
  double detail = 1;
  bool quiet = false;
};

const GalleryItem& item_named(const std::string& name) {
  std::vector<std::string> names;
  std::string list;
  for (const GalleryItem& item : gallery_items()) {
    if (item.name == name) return item;
    names.push_back(item.name);
    list += (list.empty() ? "" : ", ") + item.name;
  }
  const std::string meant = nearest(name, names);
  throw CLI::ValidationError("NAME", "'" + name + "' is not in the gallery" +
                                         (meant.empty() ? "" : " (did you mean '" + meant + "'?)") +
                                         "; there are: " + list);
}

const GalleryPicture& picture_named(const GalleryItem& item, const std::string& name) {
  if (name.empty()) return item.pictures.front();
  std::string list;
  for (const GalleryPicture& picture : item.pictures) {
    if (picture.name == name) return picture;
    list += (list.empty() ? "" : ", ") + picture.name;
  }
  throw CLI::ValidationError("--picture",
                             "'" + item.name + "' has no '" + name + "'; there are: " + list);
}

/// Quoted for a shell.
std::string quoted(const std::string& word) {
  constexpr const char* kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// A shell command line; lines break only between options with their values.
std::string command_line_of(const std::vector<std::string>& words) {
  constexpr std::size_t kColumns = 100;
  std::string text = "brindle", line;
  const auto flush = [&](const std::string& next) {
    if (line.size() + next.size() + 3 > kColumns) {
      text += line + " \\\n ";
      line.clear();
    }
    line += next;
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::string next = " " + quoted(words[i]);
    const bool has_value =
        words[i].starts_with("-") && i + 1 < words.size() && !words[i + 1].starts_with("--");
    if (has_value) next += " " + quoted(words[++i]);
    flush(next);
  }
  return text + line;
}

/// The job of the picture's command.
PatternJob job_of(const GalleryPicture& picture) {
  if (picture.line.starts_with("animate ")) return PatternJob::animate;
  return picture.line.starts_with("sample ") ? PatternJob::sample : PatternJob::stripe;
}

/// Removes an option and its value from a picture's command line.
void leave_out(std::vector<std::string>& words, std::string_view name,
               const GalleryPicture& picture) {
  const auto at = std::ranges::find(words, "--" + std::string(name));
  const OptionInfo* option = find_option(name, job_of(picture));
  if (at == words.end() || option == nullptr) return;
  words.erase(at, at + (option->kind == OptionKind::flag ? 1 : 2));
}

/// Replaces the picture's options by the user's, also those that they exclude.
void put_options(std::vector<std::string>& words, const GalleryPicture& picture,
                 const std::map<std::string, std::vector<std::string>>& options) {
  for (const auto& [name, values] : options) {
    const OptionInfo* option = find_option(name, job_of(picture));
    if (option == nullptr) continue;
    if (!option->several) leave_out(words, name, picture);
    std::istringstream excluded{std::string(option->excludes)};
    for (std::string other; excluded >> other;) leave_out(words, other, picture);
    for (const std::string& value : values) {
      words.push_back("--" + name);
      if (option->kind != OptionKind::flag) words.push_back(value);
    }
  }
}

/// The axis that points up in pictures of the user's own file.
std::string up_of_file(const std::string& path) {
  return std::string(name_of(usual_up_axis(path).value_or(UpAxis::y)));
}

/// Whether the up axis of the user's file is guessed from its kind.
bool guesses_up(const GalleryArguments& arguments) {
  return !arguments.surface.empty() && !arguments.surface.starts_with("shape:") &&
         !arguments.options.contains("up");
}

std::string default_output(const GalleryItem& item, const GalleryPicture& picture) {
  const bool first = picture.name == item.pictures.front().name;
  return item.name + (first ? "" : "_" + picture.name) +
         (is_still_picture(picture) ? ".png" : ".mp4");
}

/// Rejects outputs other than pictures; meshes are in the item's data.
void check_is_drawn(const std::string& output) {
  const std::string extension = lower_extension(output);
  if (extension == ".png" || extension == ".svg" || extension == ".mp4") return;
  refuse_output(output,
                "an item of the gallery is drawn; write .png or .svg, or .mp4 where it moves. Its "
                "meshes are written by --data FOLDER");
}

/// The command line that draws a picture from data in `folder`.
std::vector<std::string> words_of(const GalleryPicture& picture, const GalleryArguments& arguments,
                                  const std::string& folder, const std::string& output) {
  std::vector<std::string> words =
      filled_words(picture, {folder, arguments.surface, arguments.field, arguments.values});
  if (guesses_up(arguments)) {
    leave_out(words, "up", picture);
    words.insert(words.end(), {"--up", up_of_file(arguments.surface)});
  }
  put_options(words, picture, arguments.options);
  words.insert(words.end(), {"--size", arguments.size.empty() ? picture.size : arguments.size});
  if (!arguments.quality.empty()) words.insert(words.end(), {"--quality", arguments.quality});
  words.insert(words.end(), {"--output", output});
  return words;
}

void list_items() {
  for (const GalleryItem& item : gallery_items()) {
    std::cout << item.name << std::string(12 - item.name.size(), ' ') << item.what << '\n';
  }
  std::cout
      << "\n'brindle gallery NAME' tells more, 'brindle gallery NAME --output FILE.png' draws "
         "it.\n";
}

void print_commands(const GalleryItem& item, const GalleryArguments& arguments,
                    const std::string& folder) {
  for (const GalleryPicture& picture : item.pictures) {
    if (!arguments.picture.empty() && picture.name != arguments.picture) continue;
    std::cout << "# " << picture.name << ": " << picture.what << '\n'
              << command_line_of(
                     words_of(picture, arguments, folder, default_output(item, picture)))
              << "\n\n";
  }
}

void check_replacements(const GalleryItem& item, const GalleryArguments& arguments) {
  for (const auto& [role, value] :
       {std::pair("surface", arguments.surface), std::pair("field", arguments.field),
        std::pair("values", arguments.values)}) {
    if (value.empty()) continue;
    const bool used = std::ranges::any_of(item.pictures, [&, r = role](const auto& picture) {
      return (arguments.picture.empty() || picture.name == arguments.picture) &&
             has_place(picture, r);
    });
    if (!used) {
      throw CLI::ValidationError(std::string("--") + role,
                                 "has no effect here: '" + item.name + "' has no place for it");
    }
  }
}

/// Whether a picture is drawn or its command line printed.
bool is_shown(const GalleryPicture& picture, const GalleryArguments& arguments,
              const GalleryItem& item) {
  if (!arguments.picture.empty()) return picture.name == arguments.picture;
  return arguments.output.empty() || &picture == &item.pictures.front();
}

/// Rejects options that no command of the pictures has.
void check_options(const GalleryItem& item, const GalleryArguments& arguments) {
  for (const auto& [name, values] : arguments.options) {
    const bool used = std::ranges::any_of(item.pictures, [&, &option = name](const auto& picture) {
      return is_shown(picture, arguments, item) && find_option(option, job_of(picture)) != nullptr;
    });
    if (!used) {
      throw CLI::ValidationError(
          "--" + name, "has no effect here: the command of '" + item.name + "' has no such option");
    }
  }
}

void check(const CLI::App& command, const GalleryArguments& arguments) {
  if (arguments.name.empty()) {
    if (!arguments.options.empty()) {
      throw CLI::ValidationError("--" + arguments.options.begin()->first,
                                 "has no effect here: name an item of the gallery");
    }
    refuse_given(command,
                 {"--picture", "--output", "--data", "--surface", "--field", "--values", "--size",
                  "--quality", "--detail", "--quiet"},
                 "name an item of the gallery");
    return;
  }
  const GalleryItem& item = item_named(arguments.name);
  picture_named(item, arguments.picture);
  check_replacements(item, arguments);
  check_options(item, arguments);
  if (arguments.output.empty() && arguments.data.empty()) {
    refuse_given(command, {"--detail", "--quiet"}, "nothing is made; add --output or --data");
  }
}

/// The user's input files, which must not be overwritten.
std::vector<UsedFile> inputs_of_gallery(const GalleryArguments& arguments) {
  std::vector<UsedFile> inputs;
  for (const auto& [option, value] :
       {std::pair("--surface", arguments.surface), std::pair("--field", arguments.field),
        std::pair("--values", arguments.values)}) {
    std::error_code ignored;
    if (!value.empty() && fs::exists(value, ignored)) inputs.push_back({option, value});
  }
  return inputs;
}

std::vector<fs::path> write_data(const std::string& folder, const GalleryItem& item,
                                 const GalleryArguments& arguments, const Progress& progress) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw Error("cannot make the folder '" + shown(folder) + "': " + error.message() +
                "; name one that can be written to");
  }
  const std::vector<GalleryFile> files = item.make(arguments.detail, progress.part(0, 0.8));
  std::vector<fs::path> paths;
  std::vector<UsedFile> outputs;
  if (!arguments.output.empty()) outputs.push_back({"--output", arguments.output});
  for (const GalleryFile& file : files) {
    paths.push_back(fs::path(folder) / file.name);
    outputs.push_back({"--data", paths.back()});
  }
  check_files(inputs_of_gallery(arguments), outputs);
  write_gallery_files(folder, files, progress.part(0.8, 1));
  return paths;
}

void run_gallery(const CLI::App& command, const GalleryArguments& arguments) {
  check(command, arguments);
  if (arguments.name.empty()) return list_items();
  const GalleryItem& item = item_named(arguments.name);
  const GalleryPicture& picture = picture_named(item, arguments.picture);
  if (guesses_up(arguments) && !arguments.quiet) {
    std::cerr << "brindle: " << up_of_file(arguments.surface)
              << " points up, as in pictures of other '" << lower_extension(arguments.surface)
              << "' files; --up says otherwise\n";
  }
  if (arguments.output.empty() && arguments.data.empty()) {
    std::cout << item.name << ": " << item.what << "\n\n";
    return print_commands(item, arguments, item.name);
  }
  if (!arguments.output.empty()) {
    check_files(inputs_of_gallery(arguments), {{"--output", arguments.output}});
    check_is_drawn(arguments.output);
    check_output_path(arguments.output);
  }
  std::optional<TemporaryFolder> temporary;
  std::string folder = arguments.data;
  if (folder.empty()) folder = temporary.emplace().path().string();
  std::vector<fs::path> paths;
  {
    ProgressDisplay display(arguments.quiet);
    display.stage("data of " + item.name);
    paths = write_data(folder, item, arguments, display.progress());
  }
  if (!arguments.output.empty()) {
    std::vector<std::string> words = words_of(picture, arguments, folder, arguments.output);
    if (arguments.quiet) words.push_back("--quiet");
    run_words(std::move(words));
  }
  if (arguments.data.empty() || arguments.quiet) return;
  print_written(std::cout, paths);
  std::cout << '\n';
  print_commands(item, arguments, folder);
}

double parse_detail(const std::string& option, const std::string& text) {
  const float detail = parse_number(option, text);
  if (detail < 0.25f || detail > 4) wrong_usage(option, "a factor from 0.25 to 4", text);
  return static_cast<double>(detail);
}

/// Adds all options of the items' command lines, hidden: the footer mentions them.
void add_line_options(CLI::App& command, GalleryArguments& arguments) {
  for (const OptionInfo& option : option_table()) {
    const std::string name(option.name);
    const bool drawn = option.is_for(PatternJob::stripe) || option.is_for(PatternJob::sample) ||
                       option.is_for(PatternJob::animate);
    if (!drawn || !option.part_of.empty() || command.get_option_no_throw("--" + name) != nullptr) {
      continue;
    }
    if (option.kind == OptionKind::flag) {
      command
          .add_flag_function("--" + name,
                             [&arguments, name](std::int64_t) { arguments.options[name] = {""}; })
          ->group("");
    } else {
      command
          .add_option_function<std::vector<std::string>>(
              "--" + name,
              [&arguments, name](const std::vector<std::string>& values) {
                arguments.options[name] = values;
              })
          ->expected(1)
          ->take_all()
          ->allow_extra_args(false)
          ->group("");
    }
  }
}

void add_gallery_options(CLI::App& command, GalleryArguments& arguments) {
  command.add_option("NAME", arguments.name, "the item; without, all are listed");
  command.add_option("--picture", arguments.picture, "which of its pictures (default: the first)")
      ->type_name("NAME");
  command.add_option("-o,--output", arguments.output, "draw it: .png, or .mp4 where it moves")
      ->type_name("FILE")
      ->group("Output");
  command
      .add_option("--data", arguments.data,
                  "write its data there and print the commands that draw them")
      ->type_name("FOLDER");
  command.add_option("--surface", arguments.surface, "a mesh of your own instead of the item's")
      ->type_name("FILE");
  command.add_option("--field", arguments.field, "its field, as --field of 'brindle stripe'")
      ->type_name("FIELD");
  command.add_option("--values", arguments.values, "its values, such as array:NAME of its file")
      ->type_name("VALUE");
  command.add_option("--size", arguments.size, "pixels")->type_name("WIDTHxHEIGHT");
  command.add_option("--quality", arguments.quality, "fast or careful (default final)")
      ->type_name("interactive|final");
  add_parsed_option(command, "--detail", arguments.detail, parse_detail,
                    "resolution of its data: 0.25 to 4 times the edges (default 1)")
      ->type_name("F");
  command.add_flag("-q,--quiet", arguments.quiet, "print nothing but errors");
  add_line_options(command, arguments);
}

}  // namespace

Command add_gallery_command(CLI::App& app) {
  return add_command<GalleryArguments>(app, "gallery", "Render examples from generated data",
                                       kGalleryExamples, add_gallery_options, run_gallery);
}

}  // namespace brindle::tool
