#include "jobs/series.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "cli/option_values.h"
#include "input/carried_pattern.h"
#include "input/vertex_values.h"
#include "pictures/frame_output.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExpectedSeries =
    "a .pvd or .series file, or names with a number or a wildcard such as 'v%04d.vtp' or 'v*.vtp'";

/// The names of a folder's files.
std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failure;
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator it(place, failure), end; !failure && it != end;
       it.increment(failure)) {
    names.push_back(it->path().filename().string());
  }
  if (failure) throw Error(shown(place.native()) + ": cannot be listed: " + failure.message());
  return names;
}

[[noreturn]] void throw_no_file(const std::string& name) {
  throw Error(shown(name) + ": there is no such file");
}

// --- v%04d.vtp

/// The number in a name that matches the pattern.
std::optional<long> number_in(const FrameNames& names, std::string_view name) {
  if (name.size() <= names.before.size() + names.after.size() || !name.starts_with(names.before) ||
      !name.ends_with(names.after)) {
    return std::nullopt;
  }
  const std::string_view digits =
      name.substr(names.before.size(), name.size() - names.before.size() - names.after.size());
  long number = 0;
  const auto [rest, failure] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = failure == std::errc() && rest == digits.data() + digits.size();
  if (!whole || number < 0 || numbered_name(names, number) != name) return std::nullopt;
  return number;
}

std::vector<TimedFile> numbered_files(const std::string& pattern, const FrameNames& names) {
  std::vector<long> numbers;
  for (const std::string& name : names_in(names.folder)) {
    if (const auto number = number_in(names, name)) numbers.push_back(*number);
  }
  if (numbers.empty()) throw_no_file(pattern);
  std::ranges::sort(numbers);
  std::vector<TimedFile> files;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && numbers[i] != numbers[i - 1] + 1) {
      throw_no_file(shown((names.folder / numbered_name(names, numbers[i - 1] + 1)).native()) +
                    ", between others of '" + pattern + "'");
    }
    files.push_back(
        {static_cast<double>(numbers[i]), names.folder / numbered_name(names, numbers[i])});
  }
  return files;
}

// --- v*.vtp

bool matches(std::string_view pattern, std::string_view name) {
  // Position to retry from if the last * must match one more character.
  std::optional<std::pair<std::size_t, std::size_t>> retry;
  std::size_t p = 0, n = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      retry = {p++, n};
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
      ++p;
      ++n;
    } else if (retry) {
      p = retry->first + 1;
      n = ++retry->second;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::string_view digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
  return text.substr(at, end - at);
}

/// Compares embedded numbers by value: v2 before v10.
bool is_before(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    std::string_view one = digits_at(a, i), other = digits_at(b, j);
    if (one.empty() || other.empty()) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
      continue;
    }
    i += one.size();
    j += other.size();
    one.remove_prefix(std::min(one.find_first_not_of('0'), one.size()));
    other.remove_prefix(std::min(other.find_first_not_of('0'), other.size()));
    if (one.size() != other.size()) return one.size() < other.size();
    if (one != other) return one < other;
  }
  return a.size() - i != b.size() - j ? a.size() - i < b.size() - j : a < b;
}

/// The last number in a name, without its extension.
std::optional<double> last_number_in(const std::string& name) {
  const std::string stem = fs::path(name).stem().string();
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto end = std::find_if(stem.rbegin(), stem.rend(), is_digit);
  const auto begin = std::find_if_not(end, stem.rend(), is_digit);
  if (end == stem.rend()) return std::nullopt;
  return std::strtod(std::string(begin.base(), end.base()).c_str(), nullptr);
}

/// Times from the files' numbers if all have one in ascending order; else their positions.
void number(std::vector<TimedFile>& files, std::span<const std::string> names) {
  std::vector<double> numbers;
  for (const std::string& name : names) {
    const auto found = last_number_in(name);
    if (!found || (!numbers.empty() && *found <= numbers.back())) return;
    numbers.push_back(*found);
  }
  for (std::size_t i = 0; i < files.size(); ++i) files[i].time = numbers[i];
}

std::vector<TimedFile> matching_files(const std::string& pattern) {
  const fs::path path(pattern);
  std::vector<std::string> names;
  for (std::string& name : names_in(path.parent_path())) {
    if (matches(path.filename().string(), name)) names.push_back(std::move(name));
  }
  if (names.empty()) throw_no_file(pattern);
  std::ranges::sort(names, is_before);
  std::vector<TimedFile> files;
  for (const std::string& name : names) {
    files.push_back({static_cast<double>(files.size()), path.parent_path() / name});
  }
  number(files, names);
  return files;
}

bool has_wildcard(const std::string& text) { return text.find_first_of("*?") != std::string::npos; }

}  // namespace

std::vector<TimedFile> series_files(const std::string& option, const std::string& name) {
  const fs::path path(name);
  if (has_wildcard(path.parent_path().string())) wrong_usage(option, kExpectedSeries, name);
  if (has_wildcard(name)) return matching_files(name);
  if (const auto names = parse_frame_names(path)) return numbered_files(name, *names);
  if (lower_extension(path) == ".series") return read_file_series(path);
  if (lower_extension(path) != ".pvd") wrong_usage(option, kExpectedSeries, name);
  return read_pvd(path);
}

