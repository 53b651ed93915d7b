#include "global_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace brindle::paraview {
namespace {

/// Coordinates closer than this share of the diagonal may be one place, rounded.
constexpr double kRounding = 1e-5;

/// Numbers above are of vertices that no other rank knows.
constexpr std::uint64_t kUnshared = std::uint64_t{1} << 63;

/// A position's bits, and the vertex's id or 0.
struct Place {
  std::array<std::uint32_t, 3> bits;
  std::uint64_t id;

  auto operator<=>(const Place&) const = default;
};

Place place_of(const Vec3& position, std::uint64_t id) {
  Place place{{}, id};
  for (int k = 0; k < 3; ++k) {
    place.bits[static_cast<std::size_t>(k)] =
        std::bit_cast<std::uint32_t>(position[k] + 0.0f);  // -0 is 0
  }
  return place;
}

/// Spreads places over ranks, those of a lattice as well.
std::uint64_t hash(const Place& place) {
  std::uint64_t h = 0;
  for (const std::uint32_t bits : place.bits) {
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

struct IdPlace {
  std::uint64_t id;
  std::array<float, 3> position;

  auto operator<=>(const IdPlace&) const = default;
};

bool near(const IdPlace& a, const IdPlace& b, double distance) {
  return (Vec3(a.position.data()) - Vec3(b.position.data())).cast<double>().norm() <= distance;
}

bool stands_first(const PieceVertices& vertices, std::size_t v) { return vertices.first[v] == v; }

/// Collective: whether ids say which vertices are one.
bool ids_hold(const Ranks& ranks, const PieceVertices& vertices, double rounding) {
  const std::size_t count = vertices.positions.size();
  const bool has_ids =
      count == 0 || (vertices.ids.size() == count && std::ranges::min(vertices.ids) >= 0);
  if (!ranks.every(has_ids)) return false;
  std::vector<std::vector<IdPlace>> told(static_cast<std::size_t>(ranks.size()));
  for (std::size_t v = 0; v < count; ++v) {
    if (!stands_first(vertices, v)) continue;
    const auto id = static_cast<std::uint64_t>(vertices.ids[v]);
    const Vec3& p = vertices.positions[v];
    told[id % told.size()].push_back({id, {p.x(), p.y(), p.z()}});
  }
  std::vector<IdPlace> heard;
  bool hold = true;
  for (auto& list : ranks.swap_lists(told)) {
    std::ranges::sort(list);
    // Twice in a piece, and not joined: at two places.
    hold = hold && std::ranges::adjacent_find(list, {}, &IdPlace::id) == list.end();
    heard.insert(heard.end(), list.begin(), list.end());
  }
  std::ranges::sort(heard);
  for (std::size_t i = 1; i < heard.size(); ++i) {
    const bool same = heard[i].id == heard[i - 1].id;
    hold = hold && (!same || near(heard[i], heard[i - 1], rounding));
  }
  return ranks.every(hold);
}

/// The numbers of places that ranks told of: the lowest id there, or one after the other.
class PlaceNumbers {
 public:
  PlaceNumbers(const std::vector<std::vector<Place>>& told, bool by_id) : by_id_(by_id) {
    for (const auto& list : told) places_.insert(places_.end(), list.begin(), list.end());
    std::ranges::sort(places_);
    const auto same = [](const Place& a, const Place& b) { return a.bits == b.bits; };
    places_.erase(std::ranges::unique(places_, same).begin(), places_.end());
  }

  std::uint64_t number_of(const Place& place, const Ranks& ranks) const {
    const auto found = std::ranges::lower_bound(places_, place.bits, {}, &Place::bits);
    if (by_id_) return found->id;
    const auto index = static_cast<std::uint64_t>(found - places_.begin());
    return index * static_cast<std::uint64_t>(ranks.size()) +
           static_cast<std::uint64_t>(ranks.rank());
  }

 private:
  std::vector<Place> places_;
  bool by_id_;
};

}  // namespace

std::vector<std::uint64_t> global_numbers(const Ranks& ranks, const PieceVertices& vertices,
                                          double diagonal) {
  const bool by_id = ids_hold(ranks, vertices, kRounding * diagonal);
  const std::size_t count = vertices.positions.size();
  std::vector<std::vector<Place>> told(static_cast<std::size_t>(ranks.size()));
  std::vector<std::size_t> knows(count);  // which rank
  for (std::size_t v = 0; v < count; ++v) {
    if (!stands_first(vertices, v)) continue;
    const Place place =
        place_of(vertices.positions[v], by_id ? static_cast<std::uint64_t>(vertices.ids[v]) : 0);
    knows[v] = hash(place) % told.size();
    told[knows[v]].push_back(place);
  }
  const auto heard = ranks.swap_lists(told);
  const PlaceNumbers numbers(heard, by_id);
  std::vector<std::vector<std::uint64_t>> answers(heard.size());
  for (std::size_t r = 0; r < heard.size(); ++r) {
    for (const Place& place : heard[r]) answers[r].push_back(numbers.number_of(place, ranks));
  }
  const auto answered = ranks.swap_lists(answers);

  std::vector<std::size_t> next(answered.size());
  std::vector<std::uint64_t> result(count);
  for (std::size_t v = 0; v < count; ++v) {
    result[v] = stands_first(vertices, v)
                    ? answered[knows[v]][next[knows[v]]++]
                    : kUnshared + v * told.size() + static_cast<std::size_t>(ranks.rank());
  }
  return result;
}

}  // namespace brindle::paraview
