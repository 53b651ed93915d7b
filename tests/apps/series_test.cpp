// Time series: `animate --series` and `stripe --previous`.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "brindle/direction_field.h"
#include "brindle/files.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "tool.h"

namespace brindle::test {
namespace {

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;
using Json = nlohmann::json;

std::string numbered(const std::string& before, int number, const std::string& after) {
  std::string digits = std::to_string(number);
  return before + std::string(4 - digits.size(), '0') + digits + after;
}

/// A field that no pattern fits without branches, turned a little at every step.
std::vector<Vec3> field_of_step(const Mesh& mesh, int step) {
  const float angle = 0.01f * static_cast<float>(step);
  const auto normals = vertex_normals(mesh);
  return rotated(projected_direction_field(Vec3(std::cos(angle), std::sin(angle), 0.3f), normals),
                 normals, 0.6f);
}

void write_field(const fs::path& path, const std::vector<Vec3>& field) {
  std::ofstream out(path);
  for (const Vec3& v : field) out << v.x() << ',' << v.y() << ',' << v.z() << '\n';
}

/// The same surface with other vertices and triangles at every step.
Mesh retriangulated_sphere(int step) {
  Mesh mesh = make_shape("sphere,resolution=" + std::to_string(24 + 2 * (step % 3)));
  std::mt19937 random(static_cast<unsigned>(step));
  std::normal_distribution<float> any;
  const Eigen::Quaternionf turn =
      Eigen::Quaternionf(any(random), any(random), any(random), any(random)).normalized();
  for (Vec3& position : mesh.positions) position = (turn * position).normalized();
  return mesh;
}

/// A mesh with a field as an array, and an id per vertex.
void write_step(const fs::path& path, const Mesh& mesh, const std::vector<Vec3>& field,
                const std::vector<std::int32_t>& ids = {}) {
  std::vector<DataArray> arrays = {make_data_array("velocity", field)};
  if (!ids.empty()) arrays.push_back(make_data_array("id", 1, ids));
  write_mesh(path, mesh, arrays);
}

/// Of a surface that beats, the standard deviation of each coordinate in units of its diagonal.
constexpr float kNoise = 5e-4f;

/// By how many radians such noise alone moves the phases at vertices a step, if so many stripes
/// stay where they are along the diagonal: the mean distance of two normal numbers.
double step_of_noise(double stripes, double noise_share = kNoise) {
  const double deviation = 2 * std::numbers::pi * stripes * noise_share;
  return deviation * std::sqrt(2.0) * std::sqrt(2 / std::numbers::pi);
}

struct Series : ToolTest {
  void write_csv_steps(int count) const {
    const Mesh mesh = make_shape("trefoil,resolution=48");
    write_mesh(folder / "knot.obj", mesh);
    for (int step = 0; step < count; ++step) {
      write_field(folder / numbered("f", step, ".csv"), field_of_step(mesh, step));
    }
  }
  void write_moving_steps(int count) const {
    const Mesh rest = make_shape("trefoil,resolution=48");
    for (int step = 0; step < count; ++step) {
      Mesh mesh = rest;
      for (Vec3& p : mesh.positions) {
        p *= 1 + 0.02f * std::sin(3 * p.x() + 0.2f * static_cast<float>(step));
      }
      write_step(folder / numbered("m", step, ".vtp"), mesh, field_of_step(mesh, step));
    }
  }
  /// A knot that beats, with noise of its own at every step: fields found anew turn freely.
  void write_beating_steps(int count, float noise_share = kNoise) const {
    const Mesh rest = make_shape("trefoil,resolution=48");
    const float noise = noise_share * bounding_box(rest).diagonal();
    for (int step = 0; step < count; ++step) {
      std::mt19937 random(static_cast<unsigned>(step));
      std::normal_distribution<float> any;
      Mesh mesh = rest;
      for (Vec3& p : mesh.positions) {
        p *= 1 + 0.004f * std::sin(2 * p.x() + 0.3f * static_cast<float>(step));
        p += noise * Vec3(any(random), any(random), any(random));
      }
      write_mesh(folder / numbered("b", step, ".vtp"), mesh, std::vector<DataArray>());
    }
  }
  void write_changing_steps(int count) const {
    for (int step = 0; step < count; ++step) {
      const Mesh mesh = retriangulated_sphere(step);
      write_step(folder / numbered("c", step, ".vtp"), mesh, field_of_step(mesh, step));
    }
  }
  Json report(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--report", "report.json", "--quiet"});
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.exit_code == 0 ? Json::parse(content(folder / "report.json")) : Json();
  }
};

/// The mean over the frames after the first.
double mean_of(const Json& frames, const std::string& key, bool from_scratch) {
  double sum = 0;
  for (std::size_t n = 1; n < frames.size(); ++n) {
    sum += (from_scratch ? frames[n]["from_scratch"] : frames[n])[key].get<double>();
  }
  return sum / static_cast<double>(frames.size() - 1);
}

/// Shares of what patterns have that are solved for afresh at every step.
void expect_steady(const Json& report, double most_step = 0.25, double most_energy = 1.1) {
  const Json& frames = report["frames"];
  EXPECT_LE(mean_of(frames, "phase_step", false), most_step * mean_of(frames, "phase_step", true));
  EXPECT_LE(mean_of(frames, "energy", false), most_energy * mean_of(frames, "energy", true));
}

TEST_F(Series, FieldsOverOneMeshAreCalm) {
  write_csv_steps(20);
  const Json report = this->report({"animate", "knot.obj", "--series", "f%04d.csv", "--stripes",
                                    "24", "--compare-from-scratch"});
  EXPECT_EQ(report["series"], "f%04d.csv");
  EXPECT_EQ(report["steps"], 20);
  ASSERT_EQ(report["frames"].size(), 20u);
  EXPECT_FALSE(report["frames"][0].contains("matched_by"));
  for (int n = 1; n < 20; ++n) {
    const Json& frame = report["frames"][static_cast<std::size_t>(n)];
    EXPECT_EQ(frame["file"], numbered("f", n, ".csv"));
    EXPECT_EQ(frame["time"], n);
    EXPECT_EQ(frame["matched_by"], "number");
    EXPECT_EQ(frame["vertices_unmatched"], 0);
  }
  expect_steady(report);
}

TEST_F(Series, MeshesThatMoveAreCalm) {
  write_moving_steps(20);
  const Json report = this->report({"animate", "--series", "m*.vtp", "--field", "array:velocity",
                                    "--stripes", "24", "--compare-from-scratch"});
  EXPECT_EQ(report["frames"][7]["matched_by"], "number");
  expect_steady(report);
}

TEST_F(Series, MeshesThatChangeAreCalm) {
  write_changing_steps(20);
  const Json report = this->report({"animate", "--series", "c%04d.vtp", "--field", "array:velocity",
                                    "--stripes", "16", "--compare-from-scratch"});
  for (std::size_t n = 1; n < 20; ++n) {
    EXPECT_EQ(report["frames"][n]["matched_by"], "position");
    EXPECT_EQ(report["frames"][n]["vertices_unmatched"], 0);
  }
  expect_steady(report);
}

TEST_F(Series, NumberAndPositionEndAlike) {
  write_csv_steps(4);
  const auto energies = [&](const std::string& matching) {
    const Json report = this->report(
        {"animate", "knot.obj", "--series", "f%04d.csv", "--stripes", "24", "--match", matching});
    EXPECT_EQ(report["frames"][3]["matched_by"], matching);
    return std::pair(report["frames"][3]["energy"].get<double>(),
                     report["frames"][3]["phase_step"].get<double>());
  };
  const auto by_number = energies("number"), by_position = energies("position");
  EXPECT_NEAR(by_number.first, by_position.first, 1e-3 * by_number.first);
  EXPECT_NEAR(by_number.second, by_position.second, 1e-3);
}

TEST_F(Series, FramesBetweenStepsAreInterpolated) {
  write_moving_steps(3);
  const Json steps = this->report(
      {"animate", "--series", "m%04d.vtp", "--field", "array:velocity", "--stripes", "24"});
  const Json report = this->report({"animate", "--series", "m%04d.vtp", "--field", "array:velocity",
                                    "--stripes", "24", "--interpolate", "3"});
  ASSERT_EQ(report["frames"].size(), 9u);
  EXPECT_TRUE(report["frames"][1]["file"].is_null());
  EXPECT_EQ(report["frames"][1]["time"], 0.25);
  EXPECT_EQ(report["frames"][4]["file"], "m0001.vtp");
  EXPECT_EQ(report["frames"][0]["energy"], steps["frames"][0]["energy"]);
  EXPECT_LT(report["mean"]["phase_step"], steps["mean"]["phase_step"]);
}

TEST_F(Series, OneStepIsAPatternFromScratch) {
  write_csv_steps(1);
  const Json report =
      this->report({"animate", "knot.obj", "--series", "f*.csv", "--stripes", "24"});
  const Json stripe =
      this->report({"stripe", "knot.obj", "--field", "f0000.csv", "--stripes", "24"});
  ASSERT_EQ(report["frames"].size(), 1u);
  EXPECT_NEAR(report["frames"][0]["energy"].get<double>(), stripe["energy"].get<double>(),
              0.02 * stripe["energy"].get<double>());
}

TEST_F(Series, StripesDoNotSwellWithTheMesh) {
  Mesh mesh = make_shape("sphere,resolution=20");
  for (int step = 0; step < 2; ++step) {
    write_step(folder / numbered("g", step, ".vtp"), mesh, field_of_step(mesh, step));
    for (Vec3& position : mesh.positions) position *= 2;
  }
  run({"animate", "--series", "g%04d.vtp", "--field", "array:velocity", "--output", "o%04d.vtp"});
  const auto frequency = [&](const char* file) {
    const LoadedMesh loaded = read_mesh(folder / file);
    const DataArray* array = find_array(loaded.arrays.points, "frequency");
    return array == nullptr ? -1 : measure_array(*array).maximum;
  };
  EXPECT_GT(frequency("o0000.vtp"), 0);
  EXPECT_EQ(frequency("o0000.vtp"), frequency("o0001.vtp"));
}

TEST_F(Series, WavesThatComeUpHaveNoLastPhase) {
  write_csv_steps(2);
  std::string field = content(folder / "f0000.csv");
  std::size_t end = 0;
  for (int row = 0; row < 40; ++row) end = field.find('\n', end) + 1;
  std::string none;
  for (int row = 0; row < 40; ++row) none += "nan,nan,nan\n";
  write_text(folder / "f0000.csv", none + field.substr(end));
  const Json report =
      this->report({"animate", "knot.obj", "--series", "f%04d.csv", "--stripes", "24"});
  EXPECT_EQ(report["vertices_without_wave"], 40);
  EXPECT_EQ(report["frames"][1]["matched_by"], "number");
  EXPECT_EQ(report["frames"][1]["vertices_unmatched"], 40);
}

TEST_F(Series, MetricsDoNotDependOnThreads) {
  write_changing_steps(3);
  const auto metrics = [&](const char* threads) {
    Json report = this->report({"animate", "--series", "c%04d.vtp", "--field", "array:velocity",
                                "--subdivide", "1", "--threads", threads});
    for (Json& frame : report["frames"]) frame.erase("milliseconds");
    return report["frames"];
  };
  EXPECT_EQ(metrics("1"), metrics("2"));
}

TEST_F(Series, MeshesOfStepsKeepArraysAndCanBePlayedAgain) {
  write_moving_steps(3);
  const Json first = this->report({"animate", "--series", "m%04d.vtp", "--field", "array:velocity",
                                   "--interpolate", "1", "--output", "out_%02d.vtp"});
  EXPECT_TRUE(listing().count("out.pvd"));
  EXPECT_TRUE(listing().count("out_02.vtp"));
  EXPECT_FALSE(listing().count("out_03.vtp")) << "a mesh per step, not per frame";
  const LoadedMesh loaded = read_mesh(folder / "out_02.vtp");
  for (const char* name : {"velocity", "phase", "direction", "frequency", "valid", "branch"}) {
    EXPECT_NE(find_array(loaded.arrays.points, name), nullptr) << name;
  }
  const Json again = this->report(
      {"animate", "--series", "out.pvd", "--field", "array:velocity", "--interpolate", "1"});
  ASSERT_EQ(again["frames"].size(), first["frames"].size());
  for (std::size_t n = 0; n < first["frames"].size(); ++n) {
    EXPECT_EQ(again["frames"][n]["energy"], first["frames"][n]["energy"]);
    EXPECT_EQ(again["frames"][n]["time"], first["frames"][n]["time"]);
  }
}

TEST_F(Series, TimesAreThoseOfThePvd) {
  write_moving_steps(2);
  write_text(folder / "run.pvd",
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\">\n<Collection>\n"
             "<DataSet timestep=\"2.5\" group=\"\" part=\"0\" file=\"m0001.vtp\"/>\n"
             "<DataSet timestep=\"0.5\" group=\"\" part=\"0\" file=\"m0000.vtp\"/>\n"
             "</Collection>\n</VTKFile>\n");
  const Json report = this->report({"animate", "--series", "run.pvd", "--field", "array:velocity"});
  EXPECT_EQ(report["frames"][0]["time"], 0.5);
  EXPECT_EQ(report["frames"][1]["time"], 2.5);
  EXPECT_EQ(report["frames"][1]["file"], "m0001.vtp");
}

TEST_F(Series, WildcardsGoByNumbers) {
  const Mesh mesh = make_shape("sphere,resolution=12");
  for (const int step : {10, 9, 2}) {
    write_mesh(folder / ("v" + std::to_string(step) + ".obj"), mesh);
  }
  const Json report = this->report({"animate", "--series", "v*.obj", "--direction", "1,0,0"});
  ASSERT_EQ(report["frames"].size(), 3u);
  EXPECT_EQ(report["frames"][0]["file"], "v2.obj");
  EXPECT_EQ(report["frames"][2]["file"], "v10.obj");
  EXPECT_TRUE(report["frames"][1]["unchanged"]);
  EXPECT_EQ(report["frames"][1]["time"], 9);
  EXPECT_EQ(report["frames"][2]["time"], 10);
  write_mesh(folder / "vx.obj", mesh);  // without a number: the places in the list
  const Json without = this->report({"animate", "--series", "v*.obj", "--direction", "1,0,0"});
  EXPECT_EQ(without["frames"][2]["time"], 2);
}

TEST_F(Series, VerticesThatAreSetAsideAreNoErrors) {
  const Mesh mesh = make_shape("sphere,resolution=12");
  for (const char* name : {"v0.obj", "v1.obj"}) {
    write_mesh(folder / name, mesh);
    write_text(folder / name, content(folder / name) + "v nan 0 0\n");
  }
  const Json report = this->report({"animate", "--series", "v%d.obj", "--direction", "1,0,0"});
  EXPECT_EQ(report["frames"].size(), 2u);
}

#ifdef BRINDLE_HAS_GL
TEST_F(Series, WritesPicturesAndMeshesOfChangingSurfaces) {
  write_changing_steps(3);
  const ToolResult result = run({"animate", "--series", "c%04d.vtp", "--field", "array:velocity",
                                 "--size", "64x48", "--output", "p%d.png", "--output", "s%d.vtp"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* file : {"p0.png", "p2.png", "s0.vtp", "s2.vtp", "s.pvd"}) {
    EXPECT_TRUE(listing().count(file)) << file;
  }
  EXPECT_NE(content(folder / "p0.png"), content(folder / "p2.png"));
}
#endif

// Smooth fields.

TEST_F(Series, SmoothFieldsFollowSurfacesThatMove) {
  write_beating_steps(20);
  // Nothing says at which angle a smooth field starts, and on a tube, how many branches a pattern
  // needs hangs on it. A field that follows keeps the angle of the first step, and one found anew
  // has any. So three angles that are spread evenly are compared with fields found anew together,
  // and each with its own first step, which is solved for alone.
  double energy = 0, energy_from_scratch = 0;
  for (const Arguments& turn : {Arguments{}, {"--rotate", "60"}, {"--along", "--rotate", "30"}}) {
    Arguments arguments = {"animate",   "--series", "b%04d.vtp",
                           "--stripes", "24",       "--compare-from-scratch"};
    arguments.insert(arguments.end(), turn.begin(), turn.end());
    const Json report = this->report(arguments);
    const Json& frames = report["frames"];
    EXPECT_LE(mean_of(frames, "phase_step", false), 0.1 * mean_of(frames, "phase_step", true));
    EXPECT_LE(mean_of(frames, "phase_step", false), step_of_noise(24));
    EXPECT_LE(mean_of(frames, "energy", false), 1.2 * frames[0]["energy"].get<double>());
    energy += mean_of(frames, "energy", false);
    energy_from_scratch += mean_of(frames, "energy", true);
    EXPECT_LT(report["mean"]["field_turned_deg"].get<double>(), 5);
    EXPECT_FALSE(frames[0].contains("field_turned_deg"));
    EXPECT_TRUE(frames[1].contains("field_turned_deg"));
  }
  EXPECT_LE(energy, 1.2 * energy_from_scratch);
}

TEST_F(Series, CurvatureFieldsFollowSurfacesThatMove) {
  const auto played = [&](float noise_share) {
    write_beating_steps(20, noise_share);
    return report({"animate", "--series", "b%04d.vtp", "--field", "curvature", "--stripes", "24",
                   "--compare-from-scratch"});
  };
  // Curvature holds the fields of single steps together, so that their patterns are alike by
  // themselves, but for what the noise of the vertices makes of any pattern that stands still.
  const Json steady = played(kNoise);
  expect_steady(steady, 0.3);
  EXPECT_LE(mean_of(steady["frames"], "phase_step", false), step_of_noise(24));
  // With more noise they are not.
  const Json noisy = played(2 * kNoise);
  expect_steady(noisy, 0.15, 1);
  EXPECT_LE(mean_of(noisy["frames"], "phase_step", false), step_of_noise(24, 2 * kNoise));
}

TEST_F(Series, SmoothFieldsFollowOntoOtherTriangles) {
  write_changing_steps(12);
  const Json report = this->report(
      {"animate", "--series", "c%04d.vtp", "--stripes", "16", "--compare-from-scratch"});
  EXPECT_EQ(report["frames"][3]["matched_by"], "position");
  expect_steady(report);
}

TEST_F(Series, WhatDoesNotFollowFindsItsFieldAnew) {
  write_beating_steps(3);
  const Json report = this->report(
      {"animate", "--series", "b%04d.vtp", "--stripes", "24", "--solver", "multilevel,lambda=0"});
  EXPECT_FALSE(report["mean"].contains("field_turned_deg"));
  const Json alone = this->report({"stripe", "b0002.vtp", "--frequency", "4"});
  const Json series = this->report({"animate", "--series", "b%04d.vtp", "--frequency", "4",
                                    "--solver", "multilevel,lambda=0", "--compare-from-scratch"});
  EXPECT_EQ(series["frames"][2]["energy"], series["frames"][2]["from_scratch"]["energy"]);
  EXPECT_NEAR(series["frames"][2]["energy"].get<double>(), alone["energy"].get<double>(),
              0.3 * alone["energy"].get<double>());
}

TEST_F(Series, AMeshThatStaysKeepsItsField) {
  write_beating_steps(2);
  fs::copy_file(folder / "b0001.vtp", folder / "b0002.vtp");
  for (const Arguments& turn : {Arguments{}, Arguments{"--rotate", "31"}}) {
    Arguments arguments = {"animate", "--series", "b%04d.vtp", "--stripes", "24"};
    arguments.insert(arguments.end(), turn.begin(), turn.end());
    const Json report = this->report(arguments);
    EXPECT_EQ(report["frames"][1]["unchanged"], false);
    EXPECT_EQ(report["frames"][2]["unchanged"], true);
    EXPECT_EQ(report["frames"][2]["field_turned_deg"], 0.0);
  }
}

TEST_F(Series, StepByStepFieldsFollowAsInASeries) {
  write_beating_steps(3);
  const Json series = this->report(
      {"animate", "--series", "b%04d.vtp", "--frequency", "4", "--output", "s%04d.vtp"});
  const auto step = [&](const std::string& parts, const Arguments& more = {}) {
    Arguments arguments = {"stripe", "b0002.vtp",  "--frequency",
                           "4",      "--previous", "s0001.vtp" + parts};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return this->report(arguments);
  };
  const Json last = step("");
  const Json& frame = series["frames"][2];
  EXPECT_NEAR(last["energy"].get<double>(), frame["energy"].get<double>(),
              0.02 * frame["energy"].get<double>());
  EXPECT_NEAR(last["phase_step"].get<double>(), frame["phase_step"].get<double>(), 0.05);
  EXPECT_NEAR(last["field_turned_deg"].get<double>(), frame["field_turned_deg"].get<double>(),
              0.05);
  EXPECT_FALSE(step(",lambda=0").contains("field_turned_deg"));
  EXPECT_FALSE(step("", {"--direction", "1,0,0"}).contains("field_turned_deg"));
  EXPECT_LT(step(",match=position")["phase_step"].get<double>(), 0.5);
  EXPECT_LT(step(",match=position", {"--points"})["field_turned_deg"].get<double>(), 10);
}

/// How far lines run apart on average, in degrees.
double degrees_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    sum += static_cast<double>(std::atan2(a[v].cross(b[v]).norm(), std::abs(a[v].dot(b[v]))));
  }
  return sum / static_cast<double>(a.size()) * 180 / std::numbers::pi;
}

TEST_F(Series, FieldsGoOnFromPatternsThatWereTurned) {
  write_beating_steps(2);
  const auto made = [&](const std::string& mesh, const std::string& to, const Arguments& more) {
    Arguments arguments = {"stripe", mesh, "--frequency", "4", "--output", to};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ToolResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.err;
  };
  const auto directions = [&](const std::string& file) {
    const LoadedMesh loaded = read_mesh(folder / file);
    const DataArray* array = find_array(loaded.arrays.points, "direction");
    std::vector<Vec3> result(loaded.mesh.vertex_count());
    EXPECT_NE(array, nullptr);
    if (array == nullptr) return result;
    std::memcpy(static_cast<void*>(result.data()), array->bytes.data(), array->bytes.size());
    return result;
  };
  const auto says_turn = [&](const std::string& file) {
    return find_array(read_mesh(folder / file).arrays.points, "turn_deg") != nullptr;
  };
  for (const std::string kind : {".vtp", ".ply", ".glb"}) {
    made("b0000.vtp", "plain" + kind, {});
    made("b0000.vtp", "turned" + kind, {"--along", "--rotate", "20"});
    EXPECT_FALSE(says_turn("plain" + kind));
    EXPECT_TRUE(says_turn("turned" + kind));
    EXPECT_EQ(made("b0001.vtp", "a.vtp", {"--previous", "plain" + kind}).find("turned"),
              std::string::npos);
    const std::string note = made("b0001.vtp", "b.vtp", {"--previous", "turned" + kind});
    EXPECT_NE(note.find("by 110 degrees, these by 0"), std::string::npos) << note;
    EXPECT_LT(degrees_apart(directions("a.vtp"), directions("b.vtp")), 0.1) << kind;
  }
  // A turn that changes from step to step turns the waves, and leaves their field alone.
  made("b0001.vtp", "c.vtp", {"--previous", "turned.vtp", "--rotate", "31"});
  EXPECT_NEAR(degrees_apart(directions("a.vtp"), directions("c.vtp")), 31, 0.1);
  // What an input says of other waves does not go along.
  made("turned.vtp", "again.vtp", {});
  EXPECT_FALSE(says_turn("again.vtp"));
}

/// Noise of its own in every step.
TEST_F(Series, FieldsWithAMemoryJumpLess) {
  const Mesh mesh = make_shape("trefoil,resolution=48");
  const std::vector<Vec3> normals = vertex_normals(mesh);
  write_mesh(folder / "knot.obj", mesh);
  std::mt19937 random(3);
  std::normal_distribution<float> any(0, 0.5f);
  for (int step = 0; step < 6; ++step) {
    std::vector<Vec3> field = field_of_step(mesh, step);
    for (std::size_t v = 0; v < field.size(); ++v) {
      const float angle = any(random);
      field[v] = std::cos(angle) * field[v] + std::sin(angle) * normals[v].cross(field[v]);
    }
    write_field(folder / numbered("f", step, ".csv"), field);
  }
  const auto steps = [&](const std::string& memory) {
    Arguments options = {"animate",           "knot.obj", "--series",  "f%04d.csv",
                         "--field-smoothing", "0.3",      "--stripes", "25"};
    if (!memory.empty()) options.insert(options.end(), {"--temporal-smoothing", memory});
    const Json frames = report(options)["frames"];
    double sum = 0;
    for (std::size_t f = 2; f < frames.size(); ++f) sum += frames[f]["phase_step"].get<double>();
    return sum / static_cast<double>(frames.size() - 2);
  };
  const double without = steps("");
  EXPECT_EQ(steps("0"), without);
  EXPECT_LT(steps("4"), 0.75 * without);
}

struct SeriesErrors : Series {
  void SetUp() override {
    Series::SetUp();
    write_csv_steps(3);
  }
};

TEST_F(SeriesErrors, NameTheFile) {
  fs::remove(folder / "f0001.csv");
  expect_refusal(1, "f0001.csv", {"animate", "knot.obj", "--series", "f%04d.csv"});
  write_text(folder / "f0001.csv", "1,0,0\n0,1,0\n");
  expect_refusal(1, "f0001.csv", {"animate", "knot.obj", "--series", "f%04d.csv"});
  write_text(folder / "f0001.csv", "");
  expect_refusal(1, "f0001.csv", {"animate", "knot.obj", "--series", "f%04d.csv"});
  expect_refusal(1, "none%d.csv", {"animate", "knot.obj", "--series", "none%d.csv"});
  expect_refusal(1, "none*.csv", {"animate", "knot.obj", "--series", "none*.csv"});
  expect_refusal(1, "nowhere", {"animate", "knot.obj", "--series", "nowhere/f%d.csv"});
  expect_refusal(1, "none.pvd", {"animate", "--series", "none.pvd"});
}

TEST_F(SeriesErrors, NameTheFileWithoutANumber) {
  Mesh mesh = make_shape("sphere,resolution=8");
  write_mesh(folder / "v0.obj", mesh);
  std::string text = content(folder / "v0.obj");
  text.replace(text.find("v "), 3, "v nan");
  write_text(folder / "v1.obj", text);
  expect_refusal(1, "v1.obj", {"animate", "--series", "v%d.obj", "--direction", "1,0,0"});
}

TEST_F(SeriesErrors, OtherTrianglesCannotBeInterpolated) {
  write_mesh(folder / "v0.obj", make_shape("sphere,resolution=8"));
  write_mesh(folder / "v1.obj", make_shape("sphere,resolution=9"));
  const Arguments series = {"animate", "--series", "v%d.obj", "--direction", "1,0,0"};
  Arguments with_between = series, by_number = series;
  with_between.insert(with_between.end(), {"--interpolate", "1"});
  expect_refusal(1, "v1.obj", with_between);
  by_number.insert(by_number.end(), {"--match", "number"});
  expect_refusal(1, "v1.obj", by_number);
  EXPECT_EQ(run(series).exit_code, 0);
}

TEST_F(SeriesErrors, OfAPvdAreNamed) {
  const auto refused = [&](const std::string& message, const std::string& text) {
    write_text(folder / "bad.pvd", text);
    expect_refusal(1, message, {"animate", "--series", "bad.pvd"});
  };
  refused("bad.pvd", "no xml");
  refused("bad.pvd", "<VTKFile/>");
  refused("lists no file", "<VTKFile><Collection/></VTKFile>");
  refused("timestep", "<VTKFile><Collection><DataSet file=\"a.vtp\"/></Collection></VTKFile>");
  refused("same timestep",
          "<VTKFile><Collection><DataSet timestep=\"1\" file=\"a.vtp\"/>"
          "<DataSet timestep=\"1\" part=\"1\" file=\"b.vtp\"/></Collection></VTKFile>");
  refused("a.vtp",
          "<VTKFile><Collection><DataSet timestep=\"1\" file=\"a.vtp\"/></Collection></VTKFile>");
}

TEST_F(SeriesErrors, WrongUsageEndsWithCodeTwo) {
  const Arguments csv = {"animate", "knot.obj", "--series", "f%04d.csv"};
  const auto refused = [&](const std::string& option, Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_refusal(2, option, arguments);
  };
  refused("--scene", csv, {"--scene", "zoom"});
  refused("--frames", csv, {"--frames", "4"});
  refused("--temporal-smoothing", csv, {"--temporal-smoothing", "1"});
  refused("--field-smoothing", {"animate", "shape:sphere"}, {"--field-smoothing", "1"});
  refused("--temporal-smoothing", {"animate", "shape:sphere"}, {"--temporal-smoothing", "1"});
  refused("--field", csv, {"--field", "smooth"});
  refused("--direction", csv, {"--direction", "1,0,0"});
  refused("--device", csv, {"--device", "gpu"});
  refused("--match", csv, {"--interpolate", "1", "--match", "position"});
  refused("--match", csv, {"--match", "colour"});
  refused("--match", csv, {"--match", "id:"});
  refused("--interpolate", csv, {"--interpolate", "-1"});
  refused("--curvature-anchor", csv, {"--curvature-anchor", "1"});
  refused("f0001.csv", csv, {"--output", "f%04d.png", "--report", "f0001.csv"});
  refused("--output", csv, {"--output", "f%04d.csv"});
  refused("MESH", {"animate", "--series", "f%04d.csv"}, {});
  refused("MESH", {"animate", "knot.obj", "--series", "kn*.obj"}, {});
  refused("--series", {"animate", "--series", "knot.obj"}, {});
  refused("--series", {"animate", "--series", ""}, {});
  refused("MESH", {"animate"}, {});
  const Arguments scene = {"animate", "knot.obj", "--frames", "2"};
  refused("--interpolate", scene, {"--interpolate", "2"});
  refused("--match", scene, {"--match", "number"});
  refused("--field", scene, {"--field", "smooth"});
  refused("--rotate", scene, {"--rotate", "10"});
  refused("--frequency", scene, {"--frequency", "array:f"});
  refused("--output", scene, {"--output", "%04d.vtp"});
}

TEST_F(SeriesErrors, StepsAreNotOverwritten) {
  write_mesh(folder / "v0.vtp", make_shape("sphere,resolution=8"));
  expect_refusal(2, "v0.vtp",
                 {"animate", "--series", "v%d.vtp", "--direction", "1,0,0", "--output", "v%d.vtp"});
}

// One step at a time.

struct Previous : Series {
  void SetUp() override {
    Series::SetUp();
    const Mesh mesh = make_shape("trefoil,resolution=48");
    std::vector<std::int32_t> ids;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) ids.push_back(static_cast<int>(v) + 100);
    for (int step = 0; step < 2; ++step) {
      write_step(folder / numbered("s", step, ".vtp"), mesh, field_of_step(mesh, 3 * step), ids);
    }
    EXPECT_EQ(run(stripe(0, {"--output", "last.vtp"})).exit_code, 0);
  }
  Arguments stripe(int step, const Arguments& more) const {
    Arguments arguments = {
        "stripe", numbered("s", step, ".vtp"), "--field", "array:velocity", "--stripes", "24"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

TEST_F(Previous, StaysNear) {
  const Json scratch = report(stripe(1, {"--previous", "last.vtp,lambda=0"}));
  const Json anchored = report(stripe(1, {"--previous", "last.vtp"}));
  EXPECT_EQ(anchored["matched_by"], "number");
  EXPECT_EQ(anchored["vertices_unmatched"], 0);
  EXPECT_EQ(anchored["lambda"], 0.025);
  EXPECT_EQ(anchored["previous"], "last.vtp");
  EXPECT_LT(anchored["phase_step"].get<double>(), 0.5 * scratch["phase_step"].get<double>());
  const Json alone = report(stripe(1, {}));
  EXPECT_EQ(scratch["energy"], alone["energy"]);
  EXPECT_FALSE(alone.contains("matched_by"));
}

TEST_F(Previous, MatchesByNumberIdAndPositionAlike) {
  const auto step_by = [&](const std::string& matching, const std::string& name) {
    const Json result = report(stripe(1, {"--previous", "last.vtp,match=" + matching}));
    EXPECT_EQ(result["matched_by"], name);
    EXPECT_EQ(result["vertices_unmatched"], 0);
    return result["phase_step"].get<double>();
  };
  const double by_number = step_by("number", "number");
  EXPECT_EQ(step_by("id:id", "id"), by_number);
  EXPECT_NEAR(step_by("position", "position"), by_number, 1e-3);
}

TEST_F(Previous, OntoAnotherMeshGoesByPosition) {
  const Json finer = report(stripe(1, {"--previous", "last.vtp", "--subdivide", "1"}));
  EXPECT_EQ(finer["matched_by"], "position");
  EXPECT_EQ(finer["vertices_unmatched"], 0);
  const Json scratch = report(stripe(1, {"--previous", "last.vtp,lambda=0", "--subdivide", "1"}));
  EXPECT_LT(finer["phase_step"].get<double>(), 0.5 * scratch["phase_step"].get<double>());
  expect_refusal(1, "last.vtp",
                 stripe(1, {"--previous", "last.vtp,match=number", "--subdivide", "1"}));
}

TEST_F(Previous, IsSaidInText) {
  const ToolResult result = run(stripe(1, {"--previous", "last.vtp"}));
  EXPECT_NE(result.out.find("matched by number"), std::string::npos) << result.out;
}

TEST_F(Previous, FollowsPoints) {
  EXPECT_EQ(run(stripe(0, {"--points", "--output", "points.ply"})).exit_code, 0);
  const Json followed = report(stripe(1, {"--points", "--previous", "points.ply"}));
  EXPECT_EQ(followed["matched_by"], "number");
  const Json by_position =
      report(stripe(1, {"--points", "--previous", "points.ply,match=position"}));
  EXPECT_NEAR(followed["phase_step"].get<double>(), by_position["phase_step"].get<double>(), 1e-3);
}

TEST_F(Previous, RefusesWhatItCannotFollow) {
  const auto refused = [&](int code, const std::string& message, const Arguments& more) {
    expect_refusal(code, message, stripe(1, more));
  };
  refused(1, "none.vtp", {"--previous", "none.vtp"});
  refused(1, "'phase'", {"--previous", "s0000.vtp"});
  refused(1, "'label'", {"--previous", "last.vtp,match=id:label"});
  refused(2, "--lambda: is written as --previous ...,lambda=L", {"--lambda", "0.1"});
  refused(2, "--match: is written as --previous ...,match=", {"--match", "number"});
  refused(2, "--previous ...,lambda=L", {"--previous", "last.vtp,lambda=-1"});
  refused(2, "--previous", {"--previous", "last.vtp", "--solver", "relaxation"});
  refused(2, "--previous", {"--previous", "last.vtp", "--texture", "checker"});
  refused(2, "last.vtp", {"--previous", "last.vtp", "--output", "last.vtp"});
}

TEST_F(Previous, IdsMustDiffer) {
  const Mesh mesh = make_shape("trefoil,resolution=48");
  write_step(folder / "same.vtp", mesh, field_of_step(mesh, 0),
             std::vector<std::int32_t>(mesh.vertex_count(), 7));
  EXPECT_EQ(run({"stripe", "same.vtp", "--field", "array:velocity", "--output", "same_last.vtp"})
                .exit_code,
            0);
  expect_refusal(1, "ids must differ",
                 {"stripe", "same.vtp", "--field", "array:velocity", "--previous",
                  "same_last.vtp,match=id:id"});
}

}  // namespace
}  // namespace brindle::test
