#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/file_names.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/tool_paths.h"

namespace brindle {
namespace {

/// With a fixed number of digits behind the point, and without trailing zeros.
std::string fixed(double number, int digits) {
  const double scale = std::pow(10.0, digits);
  auto whole = static_cast<std::int64_t>(std::llround(number * scale));
  const std::string sign = whole < 0 ? "-" : "";
  whole = std::abs(whole);
  const auto unit = static_cast<std::int64_t>(scale);
  std::string fraction = std::to_string(whole % unit);
  fraction.insert(0, static_cast<std::size_t>(digits) - fraction.size(), '0');
  fraction.erase(fraction.find_last_not_of('0') + 1);
  return sign + std::to_string(whole / unit) + (fraction.empty() ? "" : "." + fraction);
}

std::vector<DataArray> arrays_of(const ToolPaths& paths, const Machine& machine) {
  std::vector<float> speeds, extrusions;
  for (std::size_t i = 0; i < paths.widths.size(); ++i) {
    speeds.push_back(static_cast<float>(speed_at(paths, i, machine)));
    extrusions.push_back(paths.widths[i] / paths.width);
  }
  std::vector<DataArray> arrays = {make_data_array("direction", paths.directions),
                                   make_data_array("width", 1, paths.widths),
                                   make_data_array("speed", 1, speeds),
                                   make_data_array("extrusion", 1, extrusions),
                                   make_data_array("join", 1, paths.joined),
                                   make_data_array("cut", 1, paths.cut)};
  const std::vector<Eigen::Vector4f> poses = path_poses(paths);
  constexpr std::array kNames = {"qw", "qx", "qy", "qz"};
  for (int k = 0; k < 4; ++k) {
    std::vector<float> column;
    for (const Eigen::Vector4f& pose : poses) column.push_back(pose[k]);
    arrays.push_back(make_data_array(kNames[static_cast<std::size_t>(k)], 1, column));
  }
  return arrays;
}

void write_dxf(OutputStream& out, const ToolPaths& paths, const Machine& machine) {
  const std::vector<Eigen::Vector3d> positions = machine_points(paths, machine);
  TextOutput text(out);
  text << "999\nwritten by brindle, in millimetres\n0\nSECTION\n2\nENTITIES\n";
  const auto place = [&](const Eigen::Vector3d& p) {
    text << "10\n"
         << fixed(p.x(), 6) << "\n20\n"
         << fixed(p.y(), 6) << "\n30\n"
         << fixed(p.z(), 6) << '\n';
  };
  for (std::size_t line = 0; line < paths.lines.count(); ++line) {
    text << "0\nPOLYLINE\n8\npaths\n66\n1\n70\n8\n";
    place(Eigen::Vector3d::Zero());
    for (std::size_t i = paths.lines.offsets[line]; i < paths.lines.offsets[line + 1]; ++i) {
      text << "0\nVERTEX\n8\npaths\n70\n32\n";
      place(positions[i]);
    }
    text << "0\nSEQEND\n8\npaths\n";
  }
  text << "0\nENDSEC\n0\nEOF\n";
}

/// Lines of G-code; words that do not change are left out.
class GcodeWriter {
 public:
  GcodeWriter(OutputStream& out, const ToolPaths& paths, const Machine& machine)
      : text_(out),
        paths_(paths),
        machine_(machine),
        positions_(machine_points(paths, machine)),
        turn_(machine_turn(machine)) {
    for (const Eigen::Vector3d& p : positions_) top_ = std::max(top_, p.z());
  }

  void write() {
    begin();
    for (std::size_t line = 0; line < paths_.lines.count(); ++line) {
      const std::size_t first = paths_.lines.offsets[line];
      const std::size_t last = paths_.lines.offsets[line + 1] - 1;
      travel_to(first);
      for (std::size_t i = first; i < last; ++i) trace(i);
      if (is_five()) rise(last);
    }
    end();
  }

 private:
  bool is_five() const { return machine_.axes == 5; }
  bool extrudes() const { return machine_.dialect == GcodeDialect::marlin; }

  void begin() {
    text_ << "; written by brindle\nG21 ; millimetres\nG90 ; absolute positions\n";
    text_ << (extrudes() ? "M83 ; relative extrusion\n" : "G94 ; millimetres a minute\n");
    if (is_five()) text_ << "G43.4 ; X Y Z are the tip, A C turn the tool: Rz(C) Rx(A) z\n";
  }

  void end() {
    if (!is_five()) word('G', "0"), move('Z', safe_height()), end_line();
    if (is_five()) text_ << "G49\n";
    if (!extrudes()) text_ << "M2\n";
  }

