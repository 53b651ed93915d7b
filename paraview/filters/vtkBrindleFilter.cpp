#include "vtkBrindleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <brindle/carried_phases.h>
#include <brindle/error.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>

#include "filter_run.h"
#include "pattern_series.h"
#include "ranks.h"
#include "surface_cache.h"
#include "warnings.h"
#include "wave_settings.h"

using brindle::Error;
namespace bp = brindle::paraview;

namespace {

float number(double value) { return static_cast<float>(value); }

}  // namespace

struct vtkBrindleFilter::State {
  bp::SurfaceCache surfaces;
  bp::PatternSeries series;
  /// For `made_surface` and `made_settings`: smooth fields take longer than patterns.
  brindle::DirectionField made_directions;
  bp::PatternSurface made_surface;
  std::pair<int, int> made_settings;
  bool made_follows = false;  ///< continued from those of the last time
  /// For TemporalSmoothing: the last smoothed field, and the one it continued.
  struct {
    brindle::DirectionField seen, before;
    bp::PatternSurface surface;
  } memory;
  std::optional<double> last_time;
  vtkMTimeType settings_time = 0;  ///< of the filter, in the last run
  int warned_surface = 0;          ///< whose ids were checked, by SurfacesMade

  /// The relation to the last run. The same on all ranks.
  struct Step {
    bool goes_on = false;  ///< time advances, and no setting was changed
    bool follows = false;  ///< the same, and phases and smooth fields continue the last ones
    bool repeats = false;  ///< neither time nor settings were changed
  };

  /// Collective. A result must not depend on the history of settings nor, if played from the start,
  /// on earlier results: only advancing time continues the last result.
  Step step_to(const std::optional<double>& time, vtkBrindleFilter& filter,
               const bp::Ranks& ranks) const {
    const bool same_settings = settings_time == filter.GetMTime();
    const bool goes_on = time && last_time && *time > *last_time;
    return {ranks.every(goes_on && same_settings),
            ranks.every(goes_on && filter.TimeAnchor > 0 && same_settings),
            ranks.every(time == last_time && same_settings)};
  }

  /// Collective; all ranks have a new surface if one has. Directions continue those of the last
  /// time on the same connectivity, as patterns do.
  const brindle::DirectionField& directions(const bp::PatternSurface& surface,
                                            const bp::WaveSettings& settings, const Step& step) {
    const std::pair<int, int> wanted = {static_cast<int>(settings.field),
                                        static_cast<int>(settings.curvature_direction)};
    const bool same_surface = made_surface.surface == surface.surface && made_settings == wanted;
    if (same_surface && (!made_follows || step.follows || step.repeats)) return made_directions;
    const bool follows = step.follows && made_settings == wanted &&
                         bp::same_connectivity_everywhere(made_surface, surface);
    brindle::DirectionField last;
    if (follows) {
      const brindle::Surface& before = *made_surface.surface;
      last = brindle::matched_directions({before.mesh, before.normals, made_directions},
                                         *surface.surface);
    }
    made_surface = {};
    made_directions =
        bp::made_directions(*surface.surface, settings, surface.piece.get(), std::move(last));
    made_settings = wanted;
    made_surface = surface;
    made_follows = follows;
    return made_directions;
  }

  /// Collective. The last time's field on this surface, or empty at the start of a series.
  brindle::DirectionField remembered(const bp::PatternSurface& surface,
                                     const bp::WaveSettings& settings, const Step& step) {
    const brindle::FieldSmoothingOptions& smoothing = settings.request.smoothing;
    if (smoothing.memory == 0 || smoothing.periods == 0 || memory.surface.surface == nullptr)
      return {};
    if (step.repeats && memory.surface.surface == surface.surface) return memory.before;
    if (!step.goes_on || !bp::same_connectivity_everywhere(memory.surface, surface)) return {};
    const brindle::Surface& before = *memory.surface.surface;
    if (memory.seen.size() != before.mesh.vertex_count()) return {};  // there were no data
    return brindle::matched_directions({before.mesh, before.normals, memory.seen},
                                       *surface.surface);
  }

