#include "brindle/pipeline/frames/kept_orientation.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"

namespace brindle {
namespace {

/// A seam is laid anew when it is longer than this many times what it was, and a few edges.
constexpr double kTooLong = 1.2;
constexpr std::size_t kFewEdges = 16;

constexpr CornerSigns kSignsOfU = 7;

bool is_unoriented(CornerSigns signs) { return (signs & kUnoriented) != 0; }

CompressedRows<Index> edges_by_triangle(std::size_t triangles, std::span<const SharedEdge> edges) {
  return compressed_rows<Index>(triangles, [&](const auto& add) {
    for (Index e = 0; e < edges.size(); ++e) {
      for (const Index corner : edges[e].from) add(corner / 3, e);
    }
  });
}

}  // namespace

KeptOrientation::KeptOrientation(std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)),
      edges_(shared_edges(triangles_)),
      edges_of_(edges_by_triangle(triangles_.size(), edges_)) {
  turned_.resize(triangles_.size());
  shown_.resize(triangles_.size());
}

FrameOrientation KeptOrientation::follow(std::span<const Vec3> u, std::span<const Vec3> v,
                                         bool as_given, const Progress& progress) {
  last_shown_ = shown_;
  const TextureSeams last_seams = seams_;
  const std::size_t last_shortest = shortest_;
  std::swap(signs_, last_signs_);
  try {
    corner_signs(triangles_, u, v, signs_);
    const FrameOrientation orientation = orient(u, as_given, progress);
    last_directions_.assign(u.begin(), u.end());
    return orientation;
  } catch (...) {
    std::swap(signs_, last_signs_);
    std::swap(shown_, last_shown_);
    seams_ = last_seams;
    shortest_ = last_shortest;
    throw;
  }
}

FrameOrientation KeptOrientation::orient(std::span<const Vec3> u, bool as_given,
                                         const Progress& progress) {
  const bool is_first = last_directions_.empty();
  flipped_.resize(u.size());
  if (!is_first) {
    const auto turns_round = [](const Vec3& a, const Vec3& b) -> std::uint8_t {
      return a.dot(b) < 0;
    };
    ranges::transform(u, last_directions_, flipped_.begin(), turns_round);
    const bool flips = !as_given && ranges::count(flipped_, 0) != std::ssize(flipped_);
    if (!flips && signs_ == last_signs_) return FrameOrientation::kept;
  }
  agreements(signs_, edges_, agreement_);
  FrameOrientation result = FrameOrientation::afresh;
  if (as_given) {
    ranges::fill(turned_, std::uint8_t{0});
    if (!is_first) result = FrameOrientation::continued;
  } else if (is_first) {
    turned_ = orienting_turns(triangles_, oriented_triangles(signs_), edges_, agreement_, progress);
  } else {
    result = FrameOrientation::continued;
    follow_neighbors(continue_last());
  }
  show();
  if (result == FrameOrientation::continued && !as_given && shorten()) {
    result = FrameOrientation::shortened;
  }
  return result;
}

/// Lets all triangles that had an orientation run as they ran. Returns those that have one only
/// now.
std::vector<Index> KeptOrientation::continue_last() {
  parallel_for(triangles_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      unsigned ran = shown_[t];
      for (unsigned m = 0; m < 3; ++m) ran ^= unsigned{flipped_[triangles_[t][m]]} << m;
      turned_[t] = std::popcount((ran ^ signs_[t]) & kSignsOfU) >= 2;
    }
  });
  std::vector<Index> undecided;
  for (Index t = 0; t < triangles_.size(); ++t) {
    if (is_unoriented(signs_[t])) {
      turned_[t] = 0;
    } else if (is_unoriented(last_signs_[t])) {
      undecided.push_back(t);
    }
  }
  return undecided;
}

/// Lets triangles run as most of their neighbours do, those first that have a decided one.
void KeptOrientation::follow_neighbors(std::vector<Index> undecided) {
  std::vector<std::uint8_t> decided = oriented_triangles(signs_);
  for (const Index t : undecided) decided[t] = 0;
  while (!undecided.empty()) {
    std::vector<Index> left;
    for (const Index t : undecided) {
      if (follow_neighbors_of(t, decided)) {
        decided[t] = 1;
      } else {
        left.push_back(t);
      }
    }
    if (left.size() == undecided.size()) {  // a piece that had no orientation: as it stands
      turned_[left[0]] = 0;
      decided[left[0]] = 1;
      left.erase(left.begin());
    }
    undecided = std::move(left);
  }
}

bool KeptOrientation::follow_neighbors_of(Index triangle, std::span<const std::uint8_t> decided) {
  int votes = 0;
  bool asked = false;
  for (const Index e : edges_of_.of(triangle)) {
    const EdgeAgreement alike = agreement_[e];
    const auto& [a, b] = edges_[e].from;
    const Index neighbor = a / 3 == triangle ? b / 3 : a / 3;
    if (alike == kNoAgreement || !decided[neighbor]) continue;
    asked = true;
    const int both = (alike & kUAlike ? 1 : -1) + (alike & kVAlike ? 1 : -1);
    votes += turned_[neighbor] ? -both : both;
  }
  turned_[triangle] = votes < 0;
  return asked;
}

/// Lays the seam anew if it has grown too long; tells whether it did.
bool KeptOrientation::shorten() {
  shortest_ = std::min(shortest_, seams_.turned);
  const auto allowed = static_cast<std::size_t>(kTooLong * static_cast<double>(shortest_));
  if (seams_.turned <= allowed + kFewEdges) return false;
  const auto turns = shortening_turns(triangles_, oriented_triangles(signs_), edges_, agreement_);
  for (std::size_t t = 0; t < turned_.size(); ++t) turned_[t] ^= turns[t];
  agreements(signs_, edges_, agreement_);
  show();
  shortest_ = seams_.turned;
  return true;
}

/// What follows from signs and turns.
void KeptOrientation::show() {
  turn_agreements(turned_, edges_, agreement_);
  shown_ = signs_;
  turn_signs(turned_, shown_);
  seams_ = texture_seams(oriented_triangles(signs_), agreement_);
  if (last_directions_.empty()) shortest_ = seams_.turned;
}

}  // namespace brindle
