#include <gtest/gtest.h>

#include "brindle/direction_field.h"
#include "brindle/shapes.h"
#include "brindle/surface.h"
#include "brindle/texture_pattern.h"
#include "pictures/stripe_result.h"

namespace brindle::tool {
namespace {

struct Textured {
  Surface surface = make_surface(make_shape("sphere,resolution=12"));
  TexturePattern pattern = texture_pattern(
      surface, projected_direction_field(Vec3(0.3f, 0.9f, 0.2f), surface.normals), 2);

  std::shared_ptr<const BrokenTiles> broken(const WholeTiles& whole, BuiltInTile tile,
                                            float shift = 0) const {
    return whole.broken(surface.mesh.triangles, pattern.waves, tile, {shift, 0});
  }
};

TEST(WholeTiles, AreThoseThatTheTileOrTheAskerWants) {
  const Textured textured;
  EXPECT_EQ(textured.broken(WholeTiles(), BuiltInTile::checker), nullptr);
  EXPECT_NE(textured.broken(WholeTiles(true), BuiltInTile::checker), nullptr);
  EXPECT_EQ(textured.broken(WholeTiles(false), BuiltInTile::arrows), nullptr);
  const auto broken = textured.broken(WholeTiles(), BuiltInTile::arrows);
  ASSERT_NE(broken, nullptr);
  EXPECT_EQ(broken->words, broken_tiles(textured.surface.mesh.triangles, textured.pattern.waves,
                                        tile_motifs(BuiltInTile::arrows))
                               .words);
}

TEST(WholeTiles, AreFoundOnceForAllThatShareThem) {
  const Textured textured;
  const WholeTiles whole;
  const WholeTiles copy = whole;
  const auto first = textured.broken(whole, BuiltInTile::dots);
  const auto moved = textured.broken(whole, BuiltInTile::dots, 0.4f);
  EXPECT_NE(first, moved);
  EXPECT_EQ(first, textured.broken(copy, BuiltInTile::dots));
  EXPECT_EQ(moved, textured.broken(copy, BuiltInTile::dots, 0.4f));
}

TEST(WholeTiles, OfAnotherTextureAreFoundAnew) {
  const Textured textured;
  const WholeTiles whole;
  const auto first = textured.broken(whole, BuiltInTile::dots);
  WholeTiles next = whole.of_next_texture(std::nullopt);
  BrokenTiles known;
  known.shift = {7, 7};
  next.know(next.motifs_of(BuiltInTile::arrows).value(), known);
  EXPECT_EQ(textured.broken(next, BuiltInTile::arrows)->shift, Eigen::Vector2f(7, 7));
  const auto again = textured.broken(next, BuiltInTile::dots);
  EXPECT_NE(again, first);
  EXPECT_EQ(again->words, first->words);
  EXPECT_EQ(textured.broken(whole.of_next_texture(false), BuiltInTile::dots), nullptr);
}

}  // namespace
}  // namespace brindle::tool
