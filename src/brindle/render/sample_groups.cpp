#include "brindle/render/sample_groups.h"

#include "brindle/render/visible_triangles.h"

namespace brindle {
namespace {

constexpr int kMostGroups = VisibleTriangles::kSamples * VisibleTriangles::kSamples;

/// All but the first are shaded as one where triangles form surfaces: few pixels show three of
/// them.
constexpr int kInteractiveGroups = 2;

/// The texture unit after those of GlSurface.
constexpr int kGroupUnit = 12;

/// Neighbours look alike where they meet, unless each has a colour or a normal of its own.
bool has_distinct_triangles(const GlSurface& surface) {
  return surface.has_triangle_colors() || !surface.has_normals();
}

/// The part of a target of `size` pixels where the box is seen: its lower left corner and size.
/// All of it if the box reaches behind the camera.
Eigen::Vector4i seen_part(const Eigen::AlignedBox3f& box, const Camera& camera,
                          const Eigen::Vector4f& tile, const Eigen::Vector2i& size) {
  Eigen::AlignedBox2f part;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 position =
        box.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner)) - camera.origin;
    const Eigen::Vector4f clip =
        camera.clip_from_view * (camera.view_from_world * position.homogeneous());
    if (!(clip.w() > 0)) return {0, 0, size.x(), size.y()};
    part.extend((clip.head<2>() / clip.w()).cwiseProduct(tile.head<2>()) + tile.tail<2>());
  }
  const auto pixel = [&](const Eigen::Vector2f& place) -> Eigen::Vector2f {
    return (place.array() + 1) / 2 * size.cast<float>().array();
  };
  const Eigen::Vector2f zero = Eigen::Vector2f::Zero(), all = size.cast<float>();
  const Eigen::Vector2f lower =
      (pixel(part.min()).array().floor() - 1).matrix().cwiseMax(zero).cwiseMin(all);
  const Eigen::Vector2f upper =
      (pixel(part.max()).array().ceil() + 1).matrix().cwiseMax(zero).cwiseMin(all);
  Eigen::Vector4i result;
  result << lower.cast<int>(), (upper - lower).cast<int>();
  return result;
}

}  // namespace

int SampleGroups::count(const GlSurface& surface, PictureQuality quality) {
  const bool few = quality == PictureQuality::interactive && !has_distinct_triangles(surface);
  return few ? kInteractiveGroups : kMostGroups;
}

/// Depths tell how many groups of samples a pixel has, so that a depth test leaves out pixels
/// without shading them.
void SampleGroups::find(const GlSurface& surface, const Target& visible, const Camera& camera,
                        const Eigen::Vector4f& tile, const Target& light,
                        const Eigen::Vector2i& size, int first_number) {
  fit_target(groups_, {GL_R8UI}, true, light.width, light.height);
  part_ = seen_part(surface.box(), camera, tile, size);
  bind_visible(program_, visible);
  program_.set("first_number", first_number);
  program_.set("triangle_count", static_cast<int>(surface.triangle_count()));
  program_.set("clip_from_view", camera.clip_from_view);
  program_.set("tile", tile);
  program_.set("target_size", Eigen::Vector2f(size.cast<float>()));
  program_.set("distinct_triangles", has_distinct_triangles(surface));
  glScissor(part_[0], part_[1], part_[2], part_[3]);
  glEnable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, groups_.framebuffer);
  glViewport(0, 0, size.x(), size.y());
  glUseProgram(program_.name());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glBindVertexArray(no_attributes_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
}

void SampleGroups::shade(const ShaderProgram& program, const Target& light, int count,
                         First first) {
  program.set("groups", kGroupUnit);
  program.set("last_group", count - 1);
  glBindTextureUnit(kGroupUnit, groups_.textures[0]);
  glNamedFramebufferTexture(light.framebuffer, GL_DEPTH_ATTACHMENT, groups_.textures[1], 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light.framebuffer);
  glScissor(part_[0], part_[1], part_[2], part_[3]);
  glEnable(GL_SCISSOR_TEST);
  glUseProgram(program.name());
  glBindVertexArray(no_attributes_);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_FALSE);
  glBlendFunc(GL_ONE, GL_ONE);
  for (int group = 0; group < count; ++group) {
    program.set("group", group);
    const double depth = 1 - (2 * group + 1) / 16.0;  // between those of group_samples.frag
    glDepthRange(depth, depth);
    if (group > 0 || first == First::on_top) glEnable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glDisable(GL_BLEND);
  glDepthRange(0, 1);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace brindle
