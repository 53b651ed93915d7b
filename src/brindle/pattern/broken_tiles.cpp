#include "brindle/broken_tiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/corner_signs.h"
#include "brindle/pattern/motif_centre.h"

namespace brindle {
namespace {

using Place = Eigen::Vector2f;  ///< lifted U and V
using Rect = Eigen::AlignedBox2f;

/// Clearance between motifs and breaks, in tiles: motifs next to a break are distorted, and
/// coordinates are not quite linear within triangles.
constexpr float kClearance = 0.05f;
constexpr float kLeastClearance = 0.03f;  // minimum, even if it reaches beyond half a tile

/// Rounding error by which coordinates of one vertex may differ from whole tiles.
constexpr float kRounding = 2e-4f;

/// The mesh data that all textures share.
struct MeshEdgeTwins {
  explicit MeshEdgeTwins(std::span<const Triangle> all)
      : triangles(all.begin(), all.end()), twins(twins_of(all)) {
    for (Index h = 0; h < twins.size() && wound_alike; ++h) {
      const Index twin = twins[h];
      wound_alike = twin >= kManyTwins || triangles[h / 3][h % 3] != triangles[twin / 3][twin % 3];
    }
  }

  std::vector<Triangle> triangles;
  std::vector<Index> twins;
  bool wound_alike = true;  ///< on both sides of every edge
};

/// Rounds to the nearest whole number inline; a function call would take half of the time.
float nearest_whole(float x) {
  return static_cast<float>(static_cast<std::int32_t>(x < 0 ? x - 0.5f : x + 0.5f));
}

Place turned(Place p, unsigned turn) {
  if (turn & kSwapsUV) std::swap(p.x(), p.y());
  if (turn & kTurnsU) p.x() = -p.x();
  if (turn & kTurnsV) p.y() = -p.y();
  return p;
}

TileCentre turned(TileCentre m, unsigned turn) {
  if (turn & kSwapsUV) std::swap(m.u, m.v);
  if (turn & kTurnsU) m.u = -m.u;
  if (turn & kTurnsV) m.v = -m.v;
  return m;
}

bool mirrors(unsigned turn) { return std::popcount(turn) % 2 != 0; }

float doubled_area(const std::array<Place, 3>& p) {
  const Place a = p[1] - p[0], b = p[2] - p[0];
  return a.x() * b.y() - a.y() * b.x();
}

/// Maps the coordinates of a triangle to those of its neighbour.
struct Passage {
  unsigned turn = 0;
  std::int32_t tiles_u = 0, tiles_v = 0;

  TileCentre of(const TileCentre& m) const {
    const TileCentre t = turned(m, turn);
    return {t.u + 2 * tiles_u, t.v + 2 * tiles_v};
  }
};

/// The parameters of a segment at which one coordinate is within bounds.
struct Stretch {
  float begin = 0, end = 1;

  void bound(float from, float to, float least, float most) {
    const float along = to - from;
    if (along == 0) {
      if (from < least || from > most) end = -1;
      return;
    }
    const float a = (least - from) / along, b = (most - from) / along;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  bool empty() const { return !(begin <= end); }
};

/// Separating axis test of a segment and a rectangle: both axes and the segment's normal.
bool meets(const Place& a, const Place& b, const Rect& rect) {
  const Place least = a.cwiseMin(b), most = a.cwiseMax(b);
  if ((least.array() > rect.max().array()).any() || (most.array() < rect.min().array()).any()) {
    return false;
  }
  const Place along = b - a, half = (rect.max() - rect.min()) / 2;
  const Place from = a - (rect.min() + half);
  return std::abs(along.x() * from.y() - along.y() * from.x()) <=
         half.x() * std::abs(along.y()) + half.y() * std::abs(along.x());
}

/// Calls `visit(centre)` for every motif of one kind that a segment meets. `rect` is the extent of
/// the motif centred at `first`.
template <class Visit>
void motifs_on(const Place& a, const Place& b, const Rect& rect, TileCentre first,
               const Visit& visit) {
  const auto lowest = [](float least, float most) { return std::ceil(least - most); };
  const float least_v = std::min(a.y(), b.y()), most_v = std::max(a.y(), b.y());
  for (float j = lowest(least_v, rect.max().y()); rect.min().y() + j <= most_v; j += 1) {
    Stretch stretch;
    stretch.bound(a.y(), b.y(), rect.min().y() + j, rect.max().y() + j);
    if (stretch.empty()) continue;
    const float u = a.x() + stretch.begin * (b.x() - a.x());
    const float other = a.x() + stretch.end * (b.x() - a.x());
    const float least_u = std::min(u, other), most_u = std::max(u, other);
    for (float i = lowest(least_u, rect.max().x()); rect.min().x() + i <= most_u; i += 1) {
      visit(TileCentre{first.u + 2 * static_cast<std::int32_t>(i),
                       first.v + 2 * static_cast<std::int32_t>(j)});
    }
  }
}

/// A broken motif in a triangle's list.
struct ListedMotif {
  TileCentre middle;
  std::uint32_t next;  ///< 1 + index of the next entry; 0: none
};

// State of a triangle's coordinates: whether they close, and the sign of their area.
constexpr std::uint8_t kOpen = 0, kClosed = 1, kMirrored = 2, kClosing = 3;
constexpr int kSignsAt = 2;  // higher bits: CornerSigns, the reversed waves

/// The reversed waves at the ends of an edge by the triangle's CornerSigns, from the corner onward
/// and back to it: U and V at the first end, then at the second.
struct EdgeSigns {
  std::array<std::array<std::uint8_t, 3>, kTurnedRound + 1> onward{}, back{};

