#include "jobs/series.h"

#include <utility>

#include "brindle/base/file_names.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "input/followed_field.h"
#include "input/vertex_values.h"
#include "jobs/series_files.h"

namespace brindle::tool {
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
