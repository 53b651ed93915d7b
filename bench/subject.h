/// Input of the benchmarks, which changes from frame to frame, and the quality of results.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/quality.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"

namespace brindle::bench {

/// Two alternating inputs: the second is turned by a degree about the normals, with 1 % higher
/// frequencies.
struct ChangingInput {
  std::vector<Vec3> positions;
  std::array<std::vector<Vec3>, 2> directions;
  std::array<std::vector<float>, 2> frequencies;

  FrameInput frame(int number) const {
    const auto which = static_cast<std::size_t>(number % 2);
    return {positions, directions[which], frequencies[which]};
  }
  WaveSet waves(int number) const {
    const auto which = static_cast<std::size_t>(number % 2);
    return {positions, directions[which], frequencies[which]};
  }
};

/// The fields of a subject.
enum class Fields {
  one,     ///< across one vector of space
  two,     ///< and a second one at right angles
  crosses  ///< a cross field: the surface becomes its double cover
};

/// A surface with its fields.
struct Subject {
  std::string name;
  Surface surface;
  std::vector<WaveSet> fields;
  std::vector<ChangingInput> inputs;  ///< one per field

  std::size_t vertex_count() const { return surface.mesh.vertex_count(); }
};

/// Reads or makes the mesh, subdivides it and splits it at creases. `stripes` are along the
/// diagonal of its bounding box. Throws Error if there is no such mesh.
Subject make_subject(const std::string& mesh, int subdivisions, Fields fields, float stripes);

/// Mean energy and angle error, and the sum of branches, of all fields of a subject.
struct Quality {
  double energy = 0;
  std::size_t branches = 0;
  double angle_error_mean_deg = 0;

  /// Adds one of `fields` fields.
  void add(double energy_of_one, const PatternQuality& quality, std::size_t fields);
};

/// The quality of the phases of frame `number`, one vector per field.
Quality quality_of(const Subject& subject, int number, std::span<const std::vector<Complex>> z);

}  // namespace brindle::bench