namespace {

/// Adds the file name to messages without it.
template <class Work>
auto naming(const std::filesystem::path& file, const Work& work) {
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    const std::string message = error.what();
    if (message.find(shown(file.native())) != std::string::npos) throw;
    throw Error(shown(file.native()) + ": " + message);
  }
}

/// One origin makes all steps comparable.
void move_to_origin(Preparation& prepared, const Eigen::Vector3d& origin) {
  Mesh& mesh = prepared.surface.mesh;
  const Eigen::Vector3d shift = mesh.origin - origin;
  if (shift.isZero(0)) return;
  for (Vec3& position : mesh.positions) {
    position = (position.cast<double>() + shift).cast<float>();
  }
  mesh.origin = origin;
  prepared.waves.positions = mesh.positions;
}

bool is_same(const Mesh& a, const Mesh& b) {
  return a.origin == b.origin && a.positions == b.positions && a.triangles == b.triangles;
}

}  // namespace

std::size_t frame_count(const SeriesOptions& options, std::size_t steps) {
  return 1 + (steps - 1) * (1 + static_cast<std::size_t>(options.between));
}

Series::Series(const SeriesOptions& options, SurfaceOptions surface, WaveOptions waves,
               SeriesFields smooth_fields, std::optional<Viewpoint> viewpoint)
    : files_(series_files("--series", options.name)),
      surface_(std::move(surface)),
      waves_(std::move(waves)),
      viewpoint_(std::move(viewpoint)),
      smooth_fields_(std::move(smooth_fields)) {
  fields_ = lower_extension(files_.front().file) == ".csv";
  if (fields_ && surface_.mesh.empty()) {
    throw CLI::ValidationError("--series", "CSV files are fields over a mesh; name it as MESH");
  }
  if (!fields_ && !surface_.mesh.empty()) {
    throw CLI::ValidationError(
        "MESH", "'" + surface_.mesh + "': the files of --series are the meshes; leave out MESH");
  }
}

Preparation Series::prepare_step(ProgressDisplay& display) const {
  const auto find_last = [this](const Preparation& prepared) -> LastDirections {
    if (!last_) return {};
    if (is_same(last_->mesh, prepared.surface.mesh)) return {last_->directions, true};
    return {carry_field(*last_, surface_.mesh, prepared, waves_, smooth_fields_.match)};
  };
  return prepare(surface_, waves_, display, viewpoint_, find_last);
}

/// Keeps the field that the next one starts from.
void Series::keep(const SeriesStep& step) {
  if (!goes_on_from_last(waves_)) return;
  if (is_smooth(waves_) && (fields_ || !smooth_fields_.follow)) return;
  const Preparation& prepared = step.prepared;
  last_ = KeptField{step.source.file.string(), prepared.surface.mesh,  prepared.surface.normals,
                    prepared.kept_field,       prepared.arrays.points, mean_period(prepared.waves)};
}

SeriesStep Series::read(ProgressDisplay& display) {
  const TimedFile& source = files_[next_];
  const std::string file = source.file.string();
  (fields_ ? waves_.field : surface_.mesh) = file;
  SeriesStep step{source,
                  naming(source.file,
                         [&] {
                           refuse_points(surface_, "animate --series");
                           return prepare_step(display);
                         }),
                  {}};
  if (step.prepared.field_step && smooth_fields_.afresh) {
    step.waves_afresh = waves_afresh(step.prepared, surface_, waves_, viewpoint_);
  }
  if (next_ == 0) {
    origin_ = step.prepared.surface.mesh.origin;
    if (viewpoint_ && depends_on_camera(waves_.arrays.frequency_by)) {
      viewpoint_->framed = step.prepared.surface.mesh;
    }
  }
  move_to_origin(step.prepared, origin_);
  if (step.waves_afresh) step.waves_afresh->positions = step.prepared.waves.positions;
  keep(step);
  // The number of stripes is that of the first step, so that they do not widen with the mesh.
  if (next_ == 0 && !fields_ && waves_.arrays.frequency.empty()) {
    waves_.frequency = constant_frequency(step.prepared.surface.mesh, waves_);
    waves_.stripes.reset();
  }
  ++next_;
  return step;
}

SceneFrame between(const SceneFrame& a, const SceneFrame& b, float share) {
  SceneFrame frame = a;
  const std::size_t count = frame.mesh.vertex_count();
  for (std::size_t v = 0; v < count; ++v) {
    frame.mesh.positions[v] = (1 - share) * a.mesh.positions[v] + share * b.mesh.positions[v];
  }
  frame.waves.positions = frame.mesh.positions;
  frame.normals = vertex_normals(frame.mesh);
  std::vector<Vec3>& directions = frame.waves.directions;
  for (std::size_t v = 0; v < count; ++v) {
    const Vec3 one = a.waves.directions[v], other = b.waves.directions[v];
    const bool both = !one.isZero(0) && !other.isZero(0);
    const Vec3 alike = one.dot(other) < 0 ? Vec3(-other) : other;
    directions[v] = both ? Vec3((1 - share) * one + share * alike) : (share < 0.5f ? one : other);
    frame.waves.frequencies[v] =
        (1 - share) * a.waves.frequencies[v] + share * b.waves.frequencies[v];
  }
  directions = tangent_directions(directions, frame.normals);
  return frame;
}

}  // namespace brindle::tool