  static void set_smoothing(const vtkBrindleFilter& filter, brindle::WaveRequest& request) {
    brindle::FieldSmoothingOptions& field = request.smoothing;
    field.periods = number(filter.FieldSmoothing);
    field.fill = request.frequency_smoothing.fill = number(filter.FillPeriods);
    field.symmetry = filter.FieldArrows ? 1 : 2;
    field.memory = number(filter.TemporalSmoothing);
    if (filter.FieldSingularities >= 0) {
      field.singularities = static_cast<std::size_t>(filter.FieldSingularities);
    }
    request.frequency_smoothing.periods = number(filter.FrequencySmoothing);
    const auto check_periods = [](float periods, const std::string& name) {
      if (periods >= 0 && periods <= 100) return;
      throw Error(name + " must be a number of periods from 0 to 100");
    };
    check_periods(field.periods, "Field Smoothing");
    check_periods(request.frequency_smoothing.periods, "Frequency Smoothing");
    if (!std::isfinite(field.memory) || field.memory < 0) {
      throw Error("Temporal Smoothing must be 0 or above");
    }
  }

  /// The filter's properties. Throws Error for an invalid angle or anchor; other numbers are
  /// checked where they are used.
  static bp::WaveSettings settings_of(const vtkBrindleFilter& filter) {
    bp::WaveSettings settings;
    settings.field = static_cast<bp::FieldSource>(filter.Field);
    settings.curvature_direction =
        static_cast<brindle::CurvatureDirection>(filter.CurvatureDirection);
    settings.tensor_axis = static_cast<brindle::TensorAxis>(filter.TensorAxis);
    for (int i = 0; i < 3; ++i) settings.direction[i] = number(filter.Direction[i]);
    set_smoothing(filter, settings.request);
    if (settings.field != bp::FieldSource::array) settings.request.smoothing.periods = 0;
    settings.request.turn_deg = number(filter.Rotate) + (filter.Along ? 90.0f : 0.0f);
    if (!std::isfinite(settings.request.turn_deg)) {
      throw Error("Rotate must be a finite number of degrees");
    }
    if (!std::isfinite(filter.TimeAnchor) || filter.TimeAnchor < 0) {
      throw Error("Time Anchor must be 0 or above");
    }
    settings.frequency_source = static_cast<bp::FrequencySource>(filter.FrequencySource);
    if (!settings.needs_frequency_array()) settings.request.frequency_smoothing.periods = 0;
    settings.stripes = number(filter.Stripes);
    settings.frequency = number(filter.Frequency);
    settings.spacing = number(filter.Spacing);
    settings.range.lowest = number(filter.FrequencyRange[0]);
    settings.range.highest = number(filter.FrequencyRange[1]);
    return settings;
  }
};