  EdgeSigns() {
    for (CornerSigns signs = 0; signs <= kTurnedRound; ++signs) {
      for (Index corner = 0; corner < 3; ++corner) {
        const Index next = corner == 2 ? 0 : corner + 1;
        onward[signs][corner] = at(signs, corner, next);
        back[signs][corner] = at(signs, next, corner);
      }
    }
  }
  static std::uint8_t at(CornerSigns signs, Index first, Index second) {
    const unsigned of_first = (turns_u(signs, first) ? 1 : 0) | (turns_v(signs, first) ? 2 : 0);
    const unsigned of_second = (turns_u(signs, second) ? 4 : 0) | (turns_v(signs, second) ? 8 : 0);
    return static_cast<std::uint8_t>(of_first | of_second);
  }
};

/// Finds the broken motifs of a texture on a mesh.
class Breaks {
 public:
  Breaks(const MeshEdgeTwins& mesh, std::span<const CornerPhases> u,
         std::span<const CornerPhases> v, std::span<const CornerSigns> turned,
         const TileMotifs& motifs)
      : triangles_(mesh.triangles),
        twins_(mesh.twins),
        wound_alike_(mesh.wound_alike),
        u_(u),
        v_(v),
        turned_(turned),
        motifs_(motifs),
        closed_(u.size()),
        ends_(motifs.split ? u.size() : 0),
        lists_(u.size()) {
    parallel_for(u.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) close(t);
    });
    for (std::size_t kind = 0; kind < kinds(); ++kind) {
      const Rect& covered = motifs.extents[kind];
      reach_[kind] = {covered.min().array() - kClearance, covered.max().array() + kClearance};
      const Place middle = place_of(first_middle(motifs.layout, kind));
      rects_[kind] = {clear_of(covered.min()) + middle, clear_of(covered.max()) + middle};
    }
  }

  void spread(const Progress& progress) {
    if (motifs_.split) return spread_splits(progress);
    const std::vector<std::uint8_t> torn = torn_half_edges(progress.part(0, 0.5));
    reported_for(torn.size(), progress.part(0.5, 1), [&](std::size_t h) {
      if (torn[h]) break_along(static_cast<Index>(h));
    });
  }

  BrokenTiles result() const {
    BrokenTiles broken{motifs_.layout, motifs_.shift, motifs_.split, {}};
    const std::size_t count = closed_.size();
    const std::vector<std::uint8_t>& all = motifs_.split ? ends_ : closed_;
    const auto is_whole = [&](std::uint8_t flag) {
      return motifs_.split ? flag == 0 : (flag & kClosing) != kOpen;
    };
    if (listed_.empty() && ranges::all_of(all, is_whole)) return broken;
    broken.words.assign(count, 0);
    std::vector<TileCentre> middles;
    for (std::size_t t = 0; t < count; ++t) {
      if (!is_whole(all[t])) broken.words[t] = 1;
      if (!is_whole(all[t]) || lists_[t] == 0) continue;
      middles.clear();
      for (std::uint32_t i = lists_[t]; i != 0; i = listed_[i - 1].next) {
        middles.push_back(listed_[i - 1].middle);
      }
      ranges::sort(middles);
      add_record(t, middles, broken.words);
    }
    return broken;
  }

