#include "brindle/render/surfaces/shading.h"

#include <algorithm>
#include <array>

#include "brindle/render/surfaces/gl_target.h"
#include "brindle/render/surfaces/tiled_picture.h"

namespace brindle {
namespace {

constexpr int kMostGroups = VisibleTriangles::kSamples * VisibleTriangles::kSamples;

/// The first, and one for all others: few pixels show three surface parts.
constexpr int kInteractiveGroups = 2;

/// Texture units after those of GlSurface.
enum ShadingUnit : GLuint { kGroupUnit = 12, kSurroundingsUnit = 14 };

constexpr float kOcclusionReach = 0.11f;  // of the surfaces' diagonal

constexpr const char* kNoPattern =
    "bool pattern_at(inout vec3 surface, SurfacePoint p) { return true; }\n";
constexpr const char* kWholePattern =
    "bool pattern_at(inout vec3 surface, SurfacePoint p) {\n"
    "  surface = with_pattern(surface, p);\n"
    "  return true;\n"
    "}\n";

/// Adjacent triangles look alike along their edge, unless colours or normals are per triangle.
bool has_distinct_triangles(const GlSurface& surface) {
  return surface.has_triangle_colors() || !surface.has_normals();
}

/// The lower left corner and size of the box in a target of `size` pixels. The whole target if the
/// box reaches behind the camera.
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

/// Groups of samples that are shaded per pixel at this quality.
int group_count(const GlSurface& surface, PictureQuality quality) {
  const bool few = quality == PictureQuality::interactive && !has_distinct_triangles(surface);
  return few ? kInteractiveGroups : kMostGroups;
}

/// Shader sources of the pattern: `pattern_at` changes the surface colour at a point, and returns
/// false if another pass over the texture's regions draws it.
ShaderSources pattern_sources(const DrawnSurface& drawn) {
  const ShaderSources tile{"texture_tile.glsl", "broken_tiles.glsl"};
  if (drawn.style && drawn.style->regions() > 0) return {tile[0], tile[1], "region_texture.glsl"};
  if (drawn.style) return {"stripe_coverage.glsl", "strokes.glsl"};
  if (drawn.surface.has_texture()) {
    return {tile[0], tile[1], "texture_pattern.glsl", {"pattern", kWholePattern}};
  }
  if (drawn.surface.has_waves()) {
    return {"stripe_coverage.glsl", "stripe_pattern.glsl", {"pattern", kWholePattern}};
  }
  return {{"pattern", kNoPattern}};
}

/// GLSL constants for the features in use. Software renderers execute both sides of a branch, so
/// every combination has its own program.
std::string features_of(const DrawnSurface& drawn, const StyledOptions& options) {
  const DepthCue cue = drawn.tinted ? options.depth_cue : DepthCue::none;
  return (drawn.style ? drawn.style->features()
                      : glsl_constant("kSurfacePlaces", false) +
                            glsl_constant("kWholeTiles", drawn.surface.has_broken_tiles())) +
         glsl_constant("kTriangleColors", drawn.surface.has_triangle_colors()) +
         glsl_constant("kOcclusion", options.occlusion > 0) +
         "const int kDepthCue = " + std::to_string(static_cast<int>(cue)) + ";\n";
}

}  // namespace

const ShaderProgram& Shading::program_for(const DrawnSurface& drawn, const StyledOptions& options) {
  const std::string features = features_of(drawn, options);
  const ShaderSources pattern = pattern_sources(drawn);
  std::string key = features;
  for (const ShaderSource& source : pattern) key += std::string(source.name) + "\n";
  if (const auto made = programs_.find(key); made != programs_.end()) return made->second;
  ShaderSources sources{{"features", features}, "surface_buffers.glsl", "surface_point.glsl",
                        "fragment_phase.glsl",  "light.glsl",           "picture_light.glsl",
                        "style_buffers.glsl"};
  sources.insert(sources.end(), pattern.begin(), pattern.end());
  sources.insert(sources.end(), {"visible_samples.glsl", "occlusion.glsl", "shade.frag"});
  return programs_.try_emplace(std::move(key), ShaderSources{"full_screen.vert"}, sources)
      .first->second;
}

/// Writes the number of sample groups of each pixel as a depth, so that a depth test skips pixels
/// without shading them.
void Shading::group_samples(const DrawnSurface& drawn, const VisibleSamples& seen,
                            const PictureScene& scene, const PicturePart& part,
                            const Target& light) {
  fit_target(groups_, {GL_R8UI}, true, light.width, light.height);
  part_ = seen_part(drawn.surface.box(), scene.camera, part.transform, part.size);
  seen.bind(group_);
  set_camera(group_, scene.camera, part.transform);
  group_.set("first_number", drawn.first_number);
  group_.set("triangle_count", static_cast<int>(drawn.surface.triangle_count()));
  group_.set("target_size", Eigen::Vector2f(part.size.cast<float>()));
  group_.set("distinct_triangles", has_distinct_triangles(drawn.surface));
  glScissor(part_[0], part_[1], part_[2], part_[3]);
  glEnable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, groups_.framebuffer);
  glViewport(0, 0, part.size.x(), part.size.y());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  fill_viewport(group_, no_attributes_);
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
}

