/// Waves from options, of one process or of MPI ranks.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/array_field.h"
#include "brindle/carried_phases.h"
#include "brindle/data_arrays.h"
#include "brindle/direction_field.h"
#include "brindle/frequency_field.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/recipe/field_data.h"
#include "brindle/recipe/wave_report.h"
#include "brindle/smooth_field.h"
#include "brindle/strokes.h"
#include "brindle/surface.h"
#include "brindle/tensor_field.h"
#include "brindle/wave_metrics.h"
#include "brindle/waves_of.h"
#include "input/array_source.h"
#include "input/vertex_values.h"
#include "input/wave_options.h"

namespace brindle::tool {

/// Reads a file with rows for the whole mesh's vertices, of which there are `vertices`; rows may be
/// those of the mesh's file (`Preparation::vertex_of_row`).
using ReadRows = std::function<std::vector<DataArray>(std::size_t vertices,
                                                      std::span<const Index> vertex_of_row)>;

/// Of one process, or of a partition of a surface that several processes share; functions of a
/// partition are collective, and return what one process has, at the vertices here. Arrays have a
/// row per vertex here.
class WaveSource {
 public:
  virtual ~WaveSource() = default;

  virtual const WaveSurface& surface() const = 0;
  virtual const Mesh& mesh() const = 0;  ///< here
  virtual float diagonal() const = 0;
  virtual std::string file() const = 0;  ///< of the mesh, for messages

  /// Runs `work`. What it throws on one process, it throws on all.
  virtual void check(const std::function<void()>& work) const = 0;

  /// The arrays that `read` returns, at vertices. `option` names the file.
  virtual std::vector<DataArray> rows(const std::string& option, const std::string& file,
                                      const ReadRows& read) const = 0;
  virtual std::size_t nonfinite_rows(const DataArray& array) const = 0;
  virtual GlobeRadii globe_radii() const = 0;

  /// As `ArraySource` has them.
  virtual ArraySource::PerVertex array(const std::string& name) const = 0;
  virtual std::optional<std::size_t> drop_too_far(DirectionField& directions) const = 0;
  virtual bool is_near(Index vertex) const = 0;
  virtual std::string notes() const = 0;

  /// As `vertex_values`.
  virtual VertexValues values(const std::string& option, const std::string& text) const = 0;

  /// Fields and frequencies of the whole surface.
  virtual DirectionField smooth_field(const SmoothFieldOptions& options,
                                      const Progress& progress) const = 0;
  virtual DirectionField curvature_field(CurvatureDirection direction,
                                         const Progress& progress) const = 0;
  virtual std::vector<FieldStroke> strokes_of_file(const std::string& path) const = 0;
  virtual std::vector<FieldAnchor> anchors(std::span<const FieldStroke> strokes,
                                           const Progress& progress) const = 0;
  virtual DirectionField vector_field(const DataArray& vectors, bool signs) const = 0;
  virtual TensorField tensor_field(const DataArray& tensors, TensorAxis axis) const = 0;
  virtual FrequencyField frequencies_by(const DataArray& values, float frequency,
                                        const FrequencyRange& range) const = 0;

  virtual WaveMetrics measure(const WaveSet& waves) const = 0;
};

/// Data of the mesh's file besides the mesh.
struct FileData {
  std::string name;          ///< of the file
  const DataArrays& arrays;  ///< a row per vertex of the surface, and per triangle
  /// For field files with a row per vertex of the mesh's file (`Preparation`).
  std::span<const Index> vertex_of_row = {};
  const Viewpoint* viewpoint = nullptr;  ///< of pictures; null: none
};

/// Of one process. Refers to its arguments.
class WholeSource final : public WaveSource {
 public:
  WholeSource(const Surface& surface, FileData data, const ArrayOptions& options,
              std::shared_ptr<const ArraySource> arrays = nullptr);

  /// Of the surface's file or another one; refers to the surface and the data.
  std::shared_ptr<const ArraySource> arrays() const { return arrays_; }