 private:
  /// A corner of the area that must be free of breaks for a motif to be whole.
  Place clear_of(const Place& corner) const {
    const Place away = corner.cwiseAbs();
    Place clear = away.array() + kLeastClearance;
    clear = clear.cwiseMax((away.array() + kClearance).min(0.5f).matrix());
    return clear.cwiseProduct(corner.unaryExpr([](float x) { return x < 0 ? -1.0f : 1.0f; }));
  }

  std::size_t kinds() const { return motifs_.layout == TileLayout::single ? 1 : 2; }

  CornerSigns signs_of(std::size_t t) const {
    return turned_.empty() ? CornerSigns{0} : turned_[t];
  }

  /// Phases run like the first corner's own wave; if that was reversed, coordinates are negated.
  Place place(std::size_t t, Index m) const {
    const CornerSigns signs = signs_of(t);
    const Place sense(turns_u(signs, 0) ? -1.0f : 1.0f, turns_v(signs, 0) ? -1.0f : 1.0f);
    const Place own = Place(u_[t].phase[m], v_[t].phase[m]) / kTwoPi + Place(0.25f, 0.25f);
    return own.cwiseProduct(sense) - motifs_.shift;
  }

  Place place(Index corner) const { return place(corner / 3, corner % 3); }

  std::array<Place, 3> places(std::size_t t) const {
    return {place(t, 0), place(t, 1), place(t, 2)};
  }

  void close(std::size_t t) {
    const CornerPhases &u = u_[t], &v = v_[t];
    const CornerSigns signs = signs_of(t);
    bool closed = u.kind == TriangleKind::regular && v.kind == TriangleKind::regular &&
                  (signs & kUnoriented) == 0;
    for (Index m = 0; m < 3; ++m) {
      closed = closed && (u.sign[m] > 0) == (turns_u(signs, m) == turns_u(signs, 0)) &&
               (v.sign[m] > 0) == (turns_v(signs, m) == turns_v(signs, 0));
    }
    // Beyond this, floats are too coarse to locate a tile.
    constexpr float kFarthest = 1e6f;
    const std::array<Place, 3> lifted = places(t);
    const auto near = [](const Place& p) { return p.cwiseAbs().maxCoeff() < kFarthest; };
    const bool all_near = ranges::all_of(lifted, near);
    const float area = doubled_area(lifted);
    const std::uint8_t closing = !closed || !all_near || area == 0 ? kOpen
                                 : area > 0                        ? kClosed
                                                                   : kMirrored;
    closed_[t] = static_cast<std::uint8_t>(closing | (signs & kTurnedRound) << kSignsAt);
    if (!motifs_.split) return;
    ends_[t] = u.kind == TriangleKind::branch && v.kind == TriangleKind::regular && all_near;
  }

  std::uint8_t closing(std::size_t t) const { return closed_[t] & kClosing; }

  /// The passage across an edge of triangles whose coordinates close; nullopt if motifs break
  /// there. Lengths and signs of areas determine the turn.
  std::optional<Passage> passage(Index h, Index twin) const {
    // Triangles that are wound alike traverse their common edge in opposite directions.
    const bool alike = vertices_alike(h, twin);
    const Place from = place(h), to = place(next_in_triangle(h));
    const Place other_from = place(alike ? next_in_triangle(twin) : twin);
    const Place other_to = place(alike ? twin : next_in_triangle(twin));
    const bool same_side = closing(h / 3) == closing(twin / 3);
    for (unsigned turn = 0; turn < 8; ++turn) {
      if (mirrors(turn) != (same_side != alike)) continue;
      const Place away = other_from - turned(from, turn), away_to = other_to - turned(to, turn);
      const Place whole(nearest_whole(away.x()), nearest_whole(away.y()));
      const float rounding = kRounding * (1 + 0.01f * (std::abs(away.x()) + std::abs(away.y())));
      if ((away - whole).cwiseAbs().maxCoeff() > rounding) continue;
      if ((away_to - whole).cwiseAbs().maxCoeff() > rounding) continue;
      if ((motifs_.symmetries >> turn & 1) == 0) return std::nullopt;
      return Passage{turn, static_cast<std::int32_t>(whole.x()),
                     static_cast<std::int32_t>(whole.y())};
    }
    return std::nullopt;
  }