/// Shades `count` groups one after the other, each over the pixels that have one.
void Shading::shade_groups(const ShaderProgram& program, const Target& light, int count,
                           Light first) {
  program.set("groups", static_cast<int>(kGroupUnit));
  program.set("last_group", count - 1);
  glBindTextureUnit(kGroupUnit, groups_.textures[0]);
  glNamedFramebufferTexture(light.framebuffer, GL_DEPTH_ATTACHMENT, groups_.textures[1], 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light.framebuffer);
  glScissor(part_[0], part_[1], part_[2], part_[3]);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_FALSE);
  glBlendFunc(GL_ONE, GL_ONE);
  for (int group = 0; group < count; ++group) {
    program.set("group", group);
    const double depth = 1 - (2 * group + 1) / 16.0;  // between those of group_samples.frag
    glDepthRange(depth, depth);
    if (group > 0 || first == Light::added) glEnable(GL_BLEND);
    fill_viewport(program, no_attributes_);
  }
  glDisable(GL_BLEND);
  glDepthRange(0, 1);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
}

/// Sets the uniforms of the picture and the surface.
void Shading::set_scene(const ShaderProgram& program, const DrawnSurface& drawn,
                        const VisibleSamples& seen, const PictureScene& scene,
                        const PicturePart& part) const {
  const StyledOptions& options = scene.options;
  program.set("target_size", Eigen::Vector2f(part.size.cast<float>()));
  program.set("first_number", drawn.first_number);
  program.set("triangle_count", static_cast<int>(drawn.surface.triangle_count()));
  set_light(program, scene.camera, options.render);
  seen.bind(program);
  drawn.surface.bind(program, scene.camera, part.transform);
  if (!drawn.style) return set_looks(program, options.render);
  drawn.style->bind(program, shading_side(options.render));
  if (!options.render.shading) program.set("shading", false);
  glBindTextureUnit(kColorMapUnit, scene.color_map);
  program.set("has_threshold", options.scale.threshold.has_value());
  program.set("threshold", options.scale.threshold.value_or(0.0f));
  program.set("beyond_color", linear_light(options.scale.beyond));
  program.set("depth_range", scene.depths);
  program.set("haze_color", linear_light(options.render.background_center));
  program.set("occlusion", options.occlusion);
  program.set("occlusion_radius", kOcclusionReach * scene.diagonal);
  program.set("target_corner", Eigen::Vector2f(part.corner.cast<float>()));
  program.set("has_surroundings", scene.surroundings != nullptr);
  program.set("depths_of_picture", static_cast<int>(kSurroundingsUnit));
  if (scene.surroundings) {
    glBindTextureUnit(kSurroundingsUnit, scene.surroundings->target.textures[1]);
  }
  const Eigen::Vector2f samples = (VisibleTriangles::kSamples * part.size).cast<float>();
  program.set("part_of_target", Eigen::Vector2f(samples.cwiseQuotient(
                                    Eigen::Vector2f(seen.target.width, seen.target.height))));
}

void Shading::draw(const DrawnSurface& drawn, const VisibleSamples& seen, const PictureScene& scene,
                   const PicturePart& part, const Target& light, Light first) {
  const ShaderProgram& program = program_for(drawn, scene.options);
  group_samples(drawn, seen, scene, part, light);
  set_scene(program, drawn, seen, scene, part);
  const int count = group_count(drawn.surface, scene.options.render.quality);
  if (!drawn.style || drawn.style->regions() == 0) {
    return shade_groups(program, light, count, first);
  }
  for (std::size_t region = 0; region < drawn.style->regions(); ++region) {
    drawn.style->bind_region(program, region);
    shade_groups(program, light, count, region == 0 ? first : Light::added);
  }
}

