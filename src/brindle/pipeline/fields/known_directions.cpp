#include "brindle/pipeline/fields/known_directions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/orientation.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {

void check_known(const KnownDirections& known, std::size_t vertices, const char* what) {
  const auto require = [&](bool holds, const std::string& message) {
    if (!holds) throw Error("smooth field: " + (what + (": " + message)));
  };
  const auto strength = [](float number) { return std::isfinite(number) && number >= 0; };
  require(strength(known.weight), "the weight must be a finite number of 0 or above");
  if (known.directions.empty()) return;
  require(known.directions.size() == vertices,
          "there are " + std::to_string(known.directions.size()) + " directions for " +
              std::to_string(vertices) + " vertices; give one to each, or none");
  require(known.confidence.empty() || known.confidence.size() == vertices,
          "there are " + std::to_string(known.confidence.size()) + " confidences for " +
              std::to_string(vertices) + " vertices; give one to each, or none");
  require(ranges::all_of(known.directions, [](const Vec3& d) { return d.allFinite(); }),
          "directions must be finite; zero says that nothing is known");
  require(ranges::all_of(known.confidence, strength),
          "confidences must be finite numbers of 0 or above");
}

LastValues last_values(const KnownDirections& known, std::span<const Vec3> normals, int symmetry) {
  LastValues last{std::vector<Complex>(normals.size()), known.confidence, known.weight};
  if (last.confidence.empty()) last.confidence.assign(normals.size(), 1);
  parallel_for(normals.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (last.confidence[i] == 0) continue;
      const Vec3 tangent = tangent_direction(known.directions[i], normals[i]);
      last.u[i] = representation(tangent, normals[i], symmetry);
    }
  });
  return last;
}

Vec3 direction_near(const Vec3& last, Complex u, const Vec3& normal, int symmetry) {
  const Complex turned = u * std::conj(representation(last, normal, symmetry));
  const float radians = std::arg(turned) / static_cast<float>(symmetry);
  return std::cos(radians) * last + std::sin(radians) * normal.cross(last);
}

void name_like_last(const Adjacency& neighborhood, std::span<const Complex> u,
                    std::span<const Vec3> normals, std::span<const Vec3> last, int symmetry,
                    DirectionField& field) {
  std::vector<std::uint8_t> settled(field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3 before = tangent_direction(last[i], normals[i]);
    if (before.isZero(0)) continue;
    field[i] = direction_near(before, u[i], normals[i], symmetry);
    settled[i] = 1;
  }
  // Vectors have the sign that they have.
  if (symmetry % 2 == 0) orient_alike(neighborhood, settled, field);
}

}  // namespace brindle
