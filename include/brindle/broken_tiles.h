/// Which figures of a texture's tiles are broken: torn by a branch, a seam or the border.
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

/// Where the middles of a tile's figures are.
enum class TileLayout : std::uint8_t {
  single,             ///< one, at (1/2, 1/2)
  middle_and_corner,  ///< one at (1/2, 1/2), one at (0, 0)
  courses             ///< one at (1/2, 0), one at (0, 1/2)
};

/// Ways in which texture coordinates of two triangles can differ, apart from whole tiles: bits say
/// that V changes its sign, that U does, and, before that, that they change places.
enum TileTurn : std::uint8_t { kTurnsV = 1, kTurnsU = 2, kSwapsUV = 4 };

/// What of a tile is to stay whole.
struct TileFigures {
  TileLayout layout = TileLayout::single;
  /// What figures cover, from their middles, in sides of the tile: at most half a side along each
  /// axis. The first and, where the layout has one, the second.
  std::array<Eigen::AlignedBox2f, 2> extents = {whole_tile(), whole_tile()};
  /// Bit i: figures look the same after the `TileTurn` i. They are whole across such a seam.
  std::uint8_t symmetries = 1;
  Eigen::Vector2f shift{0, 0};  ///< of all tiles, in tiles
  /// Of courses: rather than to leave figures out, those in which a joint of U ends, at a branch of
  /// U, are split along their middle, so that the joint goes on to the next course. No other figure
  /// counts as broken.
  bool split = false;

  bool operator==(const TileFigures& other) const;

  static Eigen::AlignedBox2f whole_tile() {
    return {Eigen::Vector2f(-0.5f, -0.5f), Eigen::Vector2f(0.5f, 0.5f)};
  }
};

/// Throws Error for extents that reach beyond half a tile and for a shift that is not finite.
void check_tile_figures(const TileFigures& figures);

/// The figures that are broken, triangle by triangle.
struct BrokenTiles {
  TileLayout layout = TileLayout::single;
  Eigen::Vector2f shift{0, 0};
  bool split = false;  ///< as in TileFigures
  /// Empty: all figures are whole. Otherwise a word per triangle: 0 if its figures are whole, 1 if
  /// all are broken (of split figures: if a branch of U is there), else where its record begins. A
  /// record has U and then V of the triangle's corners (floats, lifted, `shift` taken off), a
  /// number of figures, and of each of them the middle, twice U and twice V (integers).
  std::vector<std::uint32_t> words;

  /// Whether any figure is broken that this triangle has a part of, or is within a twentieth of one
  /// of.
  bool touches(std::size_t triangle) const { return !words.empty() && words[triangle] != 0; }

  /// Whether the figure at a fragment is broken. `uv` are its texture coordinates
  /// (`texture_coordinate`), of which whole numbers do not count.
  bool is_broken(std::size_t triangle, const Vec3& barycentric, const Eigen::Vector2f& uv) const;
};

/// Finds broken figures on one mesh, for as many textures as there are.
///
/// A figure is one of a tile's, in triangles that join without a seam. It is broken where it
/// reaches, or is a twentieth of a tile away from, the border, an edge at which three triangles
/// or more meet, an edge where coordinates of both sides differ by more than whole tiles and a turn
/// that the figure is symmetric under, or a triangle where coordinates do not close (a branch, a
/// singularity, no wave) or are folded over. All other figures are whole: seen once, all of them.
/// The result does not depend on the order of triangles and corners, nor on which way waves run,
/// and takes time in proportion to triangles and broken figures.
class BrokenTileFinder {
 public:
  explicit BrokenTileFinder(std::span<const Triangle> triangles);

  /// `waves` has one entry per triangle. Throws Error for another number of them or extents that
  /// reach beyond half a tile; Cancelled if `progress` asks for it.
  BrokenTiles find(const TextureWaves& waves, const TileFigures& figures,
                   const Progress& progress = {}) const;

  /// The same for waves whose corner phases are known, by PhaseShiftKind::aligned.
  BrokenTiles find(std::span<const CornerPhases> u, std::span<const CornerPhases> v,
                   const TileFigures& figures, const Progress& progress = {}) const;

  /// The same for the corner phases of vertices' own waves. `turned` says of every triangle which
  /// of its corners' waves a texture has turned round: bit m that of U at corner m, bit 3 + m that
  /// of V; bit 6 that even so they do not run alike.
  BrokenTiles find(std::span<const CornerPhases> u, std::span<const CornerPhases> v,
                   std::span<const std::uint8_t> turned, const TileFigures& figures,
                   const Progress& progress = {}) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// The same for one texture.
BrokenTiles broken_tiles(std::span<const Triangle> triangles, const TextureWaves& waves,
                         const TileFigures& figures, const Progress& progress = {});

}  // namespace brindle
