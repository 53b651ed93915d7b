#include "brindle/pipeline/sewn_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/geometry/crease_edges.h"

namespace brindle {
namespace {

constexpr int kRounds = 50;

/// A link between two faces. Its phases are those of waves oriented like their faces.
struct FaceLink {
  Index other;
  Complex own, theirs;
  float weight;     ///< 0 to 1
  bool reflecting;  ///< the other face's waves point against this one's
};

class FaceSewing {
 public:
  FaceSewing(const Surface& surface, const WaveSet& waves, std::span<Complex> z)
      : surface_(surface), waves_(waves), z_(z), face_(z.size(), 0), sense_(z.size(), 0) {
    find_faces();
    find_links();
  }

  void sew() {
    shift_.assign(oriented_.size(), Complex(1));
    std::vector<std::uint8_t> placed(oriented_.size());
    // First pass, breadth first: align each face with the faces already placed.
    for (Index first = 0; first < placed.size(); ++first) {
      if (placed[first] != 0) continue;
      std::vector<Index> queue = {first};
      placed[first] = 1;
      for (std::size_t next = 0; next < queue.size(); ++next) {
        if (next > 0) move(queue[next], [&](Index other) { return placed[other] == 2; });
        placed[queue[next]] = 2;
        for (const FaceLink& link : links_.of(queue[next])) {
          if (placed[link.other] != 0) continue;
          placed[link.other] = 1;
          queue.push_back(link.other);
        }
      }
    }
    for (int round = 0; round < kRounds; ++round) {
      for (Index face = 0; face < shift_.size(); ++face) move(face, [](Index) { return true; });
    }
    for (std::size_t v = 0; v < z_.size(); ++v) {
      if (sense_[v] == 0) continue;
      const Complex shift = shift_[face_[v]];
      z_[v] *= sense_[v] > 0 ? shift : std::conj(shift);
    }
  }

 private:
  /// How the wave of a vertex runs beside those of its neighbours.
  enum class Runs : std::uint8_t { nowhere, alike, against_some };

  /// Whether the waves of two neighbours run against each other.
  bool runs_against(Index v, Index w) const {
    return waves_.directions[v].dot(waves_.directions[w]) < 0;
  }

  std::vector<Runs> runs_by_vertex() const {
    std::vector<Runs> runs(z_.size(), Runs::nowhere);
    parallel_for(runs.size(), [&](std::size_t begin, std::size_t end) {
      for (auto v = static_cast<Index>(begin); v < end; ++v) {
        if (waves_.directions[v].isZero(0)) continue;
        const bool against = ranges::any_of(surface_.neighborhood->of(v),
                                            [&](Index w) { return runs_against(v, w); });
        runs[v] = against ? Runs::against_some : Runs::alike;
      }
    });
    return runs;
  }

  /// Finds the faces, and each wave's sign relative to the first vertex of its face.
  void find_faces() {
    const Adjacency& neighborhood = *surface_.neighborhood;
    const std::vector<Runs> runs = runs_by_vertex();
    std::vector<Index> queue;
    for (Index first = 0; first < z_.size(); ++first) {
      if (sense_[first] != 0 || runs[first] == Runs::nowhere) continue;
      const auto face = static_cast<Index>(oriented_.size());
      bool oriented = true;
      queue.assign(1, first);
      sense_[first] = 1;
      for (std::size_t next = 0; next < queue.size(); ++next) {
        const Index v = queue[next];
        face_[v] = face;
        for (const Index w : neighborhood.of(v)) {
          // Check each edge once.
          if ((sense_[w] != 0 && w < v) || runs[w] == Runs::nowhere) continue;
          const bool against = runs[v] == Runs::against_some && runs_against(v, w);
          const auto sense = static_cast<std::int8_t>(against ? -sense_[v] : sense_[v]);
          if (sense_[w] == 0) {
            sense_[w] = sense;
            queue.push_back(w);
          } else {
            oriented = oriented && sense_[w] == sense;
          }
        }
      }
      oriented_.push_back(oriented ? 1 : 0);
    }
  }

  /// The phase of the wave in the orientation of its face.
  Complex phase(Index v) const { return sense_[v] < 0 ? -std::conj(z_[v]) : z_[v]; }

  void find_links() {
    const std::vector<std::array<Index, 2>> links = links_over_creases(surface_.creases);
    links_ = compressed_rows<FaceLink>(oriented_.size(), [&](const auto& add) {
      for (const auto& [i, j] : links) {
        if (sense_[i] == 0 || sense_[j] == 0 || face_[i] == face_[j]) continue;
        const float cosine = cosine_across(waves_.directions[j], surface_.normals[j],
                                           waves_.directions[i], surface_.normals[i]);
        const bool against = (cosine < 0) != (sense_[i] != sense_[j]);
        add(face_[i], {face_[j], phase(i), phase(j), std::abs(cosine), against});
      }
    });
  }

  /// Sets the optimal shift of a face with all others fixed.
  template <class Counts>
  void move(Index face, const Counts& counts) {
    if (oriented_[face] == 0) return;
    Complex sum = 0;
    for (const FaceLink& link : links_.of(face)) {
      if (!counts(link.other)) continue;
      const Complex theirs = shift_[link.other] * link.theirs;
      sum += link.weight * std::conj(link.own) * (link.reflecting ? -std::conj(theirs) : theirs);
    }
    const float length = std::sqrt(std::norm(sum));
    if (length > 1e-6f) shift_[face] = sum / length;
  }

  const Surface& surface_;
  const WaveSet& waves_;
  std::span<Complex> z_;
  std::vector<Index> face_;
  std::vector<std::int8_t> sense_;      ///< 0: no wave
  std::vector<std::uint8_t> oriented_;  ///< by face
  CompressedRows<FaceLink> links_;      ///< by face
  std::vector<Complex> shift_;          ///< by face
};

}  // namespace

void sew_faces(const Surface& surface, const WaveSet& waves, std::span<Complex> z) {
  if (!surface.creases.empty()) FaceSewing(surface, waves, z).sew();
}

}  // namespace brindle