namespace {

/// Collective. The time of the data in a series, from the lowest rank that has it.
std::optional<double> time_of(vtkDataObject* data, const bp::Ranks& ranks) {
  vtkInformation* information = data->GetInformation();
  const bool knows = information->Has(vtkDataObject::DATA_TIME_STEP()) != 0;
  const double own = knows ? information->Get(vtkDataObject::DATA_TIME_STEP())
                           : std::numeric_limits<double>::quiet_NaN();
  for (const double time : ranks.all(own)) {
    if (!std::isnan(time)) return time;
  }
  return std::nullopt;
}

/// The panel's name for no array.
constexpr const char* kNoArray = "None";

struct ChosenArray {
  std::optional<brindle::DataArray> of_points;  ///< a row per vertex
  std::optional<brindle::DataArray> of_cells;   ///< of cells: unchanged, if requested
};

/// The array selected for a use, if any.
ChosenArray chosen_array(vtkAlgorithm& filter, int use, const bp::InputSurface& input,
                         bool cells = false,
                         brindle::TensorOrder order = brindle::TensorOrder::vtk) {
  vtkInformation* chosen = filter.GetInputArrayInformation(use);
  const char* name = chosen->Get(vtkDataObject::FIELD_NAME());
  if (name == nullptr || *name == '\0' || std::string_view(name) == kNoArray) return {};
  const bool points =
      chosen->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const auto ordered = [&](brindle::DataArray rows) {
    if (order == brindle::TensorOrder::vtk) return rows;
    return brindle::in_vtk_order(rows, order);
  };
  if (points) return {ordered(input.array_of_vertices(name)), std::nullopt};
  const brindle::DataArray rows = ordered(input.array_of_triangles(name));
  ChosenArray array{input.cells_to_points(rows), std::nullopt};
  if (cells) array.of_cells = rows;
  return array;
}

const brindle::DataArray* pointer_to(const std::optional<brindle::DataArray>& array) {
  return array ? &*array : nullptr;
}

}  // namespace

vtkBrindleFilter::vtkBrindleFilter() : Internals(std::make_unique<State>()) {
  this->SetNumberOfInputPorts(1);
}

vtkBrindleFilter::~vtkBrindleFilter() = default;

int vtkBrindleFilter::GetSurfacesMade() const { return this->Internals->surfaces.surfaces_made(); }
int vtkBrindleFilter::GetSolversMade() const { return this->Internals->series.solvers_made(); }
int vtkBrindleFilter::GetPatternsFollowed() const {
  return this->Internals->series.patterns_followed();
}
double vtkBrindleFilter::GetSolveMilliseconds() const {
  return this->Internals->series.solve_milliseconds();
}

int vtkBrindleFilter::FillInputPortInformation(int, vtkInformation* info) {
  // Whole composite data instead of single blocks: stripes continue between blocks.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkBrindleFilter::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                  vtkInformationVector* outputs) {
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  if (this->Stopped) this->SetAbortExecute(0);  // handled; VTK does not reset it
  this->Stopped = false;
  Run run;
  try {
    run.ranks = bp::Ranks::of_controller();
    run.progress = [this](double begin, double end) {
      return brindle::Progress([this, begin, end](std::string_view, double fraction) {
        const double done = begin + (end - begin) * std::clamp(fraction, 0.0, 1.0);
        this->UpdateProgress(std::max(done, this->GetProgress()));
        return !this->CheckAbort();
      });
    };
    if (this->Prepare(vtkDataObject::GetData(inputs[0]), run)) {
      this->Fill(run, output);
      this->WarnOf(run);
    }
  } catch (const brindle::Cancelled&) {
    output->Initialize();
    this->Stopped = true;
  } catch (const brindle::Error& error) {
    this->Fail(output, error.what());
  } catch (const std::bad_alloc&) {
    this->Fail(output, "there is not enough memory");
    this->EndIfOthersWait(run);
  } catch (const std::exception& error) {
    this->Fail(output, error.what());
    this->EndIfOthersWait(run);
  }
  return 1;
}