  /// The same from the known place of the corner, mostly without a search.
  std::optional<Passage> passage_from(Index t, Index corner, const Place& from, Index twin) const {
    const bool plainly = !turned_.empty() && joins_plainly(t, corner, twin);
    if (!plainly || (motifs_.symmetries & 1) == 0) return passage(3 * t + corner, twin);
    const Place away = place(next_in_triangle(twin)) - from;
    return Passage{0, static_cast<std::int32_t>(nearest_whole(away.x())),
                   static_cast<std::int32_t>(nearest_whole(away.y()))};
  }

  bool vertices_alike(Index h, Index twin) const {
    return triangles_[h / 3][h % 3] != triangles_[twin / 3][twin % 3];
  }

  /// Whether coordinates of both sides differ by whole tiles alone, as they do nearly everywhere:
  /// triangles are wound alike, and both orient the waves at the edge's ends alike. May be false
  /// for edges that `passage` joins.
  bool joins_plainly(std::size_t t, Index corner, Index twin) const {
    const Index there = twin / 3, at = twin - 3 * there;
    const std::uint8_t own = closed_[t], other = closed_[there];
    if (((own ^ other) & kClosing) != 0) return false;
    if (!wound_alike_ && triangles_[t][corner] == triangles_[there][at]) return false;
    static const EdgeSigns signs;
    return signs.onward[own >> kSignsAt][corner] == signs.back[other >> kSignsAt][at];
  }

  /// The same for corners with individual waves, which have no signs.
  bool meets_plainly(std::size_t t, Index corner, Index twin) const {
    const Index there = twin / 3, at = twin - 3 * there;
    if (closed_[t] != closed_[there] || triangles_[t][corner] == triangles_[there][at]) {
      return false;
    }
    const Index next = corner == 2 ? 0 : corner + 1, next_there = at == 2 ? 0 : at + 1;
    const std::array<Place, 3> own = places(t), other = places(there);
    const Place away = other[next_there] - own[corner], away_to = other[at] - own[next];
    const Place whole(nearest_whole(away.x()), nearest_whole(away.y()));
    const Place rest = (away - whole).cwiseAbs().cwiseMax((away_to - whole).cwiseAbs());
    return rest.maxCoeff() <= kRounding;
  }

  bool is_joined(std::size_t t, Index corner, Index twin) const {
    if (closing(t) == kOpen || closing(twin / 3) == kOpen) return false;
    const bool plainly =
        turned_.empty() ? meets_plainly(t, corner, twin) : joins_plainly(t, corner, twin);
    return plainly || passage(static_cast<Index>(3 * t + corner), twin);
  }