  double safe_height() const { return top_ + machine_.lift; }

  void word(char letter, const std::string& value) { line_ += ' ' + (letter + value); }

  /// A coordinate, unless the machine is there.
  void move(char letter, double value) {
    std::string& now = now_[static_cast<std::size_t>(letter - 'A')];
    const std::string next = fixed(value, 4);
    if (next != now) word(letter, now = next);
  }

  void move_to(const Eigen::Vector3d& position) {
    move('X', position.x());
    move('Y', position.y());
    move('Z', position.z());
  }

  void feed(double millimetres_per_second) {
    const std::string next = fixed(60 * millimetres_per_second, 1);
    std::string& now = now_['F' - 'A'];
    if (next != now) word('F', now = next);
  }

  void end_line() {
    if (line_.size() > 3) text_ << std::string_view(line_).substr(1) << '\n';
    line_.clear();
  }

  /// The tool's axis is (sin A sin C, -sin A cos C, cos A). C goes on without a jump.
  void tilt(std::size_t point) {
    constexpr double kDegrees = 180 / std::numbers::pi;
    const Eigen::Vector3d axis = turn_ * paths_.lines.normals[point].cast<double>();
    const double sine = std::hypot(axis.x(), axis.y());
    if (sine > 1e-6) {
      const double turned = std::atan2(axis.x(), -axis.y()) * kDegrees;
      turned_ += std::remainder(turned - turned_, 360.0);
    }
    move('A', std::atan2(sine, axis.z()) * kDegrees);
    move('C', turned_);
  }

  Eigen::Vector3d above(std::size_t point) const {
    return positions_[point] + machine_.lift * (turn_ * paths_.lines.normals[point].cast<double>());
  }

  void rise(std::size_t point) {
    word('G', "0");
    move_to(above(point));
    end_line();
  }

  void travel_to(std::size_t point) {
    if (!is_five()) {
      word('G', "0");
      move('Z', safe_height());
      feed(machine_.travel_speed);
      end_line();
    }
    word('G', "0");
    const Eigen::Vector3d& to = positions_[point];
    is_five() ? move_to(above(point)) : move_to({to.x(), to.y(), safe_height()});
    if (is_five()) tilt(point), feed(machine_.travel_speed);
    end_line();
    word('G', "0");
    move_to(to);
    end_line();
  }

  /// The segment behind a point.
  void trace(std::size_t point) {
    const bool cuts = paths_.cut[point] != 0;
    if (cuts && !cut_) text_ << "; cut\n";
    cut_ = cuts;
    word('G', "1");
    move_to(positions_[point + 1]);
    if (is_five()) tilt(point + 1);
    if (extrudes()) {
      // Rounding is carried on, so that no material is lost.
      wanted_ += extrusion_of(paths_, point, positions_, machine_);
      const std::string more = fixed(wanted_ - given_, 5);
      given_ += std::round((wanted_ - given_) * 1e5) / 1e5;
      if (more != "0") word('E', more);
    }
    feed(speed_at(paths_, point, machine_));
    end_line();
  }

  TextOutput text_;
  const ToolPaths& paths_;
  const Machine& machine_;
  std::vector<Eigen::Vector3d> positions_;
  Eigen::Matrix3d turn_;
  double top_ = 0;
  std::array<std::string, 26> now_;  // the last word of each letter
  std::string line_;
  double turned_ = 0;  // C
  double wanted_ = 0, given_ = 0;
  bool cut_ = false;
};

}  // namespace

bool is_tool_path_format(const std::filesystem::path& path) {
  const std::string kind = lower_extension(path);
  return kind == ".gcode" || kind == ".dxf" || is_polyline_format(path);
}

void write_tool_paths(const std::filesystem::path& path, const ToolPaths& paths,
                      const Machine& machine, const Progress& progress) {
  if (is_polyline_format(path)) {
    machine_points(paths, machine);  // checks the machine
    return write_polylines(
        path, std::vector<NamedLines>{{"path", paths.lines, arrays_of(paths, machine)}}, progress);
  }
  if (!is_tool_path_format(path)) {
    throw Error("cannot write '" + shown(path.string()) + "': '" +
                shown(path.extension().string()) +
                "' files hold no tool paths; write .gcode, .dxf, .csv, .vtp, .ply or .obj");
  }
  write_file(
      path,
      [&](OutputStream& out) {
        if (lower_extension(path) == ".dxf") return write_dxf(out, paths, machine);
        GcodeWriter(out, paths, machine).write();
      },
      progress);
}

}  // namespace brindle