/// Returns whether there is work.
bool vtkBrindleFilter::Prepare(vtkDataObject* input, Run& run) {
  if (run.ranks.any(input == nullptr)) return false;
  State& state = *this->Internals;
  run.begin(0, 0.1, "surface");
  run.input = state.surfaces.surface_of(input, this, run.ranks, number(this->CreaseAngle));
  run.begin(0.1, 0.4, "field");
  if (run.input == nullptr) return false;

  bp::WaveSettings settings;
  run.ranks.throw_on_all([&] { settings = State::settings_of(*this); });
  ChosenArray vectors, frequencies, weights;
  const bool is_seen = settings.request.smoothing.periods > 0;
  if (settings.field == bp::FieldSource::array) {
    const auto order = static_cast<brindle::TensorOrder>(this->TensorOrder);
    vectors = chosen_array(*this, 0, *run.input, is_seen, order);
  }
  if (settings.needs_frequency_array()) frequencies = chosen_array(*this, 1, *run.input);
  if (is_seen) weights = chosen_array(*this, 2, *run.input, true);
  const std::optional<double> time = time_of(input, run.ranks);
  const State::Step step = state.step_to(time, *this, run.ranks);
  run.follows = step.follows;
  brindle::DirectionField made;
  if (settings.is_made()) made = state.directions(run.surface(), settings, step);
  brindle::DirectionField last = state.remembered(run.surface(), settings, step);
  brindle::WaveResult waves = bp::make_waves(
      *run.input->surface, settings, std::move(made),
      {pointer_to(vectors.of_points), pointer_to(frequencies.of_points),
       pointer_to(weights.of_points), pointer_to(vectors.of_cells), pointer_to(weights.of_cells)},
      last, run.input->piece.get());
  run.waves = std::move(waves.waves);
  run.support = std::move(waves.support);
  run.metrics.turned_apart = waves.turned_apart;
  run.metrics.smoothing = waves.smoothing;
  state.memory = {std::move(waves.seen_field), std::move(last), run.surface()};
  run.turn_deg = settings.request.turn_deg;
  run.metrics.waves = bp::wave_metrics(run.surface(), run.waves);
  run.metrics.measured = settings.field == bp::FieldSource::array && !is_seen;
  run.options = {number(this->Slack), number(this->TimeAnchor)};
  run.series = &state.series;
  state.last_time = time;
  state.settings_time = this->GetMTime();
  return true;
}

/// Notes known on all ranks are printed by the first one.
void vtkBrindleFilter::WarnOf(const Run& run) {
  if (run.ranks.rank() != 0) return;
  const int surfaces = this->GetSurfacesMade();
  if (run.input->ids_refused && this->Internals->warned_surface != surfaces) {
    vtkWarningMacro(<< "the points' global ids are no numbers in the whole surface: some are "
                       "missing, below zero, or of several places. Points at exactly the same "
                       "place are one vertex; apply Generate Global Ids, or leave the array out");
  }
  this->Internals->warned_surface = surfaces;
  for (const std::string& sentence : bp::warnings_of(run.metrics, run.surface()))
    vtkWarningMacro(<< sentence);
  if (run.series->lost_track()) {
    vtkWarningMacro(<< "the stripes do not follow those of the time before: the surface has other "
                       "cells, and its vertices are not known by global ids or by their places. "
                       "Apply Generate Global Ids before cells are dealt anew, or set Time Anchor "
                       "to 0");
  }
}

void vtkBrindleFilter::Fail(vtkPolyData* output, const char* message) {
  output->Initialize();
  vtkErrorMacro(<< message);
}

/// Shared errors are raised on all ranks. After other errors, the remaining ranks would wait
/// forever.
void vtkBrindleFilter::EndIfOthersWait(const Run& run) {
  if (!run.ranks.alone()) run.ranks.abort();
}

void vtkBrindleFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Field: " << this->Field << '\n'
     << indent << "Along: " << this->Along << '\n'
     << indent << "FieldSmoothing: " << this->FieldSmoothing << '\n'
     << indent << "Rotate: " << this->Rotate << '\n'
     << indent << "FrequencySource: " << this->FrequencySource << '\n'
     << indent << "Stripes: " << this->Stripes << '\n'
     << indent << "Frequency: " << this->Frequency << '\n'
     << indent << "Spacing: " << this->Spacing << '\n'
     << indent << "Slack: " << this->Slack << '\n'
     << indent << "TimeAnchor: " << this->TimeAnchor << '\n'
     << indent << "SurfacesMade: " << this->GetSurfacesMade() << '\n'
     << indent << "SolversMade: " << this->GetSolversMade() << '\n'
     << indent << "PatternsFollowed: " << this->GetPatternsFollowed() << '\n';
}