  std::vector<std::uint8_t> torn_half_edges(const Progress& progress) const {
    std::vector<std::uint8_t> torn(twins_.size());
    parallel_for(closed_.size(), progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t) {
        for (Index corner = 0; corner < 3; ++corner) {
          const auto h = static_cast<Index>(3 * t + corner);
          const Index twin = twins_[h];
          if (twin >= kManyTwins) {
            torn[h] = closing(t);
          } else if (h < twin && !is_joined(t, corner, twin)) {
            // No other triangle writes to its twin.
            torn[h] = closing(t);
            torn[twin] = closing(twin / 3);
          }
        }
      }
    });
    return torn;
  }

  Rect rect_of(const TileCentre& middle) const {
    const Rect& reach = reach_[kind_of(motifs_.layout, middle)];
    const Place at = place_of(middle);
    return {reach.min() + at, reach.max() + at};
  }

  /// Lists a broken motif in a triangle; returns false if it was listed before.
  bool list(Index t, const TileCentre& middle) {
    for (std::uint32_t i = lists_[t]; i != 0; i = listed_[i - 1].next) {
      if (listed_[i - 1].middle == middle) return false;
    }
    listed_.push_back({middle, lists_[t]});
    lists_[t] = static_cast<std::uint32_t>(listed_.size());
    return true;
  }

  /// Splits the motifs (bricks) in which joints of U end.
  void spread_splits(const Progress& progress) {
    reported_for(ends_.size(), progress, [&](std::size_t t) {
      if (!ends_[t]) return;
      for (Index h = static_cast<Index>(3 * t); h < 3 * t + 3; ++h) {
        const Index twin = twins_[h];
        if (twin < kManyTwins && closing(twin / 3) != kOpen) split_beyond(h, twin);
      }
    });
  }

  /// Splits the motifs beyond such a triangle's edge, in the course (row of bricks) of its middle.
  void split_beyond(Index h, Index twin) {
    const std::array<Place, 3> own = places(h / 3);
    const float middle = (own[0].y() + own[1].y() + own[2].y()) / 3;
    const bool alike = vertices_alike(h, twin);
    const Place from = place(alike ? next_in_triangle(twin) : twin);
    const Place to = place(alike ? twin : next_in_triangle(twin));
    const float along = place(next_in_triangle(h)).y() - place(h).y(), there = to.y() - from.y();
    const float sense = std::abs(there + along) < std::abs(there - along) ? -1.0f : 1.0f;
    const float course = from.y() + sense * (middle - place(h).y());
    const auto row = static_cast<std::int32_t>(std::lround(2 * course));
    break_along(twin, [&](const TileCentre& m) { return m.v == row; });
  }

  void break_along(Index h) {
    break_along(h, [](const TileCentre&) { return true; });
  }

  /// Breaks every motif that an edge meets and `counts` accepts, in all its triangles.
  template <class Counts>
  void break_along(Index h, const Counts& counts) {
    const Place a = place(h), b = place(next_in_triangle(h));
    for (std::size_t kind = 0; kind < kinds(); ++kind) {
      motifs_on(a, b, rects_[kind], first_middle(motifs_.layout, kind), [&](const TileCentre& m) {
        if (counts(m) && list(h / 3, m)) pending_.push_back({h / 3, m});
      });
    }
    while (!pending_.empty()) {
      const auto [t, middle] = pending_.back();
      pending_.pop_back();
      pass_on(t, middle);
    }
  }

  void pass_on(Index t, const TileCentre& middle) {
    const Rect rect = rect_of(middle);
    const std::array<Place, 3> own = places(t);
    for (Index corner = 0; corner < 3; ++corner) {
      const Index twin = twins_[3 * t + corner];
      if (twin >= kManyTwins || closing(twin / 3) == kOpen) continue;
      if (!meets(own[corner], own[corner == 2 ? 0 : corner + 1], rect)) continue;
      const auto way = passage_from(t, corner, own[corner], twin);
      if (!way) continue;
      const TileCentre there = way->of(middle);
      if (list(twin / 3, there)) pending_.push_back({twin / 3, there});
    }
  }

  void add_record(std::size_t t, const std::vector<TileCentre>& middles,
                  std::vector<std::uint32_t>& words) const {
    words[t] = static_cast<std::uint32_t>(words.size());
    const std::array<Place, 3> lifted = places(t);
    for (int axis = 0; axis < 2; ++axis) {
      for (const Place& at : lifted) {
        words.push_back(bit_cast<std::uint32_t>(at[axis]));
      }
    }
    words.push_back(static_cast<std::uint32_t>(middles.size()));
    for (const TileCentre& m : middles) {
      words.push_back(static_cast<std::uint32_t>(m.u));
      words.push_back(static_cast<std::uint32_t>(m.v));
    }
  }

  std::span<const Triangle> triangles_;
  std::span<const Index> twins_;
  bool wound_alike_;
  std::span<const CornerPhases> u_, v_;
  std::span<const CornerSigns> turned_;  ///< empty: corners have individual waves
  const TileMotifs& motifs_;
  std::array<Rect, 2> reach_;         ///< relative to the centre: where triangles list a motif
  std::array<Rect, 2> rects_;         ///< area of the first motifs that must be free of breaks
  std::vector<std::uint8_t> closed_;  ///< per triangle: closing state and corner signs
  std::vector<std::uint8_t> ends_;    ///< for split motifs: where only U does not close
  std::vector<std::uint32_t> lists_;  ///< per triangle: 1 + index of its newest entry in listed_
  std::vector<ListedMotif> listed_;
  std::vector<std::pair<Index, TileCentre>> pending_;
};

}  // namespace

void check_tile_motifs(const TileMotifs& motifs) {
  for (const Rect& extent : motifs.extents) {
    const bool fits = extent.min().allFinite() && extent.max().allFinite() &&
                      (extent.min().array() >= -0.5f).all() && (extent.max().array() <= 0.5f).all();
    if (!fits) throw Error("motifs of tiles reach half a tile from their middles at most");
  }
  if (!motifs.shift.allFinite()) throw Error("tiles are shifted by no number");
}