  const WaveSurface& surface() const override { return waves_; }
  const Mesh& mesh() const override { return surface_.mesh; }
  float diagonal() const override { return bounding_box(surface_.mesh).diagonal(); }
  std::string file() const override { return data_.name; }
  void check(const std::function<void()>& work) const override { work(); }
  std::vector<DataArray> rows(const std::string& option, const std::string& file,
                              const ReadRows& read) const override;
  std::size_t nonfinite_rows(const DataArray& array) const override;
  GlobeRadii globe_radii() const override { return brindle::globe_radii(surface_.mesh); }
  ArraySource::PerVertex array(const std::string& name) const override {
    return arrays_->array(name);
  }
  std::optional<std::size_t> drop_too_far(DirectionField& directions) const override {
    return arrays_->drop_too_far(directions);
  }
  bool is_near(Index vertex) const override { return arrays_->is_near(vertex); }
  std::string notes() const override { return arrays_->notes(); }
  VertexValues values(const std::string& option, const std::string& text) const override;
  DirectionField smooth_field(const SmoothFieldOptions& options,
                              const Progress& progress) const override;
  DirectionField curvature_field(CurvatureDirection direction,
                                 const Progress& progress) const override;
  std::vector<FieldStroke> strokes_of_file(const std::string& path) const override;
  std::vector<FieldAnchor> anchors(std::span<const FieldStroke> strokes,
                                   const Progress& progress) const override;
  DirectionField vector_field(const DataArray& vectors, bool signs) const override;
  TensorField tensor_field(const DataArray& tensors, TensorAxis axis) const override;
  FrequencyField frequencies_by(const DataArray& values, float frequency,
                                const FrequencyRange& range) const override;
  WaveMetrics measure(const WaveSet& waves) const override;

 private:
  const Surface& surface_;
  const WholeSurface waves_;
  const FileData data_;
  const ArrayOptions& options_;
  std::shared_ptr<const ArraySource> arrays_;
};

/// Waves without phases, and notes on their field.
struct WavesOfField : WaveResult {
  std::optional<std::size_t> field_rows_nonfinite;  ///< of a field file or array
  std::string notes;                                ///< lines for the user
  std::optional<FieldStep> field_step;  ///< of a smooth field that continues the last one
};

/// A direction field, before it is turned and options set its frequencies.
struct FoundField {
  DirectionField directions;
  FrequencyField frequencies;    ///< empty if the field has none; NaN in gaps
  FrequencyField frequencies_v;  ///< the same of crossing stripes
  std::optional<std::size_t> rows_nonfinite = {};
  MissingWaves missing = {};
  std::string notes = {};
  bool may_have_gaps = false;  ///< whether `frequencies`, those of a file, may have gaps
};

/// The expensive part, reusable for other frequencies.
struct BaseField : FoundField {
  FieldData data = {};                 ///< its source, if it was measured
  MeasuredField measured = {};         ///< the same, weighted; empty if not measured
  DirectionField last = {};            ///< of the last step, if it has a weight besides the data
  std::optional<FieldStep> step = {};  ///< as WavesOfField has it
  /// Of the surface's file or another one; refers to the surface and the data.
  std::shared_ptr<const ArraySource> arrays = {};
};

/// The field that a smooth field starts from.
struct LastDirections {
  DirectionField directions;  ///< one per vertex, for `SmoothFieldOptions::last`; may be empty. For
                              ///< measured fields, --temporal-smoothing mixes them with the data
  bool same_surface = false;  ///< unchanged surface: these are the field
  std::string notes = {};     ///< lines about them
};

/// The first half of the waves. A smooth field starts from `last`. Throws Error if a field file or
/// an array does not fit, CLI::ValidationError for --tensor with a field that is no tensor.
BaseField make_base_field(const WaveSource& source, const WaveOptions& options,
                          const LastDirections& last = {}, const Progress& progress = {});

/// Options of waves that are independent of the field.
WaveRequest wave_request(const WaveOptions& options);

/// The second half; throws the same.
WavesOfField make_waves(const WaveSource& source, const WaveOptions& options, BaseField field,
                        const Progress& progress = {});

}  // namespace brindle::tool
