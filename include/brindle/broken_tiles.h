/// Detection of broken motifs in a texture's tiles: cut by a branch, a seam or the border.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace BRINDLE_EXPORT brindle {

/// Centres of the motifs in a tile.
enum class TileLayout : std::uint8_t {
  single,             ///< one, at (1/2, 1/2)
  middle_and_corner,  ///< one at (1/2, 1/2), one at (0, 0)
  courses             ///< one at (1/2, 0), one at (0, 1/2)
};

/// Differences between the texture coordinates of two triangles, apart from whole tiles. The bits
/// negate V, negate U and, applied before these, swap U and V.
enum TileTurn : std::uint8_t { kTurnsV = 1, kTurnsU = 2, kSwapsUV = 4 };

/// Motifs of a tile to keep whole.
struct TileMotifs {
  TileLayout layout = TileLayout::single;
  /// Extents of the motifs around their centres, in sides of the tile: at most half a side along
  /// each axis. One for each motif of the layout.
  std::array<Eigen::AlignedBox2f, 2> extents = {whole_tile(), whole_tile()};
  /// Bit i: the motif is symmetric under the `TileTurn` i, so it is whole across such a seam.
  std::uint8_t symmetries = 1;
  Eigen::Vector2f shift{0, 0};  ///< of all tiles, in tiles
  /// For courses: motifs in which a joint of U ends, at a branch of U, are split along their middle
  /// instead of left out. The joint thus continues to the next course. No other motif counts as
  /// broken.
  bool split = false;

  bool operator==(const TileMotifs& other) const;

  static Eigen::AlignedBox2f whole_tile() {
    return {Eigen::Vector2f(-0.5f, -0.5f), Eigen::Vector2f(0.5f, 0.5f)};
  }
};

/// Throws Error for extents beyond half a tile and for a shift that is not finite.
void check_tile_motifs(const TileMotifs& motifs);

/// Broken motifs, triangle by triangle.
struct BrokenTiles {
  TileLayout layout = TileLayout::single;
  Eigen::Vector2f shift{0, 0};
  bool split = false;  ///< as in TileMotifs
  /// Empty if all motifs are whole. Otherwise one word per triangle: 0 if its motifs are whole, 1
  /// if all are broken (with `split`: if it has a branch of U), else the index of its record. A
  /// record has U and then V of the triangle's corners (floats, lifted, `shift` subtracted), the
  /// number of broken motifs, and for each twice U and twice V of its centre (integers).
  std::vector<std::uint32_t> words;

  /// Whether a broken motif reaches this triangle or is within a twentieth of a tile of it.
  bool touches(std::size_t triangle) const { return !words.empty() && words[triangle] != 0; }

  /// The share of `triangles`, a whole mesh's number, whose middle no broken motif has.
  double whole_share(std::size_t triangles) const;

  /// Whether the motif at a fragment is broken. `uv` are its texture coordinates
  /// (`texture_coordinate`), up to whole numbers.
  bool is_broken(std::size_t triangle, const Vec3& barycentric, const Eigen::Vector2f& uv) const;
};

/// Finds broken motifs on one mesh, for any number of textures.
///
/// Each tile has its motifs, in triangles that join without a seam. A motif is broken if it
/// reaches, or is within a twentieth of a tile of, one of these: the border; an edge of three or
/// more triangles; an edge across which coordinates differ by more than whole tiles and a turn
/// under which the motif is symmetric; a triangle whose coordinates do not close (a branch, a
/// singularity, no wave) or are folded over. All other motifs are seen whole, exactly once. The
/// result depends neither on the order of triangles and corners nor on the signs of waves. Time is
/// linear in the number of triangles and broken motifs.
class BrokenTileFinder {
 public:
  explicit BrokenTileFinder(std::span<const Triangle> triangles);

  /// `waves` has one entry per triangle. Throws Error for another number of entries or extents
  /// beyond half a tile; Cancelled if `progress` cancels.
  BrokenTiles find(const TextureWaves& waves, const TileMotifs& motifs,
                   const Progress& progress = {}) const;

  /// As above with given corner phases, computed by PhaseShiftKind::aligned.
  BrokenTiles find(std::span<const CornerPhases> u, std::span<const CornerPhases> v,
                   const TileMotifs& motifs, const Progress& progress = {}) const;

  /// As above with the corner phases of the vertices' own waves. `turned` states per triangle which
  /// corners' waves the texture reverses: bit m for U at corner m, bit 3 + m for V. Bit 6: they
  /// still do not run alike.
  BrokenTiles find(std::span<const CornerPhases> u, std::span<const CornerPhases> v,
                   std::span<const std::uint8_t> turned, const TileMotifs& motifs,
                   const Progress& progress = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// As `BrokenTileFinder::find`, for one texture.
BrokenTiles broken_tiles(std::span<const Triangle> triangles, const TextureWaves& waves,
                         const TileMotifs& motifs, const Progress& progress = {});

}  // namespace brindle