bool TileMotifs::operator==(const TileMotifs& other) const {
  const auto alike = [](const Rect& a, const Rect& b) {
    return a.min() == b.min() && a.max() == b.max();
  };
  return layout == other.layout && alike(extents[0], other.extents[0]) &&
         alike(extents[1], other.extents[1]) && symmetries == other.symmetries &&
         shift == other.shift && split == other.split;
}

double BrokenTiles::whole_share(std::size_t triangles) const {
  if (words.empty() || triangles == 0) return 1;
  const Vec3 middle = Vec3::Constant(1 / 3.0f);
  std::size_t whole = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    Place uv = Place::Zero();
    for (int axis = 0; axis < 2 && words[t] > 1; ++axis) {
      for (int m = 0; m < 3; ++m) {
        uv[axis] += bit_cast<float>(words[words[t] + static_cast<std::size_t>(3 * axis + m)]) / 3;
      }
    }
    whole += is_broken(t, middle, uv + shift) ? 0 : 1;
  }
  return static_cast<double>(whole) / static_cast<double>(triangles);
}

// Keep in step with shaders/broken_tiles.glsl.
bool BrokenTiles::is_broken(std::size_t triangle, const Vec3& barycentric,
                            const Eigen::Vector2f& uv) const {
  if (words.empty()) return false;
  const std::size_t record = words[triangle];
  if (record < 2) return record == 1;
  Place led = Place::Zero();
  for (int axis = 0; axis < 2; ++axis) {
    for (int m = 0; m < 3; ++m) {
      led[axis] += barycentric[m] * bit_cast<float>(words[record + 3 * axis + m]);
    }
  }
  const Place own = uv - shift;
  const Place away = led - own;
  const Place lifted = own + Place(std::floor(away.x() + 0.5f), std::floor(away.y() + 0.5f));
  const TileCentre middle = motif_at(layout, lifted);
  const std::size_t count = words[record + 6];
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = record + 7 + 2 * i;
    if (bit_cast<std::int32_t>(words[at]) == middle.u &&
        bit_cast<std::int32_t>(words[at + 1]) == middle.v) {
      return true;
    }
  }
  return false;
}

struct BrokenTileFinder::State {
  MeshEdgeTwins mesh;
};

BrokenTileFinder::BrokenTileFinder(std::span<const Triangle> triangles)
    : state_(std::make_shared<const State>(State{MeshEdgeTwins(triangles)})) {}

BrokenTiles BrokenTileFinder::find(std::span<const CornerPhases> u, std::span<const CornerPhases> v,
                                   const TileMotifs& motifs, const Progress& progress) const {
  return find(u, v, {}, motifs, progress);
}

BrokenTiles BrokenTileFinder::find(std::span<const CornerPhases> u, std::span<const CornerPhases> v,
                                   std::span<const std::uint8_t> turned, const TileMotifs& motifs,
                                   const Progress& progress) const {
  const MeshEdgeTwins& mesh = state_->mesh;
  const std::size_t count = mesh.triangles.size();
  check_tile_motifs(motifs);
  if (u.size() != count || v.size() != count) {
    throw Error("tiles: there are waves of " + std::to_string(u.size()) + " and " +
                std::to_string(v.size()) + " triangles for " + std::to_string(count));
  }
  Breaks breaks(mesh, u, v, turned, motifs);
  breaks.spread(progress);
  return breaks.result();
}

BrokenTiles BrokenTileFinder::find(const TextureWaves& waves, const TileMotifs& motifs,
                                   const Progress& progress) const {
  constexpr PhaseShiftKind kKind = PhaseShiftKind::aligned;  // the kind used to draw textures
  const auto u = corner_phases(waves.u, kKind, progress.part(0, 0.3));
  const auto v = corner_phases(waves.v, kKind, progress.part(0.3, 0.6));
  return find(u, v, motifs, progress.part(0.6, 1));
}

BrokenTiles broken_tiles(std::span<const Triangle> triangles, const TextureWaves& waves,
                         const TileMotifs& motifs, const Progress& progress) {
  return BrokenTileFinder(triangles).find(waves, motifs, progress);
}

}  // namespace brindle
