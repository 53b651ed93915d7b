/// A partition and its data, as the source of waves.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brindle/communicator.h"
#include "brindle/distributed_waves.h"
#include "input/make_waves.h"
#include "ranks/mesh_pieces.h"

namespace brindle::tool {

/// Refers to its arguments. All functions but those without computations are collective. Rank 0
/// reads files with rows of vertices, and distributes the rows.
class PieceSource final : public WaveSource {
 public:
  /// Collective. Every rank reads the mesh of --field-mesh.
  PieceSource(Communicator& ranks, const DistributedSurface& surface, const ReadPiece& read,
              const ArrayOptions& options, const std::optional<Viewpoint>& viewpoint);

  const WaveSurface& surface() const override { return waves_; }
  const Mesh& mesh() const override { return read_.piece.mesh; }
  float diagonal() const override { return static_cast<float>(surface_.diagonal()); }
  std::string file() const override { return read_.file; }
  void check(const std::function<void()>& work) const override;
  std::vector<DataArray> rows(const std::string& option, const std::string& file,
                              const ReadRows& read) const override;
  std::size_t nonfinite_rows(const DataArray& array) const override;
  GlobeRadii globe_radii() const override;
  ArraySource::PerVertex array(const std::string& name) const override;
  std::optional<std::size_t> drop_too_far(DirectionField& directions) const override;
  bool is_near(Index vertex) const override { return !other_ || other_->is_near(vertex); }
  std::string notes() const override { return other_ ? other_->notes() : ""; }
  VertexValues values(const std::string& option, const std::string& text) const override;
  DirectionField smooth_field(const SmoothFieldOptions& options,
                              const Progress& progress) const override;
  DirectionField curvature_field(CurvatureDirection direction,
                                 const Progress& progress) const override;
  std::vector<FieldStroke> strokes_of_file(const std::string& path) const override;
  std::vector<FieldAnchor> anchors(std::span<const FieldStroke> strokes,
                                   const Progress& progress) const override;
  DirectionField vector_field(const DataArray& vectors, bool signs) const override;
  /// Directions are aligned within a rank; ghosts have the owner's.
  TensorField tensor_field(const DataArray& tensors, TensorAxis axis) const override;
  FrequencyField frequencies_by(const DataArray& values, float frequency,
                                const FrequencyRange& range) const override;
  WaveMetrics measure(const WaveSet& waves) const override;

 private:
  Surface places() const;

  Communicator& ranks_;
  const DistributedSurface& surface_;
  const ReadPiece& read_;
  const ArrayOptions& options_;
  const std::optional<Viewpoint>& viewpoint_;  // for the up axis alone
  const PieceSurface waves_;
  Surface places_;  // for `other_`
  std::unique_ptr<ArraySource> other_;
};

}  // namespace brindle::tool
