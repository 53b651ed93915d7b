#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/files.h"

#ifdef BRINDLE_HAS_JSON
#include <nlohmann/json.hpp>
#endif

#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files/vtk/vtp_file.h"

#ifdef BRINDLE_HAS_VTK
#include <pugixml.hpp>
#endif

namespace brindle {
namespace {

/// A file's name relative to the folder of `path`.
std::string name_beside(const std::filesystem::path& path, const std::filesystem::path& file) {
  const auto relative = file.lexically_relative(path.parent_path());
  return (relative.empty() ? file : relative).generic_string();
}

#ifdef BRINDLE_HAS_VTK
TimedFile timed_file(const std::filesystem::path& pvd, const pugi::xml_node& data_set) {
  const std::string file = data_set.attribute("file").value();
  const double time = parse_number(data_set.attribute("timestep").value()).value_or(std::nan(""));
  if (file.empty() || !std::isfinite(time)) {
    throw Error(shown(pvd.string()) + ": a DataSet lacks its 'file' or a finite 'timestep'");
  }
  return {time, pvd.parent_path() / file};
}
#endif

void check_times(const std::filesystem::path& pvd, const std::vector<TimedFile>& files) {
  if (files.empty()) throw Error(shown(pvd.string()) + ": lists no file");
  for (std::size_t i = 0; i + 1 < files.size(); ++i) {
    if (files[i].time != files[i + 1].time) continue;
    throw Error(shown(pvd.string()) + ": '" + shown(files[i].file.string()) + "' and '" +
                shown(files[i + 1].file.string()) +
                "' have the same timestep; merge the parts of a step into one file");
  }
}

/// Sorted by time.
std::vector<TimedFile> in_order(const std::filesystem::path& path, std::vector<TimedFile> files) {
  ranges::stable_sort(files, {}, &TimedFile::time);
  check_times(path, files);
  return files;
}

#ifdef BRINDLE_HAS_JSON
TimedFile timed_file(const std::filesystem::path& series, const nlohmann::json& entry) {
  const bool is_whole = entry.is_object() && entry.contains("name") && entry["name"].is_string() &&
                        entry.contains("time") && entry["time"].is_number();
  if (!is_whole) {
    throw Error(shown(series.string()) + ": an entry of 'files' lacks its 'name' or its 'time'");
  }
  return {entry["time"].get<double>(), series.parent_path() / entry["name"].get<std::string>()};
}
#endif

}  // namespace

#ifdef BRINDLE_HAS_VTK
std::vector<TimedFile> read_pvd(const std::filesystem::path& path) {
  InputFile in(path);
  const auto size = static_cast<std::size_t>(in.remaining());
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(in.take(size), size);
  if (!parsed) throw Error(shown(path.string()) + ": is no XML: " + parsed.description());
  const pugi::xml_node collection = document.child("VTKFile").child("Collection");
  if (!collection)
    throw Error(shown(path.string()) + ": is no collection of files as ParaView writes it");
  std::vector<TimedFile> files;
  for (const pugi::xml_node& data_set : collection.children("DataSet")) {
    files.push_back(timed_file(path, data_set));
  }
  return in_order(path, std::move(files));
}
#else
std::vector<TimedFile> read_pvd(const std::filesystem::path& path) {
  throw Error(shown(path.string()) +
              ": this build cannot read .pvd files; configure with -DBRINDLE_VTK=ON");
}
#endif

#ifdef BRINDLE_HAS_JSON
std::vector<TimedFile> read_file_series(const std::filesystem::path& path) {
  InputFile in(path);
  const auto size = static_cast<std::size_t>(in.remaining());
  const char* text = in.take(size);
  const auto json = nlohmann::json::parse(text, text + size, nullptr, false);
  const bool is_series = json.is_object() && json.contains("files") && json["files"].is_array();
  if (!is_series) {
    throw Error(shown(path.string()) + ": is no list of 'files' as ParaView writes it");
  }
  std::vector<TimedFile> files;
  for (const nlohmann::json& entry : json["files"]) files.push_back(timed_file(path, entry));
  return in_order(path, std::move(files));
}
#else
std::vector<TimedFile> read_file_series(const std::filesystem::path& path) {
  throw Error(shown(path.string()) +
              ": this brindle was built without nlohmann-json and reads no series; install it and "
              "build again");
}
#endif

void write_pvd(const std::filesystem::path& path, std::span<const TimedFile> files) {
  for (const TimedFile& timed : files) check_name_in_xml(timed.file);
  write_file(path, [&](OutputStream& stream) {
    TextOutput out(stream);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
           "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const TimedFile& timed : files) {
      out << "<DataSet timestep=\"" << timed.time << "\" part=\"0\" file=\""
          << xml_text(name_beside(path, timed.file)) << "\"/>\n";
    }
    out << "</Collection>\n</VTKFile>\n";
  });
}

}  // namespace brindle