namespace {

constexpr int kShadowSide = GroundShadow::kSide;
using Grid = std::vector<float>;

float cross_of(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Marks the cells whose middle the triangle covers, and the cells of its corners.
void cover_cells(const std::array<Eigen::Vector2f, 3>& corners, Grid& grid) {
  const Eigen::Vector2f lower = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Eigen::Vector2f upper = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const auto cell = [](float place) {
    return std::clamp(static_cast<int>(place), 0, kShadowSide - 1);
  };
  const auto at = [&](int x, int y) -> float& {
    return grid[static_cast<std::size_t>(y) * kShadowSide + static_cast<std::size_t>(x)];
  };
  for (const Eigen::Vector2f& corner : corners) at(cell(corner.x()), cell(corner.y())) = 1;
  const float area = cross_of(corners[1] - corners[0], corners[2] - corners[0]);
  if (area == 0) return;
  for (int y = cell(lower.y()); y <= cell(upper.y()); ++y) {
    for (int x = cell(lower.x()); x <= cell(upper.x()); ++x) {
      const Eigen::Vector2f middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const float u = cross_of(corners[1] - middle, corners[2] - middle) / area;
      const float v = cross_of(corners[2] - middle, corners[0] - middle) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) at(x, y) = 1;
    }
  }
}

/// Three box filters of 2 `radius` + 1 cells along x and y: nearly Gaussian.
void blur(Grid& grid, int radius) {
  Grid line(kShadowSide);
  for (int pass = 0; pass < 6; ++pass) {
    const std::size_t step = pass % 2 == 0 ? 1 : kShadowSide;
    const std::size_t stride = pass % 2 == 0 ? kShadowSide : 1;
    for (std::size_t row = 0; row < kShadowSide; ++row) {
      for (int i = 0; i < kShadowSide; ++i) {
        float sum = 0;
        for (int k = std::max(0, i - radius); k <= std::min(kShadowSide - 1, i + radius); ++k) {
          sum += grid[row * stride + static_cast<std::size_t>(k) * step];
        }
        line[static_cast<std::size_t>(i)] = sum / static_cast<float>(2 * radius + 1);
      }
      for (std::size_t i = 0; i < kShadowSide; ++i) grid[row * stride + i * step] = line[i];
    }
  }
}

}  // namespace

Mesh left_by(const Eigen::Hyperplane<float, 3>& slice, const Mesh& mesh) {
  Mesh left;
  left.origin = mesh.origin;
  left.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles) {
    // The kept corners and the intersections with the plane, in winding order.
    std::vector<Index> corners;
    for (std::size_t m = 0; m < 3; ++m) {
      const Vec3 &a = mesh.positions[t[m]], &b = mesh.positions[t[(m + 1) % 3]];
      const float from = slice.signedDistance(a), to = slice.signedDistance(b);
      if (from <= 0) corners.push_back(t[m]);
      if ((from <= 0) == (to <= 0)) continue;
      corners.push_back(static_cast<Index>(left.positions.size()));
      left.positions.push_back(a + from / (from - to) * (b - a));
    }
    for (std::size_t m = 2; m < corners.size(); ++m) {
      left.triangles.push_back({corners[0], corners[m - 1], corners[m]});
    }
  }
  return left;
}

GroundShadow ground_shadow(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const Eigen::Matrix3f& axes) {
  constexpr float kRoom = 0.3f;  // of the longer side
  GroundShadow shadow;
  if (points.empty()) return shadow;
  std::vector<Vec3> places;
  Vec3 lower = axes.transpose() * points[0], upper = lower;
  for (const Vec3& point : points) {
    places.push_back(axes.transpose() * point);
    lower = lower.cwiseMin(places.back());
    upper = upper.cwiseMax(places.back());
  }
  const float side = std::max((upper - lower).head<2>().maxCoeff(), 1e-6f);
  shadow.size = Eigen::Vector2f::Constant(side * (1 + 2 * kRoom));
  shadow.lower = 0.5f * (lower + upper).head<2>() - 0.5f * shadow.size;
  shadow.height = lower.z();
  // Parts near the ground cast a sharper and darker shadow.
  const float near = lower.z() + 0.18f * (upper.z() - lower.z());
  Grid all(static_cast<std::size_t>(kShadowSide) * kShadowSide), close = all;
  const float scale = kShadowSide / shadow.size.x();
  for (const Triangle& t : triangles) {
    std::array<Eigen::Vector2f, 3> corners;
    float lowest = places[t[0]].z();
    for (std::size_t m = 0; m < 3; ++m) {
      corners[m] = scale * (places[t[m]].head<2>() - shadow.lower);
      lowest = std::min(lowest, places[t[m]].z());
    }
    cover_cells(corners, all);
    if (lowest < near) cover_cells(corners, close);
  }
  blur(all, 9);
  blur(close, 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    shadow.missing.push_back(0.30f * all[i] + 0.38f * close[i]);
  }
  return shadow;
}

}  // namespace brindle
